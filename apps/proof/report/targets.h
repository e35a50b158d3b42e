#pragma once

#include <string>
#include <vector>

#include "apps/proof/report/report.h"

namespace gnomon::report {

/// Something that the project wants to reach, and what was measured.
struct Finding {
  std::string subject;
  std::string wanted;
  std::string found;  ///< empty if this run did not measure it
  bool reached = false;
  bool is_promise = false;  ///< it holds on every machine; if it is missed, gnomon is wrong
  std::string command;      ///< what else measures it; empty for a promise

  bool is_measured() const { return !found.empty(); }
};

/// Every target of the project's benchmarks: times, times beside other methods, growth, memory, no wrong answer; those
/// that this run measured, or the others.
std::vector<Finding> findings(const Report& report);
std::vector<Finding> unmeasured(const Report& report);

}  // namespace gnomon::report
