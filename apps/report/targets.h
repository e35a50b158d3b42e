#pragma once

#include <string>
#include <vector>

#include "apps/report/report.h"

namespace gnomon::report {

/// Something that the project wants to reach, and what was measured.
struct Finding {
  std::string subject;
  std::string wanted;
  std::string found;
  bool reached = false;
  bool is_promise = false;  ///< it holds on every machine; if it is missed, gnomon is wrong
};

/// Every target that the report has figures for: times, times beside other methods, no wrong answer.
std::vector<Finding> findings(const Report& report);

}  // namespace gnomon::report
