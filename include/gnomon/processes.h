#pragma once

/// @file
/// Processes that share the work of one task, each with all of the scene.
///
///     #include <gnomon/processes.h>
///     int main() {
///       const gnomon::Processes alone;  // what every task takes by default
///       return alone.count == 1 && alone.is_mine(7) ? 0 : 1;
///     }

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace gnomon {

/// Processes that were started together, as by mpirun, and all call the same functions with the same input.
///
/// Part i of a task is done by process i mod count, and all results are given to all processes; so what a function
/// returns is the same in each of them, and the same as in one process alone.
struct Processes {
  std::uint32_t number = 0;  ///< of this process, below `count`
  std::uint32_t count = 1;
  /// Gives every process the texts, of any bytes, of all of them, by number. All processes call it equally often, each
  /// from one thread. Needed where there are several processes.
  std::function<std::vector<std::string>(const std::string& mine)> exchange = {};

  bool is_mine(std::size_t part) const { return part % count == number; }
};

}  // namespace gnomon
