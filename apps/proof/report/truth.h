#pragma once

#include "gnomon/light.h"
#include "gnomon/names.h"
#include "gnomon/visibility.h"

namespace gnomon::report {

/// An interval that holds a true value.
struct TrueValue {
  double low = 0;
  double high = 0;

  /// How far a value is off: its distance from the middle.
  double error_of(double value) const;

  /// False if the true value surely is farther than the bound from the value.
  bool is_within(double value, double bound) const;
};

/// What is true of a point before an area light.
struct VisibilityTruth {
  Region region = Region::lit;
  TrueValue fraction;
  TrueValue irradiance;  ///< of radiance 1
};

/// The truth: the visible part in rational numbers, and the sum over its edges in intervals of that many bits.
///
/// Exactness: the intervals are rounded outwards to doubles.
VisibilityTruth visibility_truth(const AreaLight& light, const Obstacles& obstacles, const Point3& p,
                                 const Point3& normal, int bits);

/// The irradiance alone.
TrueValue true_irradiance(const AreaLight& light, const Obstacles& obstacles, const Point3& p, const Point3& normal,
                          int bits);

}  // namespace gnomon::report
