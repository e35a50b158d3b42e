#pragma once

#include <vector>

#include "apps/proof/laws/mutants.h"

namespace gnomon::laws {

/// Mistakes in discontinuities and in what they divide; all_mutants() has them too.
std::vector<Mutant> event_mutants();

}  // namespace gnomon::laws
