#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "apps/proof/report/hard_cases.h"
#include "apps/proof/report/stopwatch.h"
#include "apps/proof/report/visibility_tasks.h"
#include "gnomon/irradiance.h"
#include "gnomon/visibility.h"

namespace gnomon::report {

/// What came of a hard case.
struct HardCaseResult {
  std::string name;
  std::string about;
  Visibility focus;                      ///< what gnomon says of the focus
  Irradiance irradiance;                 ///< there, of radiance 1
  bool irradiance_is_right = false;      ///< within its bound
  std::size_t points = 0;                ///< around it, the focus among them
  std::array<std::size_t, 4> regions{};  ///< how many points truly lie in each region, in the order of Region
  std::size_t wrong_doubles = 0;         ///< points whose region the plain doubles get wrong,
  std::size_t wrong_embree = 0;          ///< floats and 256 shadow rays,
  std::size_t wrong_gnomon = 0;          ///< and gnomon
  std::size_t outside_bound = 0;         ///< points whose fraction is farther off than gnomon claims
  double most_error = 0;                 ///< of gnomon's fraction
  double most_bound = 0;                 ///< that it claims
  std::size_t exact_answers = 0;         ///< of gnomon, that had to come from the exact level
  Seconds seconds;                       ///< per answer of gnomon
};

/// Tries 10,000 points of a hard case, or 200, against the exact level.
/// Cost: the exact level answers on all processors.
HardCaseResult hard_case_trial(const HardCase& hard, Effort effort);

}  // namespace gnomon::report
