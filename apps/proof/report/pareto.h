#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/proof/report/measurement.h"

namespace gnomon::report {

/// The measurements than which no other is both faster and more exact, fastest first.
///
/// Requires: measurements of one task and size.
std::vector<Measurement> pareto_front(std::span<const Measurement> measurements);

/// How many points on the light cost as much as one answer of gnomon, and how wrong the answer from so many is.
struct Equivalent {
  std::string task;
  std::string method;  ///< that samples the light
  std::size_t size = 0;
  double samples = 0;  ///< from those measured, on logarithmic scales
  double rms = 0;      ///< the same; beyond those measured, that of the nearest
};

/// For every task and size that gnomon and a sampling method were both measured in.
/// After: [P93] Table I.
std::vector<Equivalent> equivalents(std::span<const Measurement> measurements);

/// What errors are shares of: of each result's own true value, which the faintest results decide, or of the largest
/// true value, which an image or a study of lighting asks for.
enum class ErrorScale { own_value, largest_value };

/// The time that a sampling method takes for such errors, in the root mean square, from those measured, on logarithmic
/// scales; `like` tells task, method and size. Nothing if it was not measured twice.
std::optional<double> seconds_for_error(std::span<const Measurement> measurements, const Measurement& like,
                                        ErrorScale scale, double wanted);

}  // namespace gnomon::report
