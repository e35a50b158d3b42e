#pragma once

#include "apps/gnomon/commands.h"
#include "gnomon/processes.h"

namespace gnomon {

/// The processes that mpirun started, this one among them; one where it did not. Of several only the first is heard:
/// what the others print goes nowhere.
///
/// Throws: UnsupportedError if there are several and this program was built without MPI.
const Processes& started_processes();

/// True of the process that writes results.
bool is_first_process();

/// To be called at the end of each process that has called started_processes. Where one has failed by itself the others
/// hear of it, wherever they wait for it, and fail too.
///
/// Returns: the exit code.
ExitCode end_processes(ExitCode code);

}  // namespace gnomon
