#pragma once

#include <cstddef>
#include <span>

#include "shading/irradiance.h"

namespace gnomon {

/// The sum of what several lights give to one receiver. Infinite, with an infinite bound, where one of them is.
Irradiance total_irradiance(std::span<const Irradiance> parts);

/// Mean, least and largest of many irradiances, each with a bound of its error.
///
/// Exactness: the bounds hold for mean, least and largest of the exact values, roundings of this class included.
/// Degenerate: infinite values make the mean and the largest infinite, with infinite bounds.
class IrradianceSummary {
 public:
  void add(const Irradiance& irradiance);

  std::size_t count() const { return count_; }

  /// Requires: count() > 0.
  Irradiance mean() const;
  Irradiance least() const;
  Irradiance largest() const;

 private:
  std::size_t count_ = 0;
  Irradiance sum_;
  double least_ = 0, least_low_ = 0, least_high_ = 0;        ///< the exact least lies from low to high
  double largest_ = 0, largest_low_ = 0, largest_high_ = 0;  ///< the exact largest likewise
};

}  // namespace gnomon
