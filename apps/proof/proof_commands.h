#pragma once

#include "apps/gnomon/commands.h"

namespace gnomon {

/// `gnomon theorems`: the statements of the theory, checked case by case; the false ones with counterexamples.
ExitCode theorems_command(Arguments arguments);

/// `gnomon report`: speed against error, and hard cases, with tables and plots.
ExitCode report_command(Arguments arguments);

}  // namespace gnomon
