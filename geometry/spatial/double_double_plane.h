#pragma once

#include <array>
#include <optional>

#include "geometry/numbers/double_double.h"
#include "geometry/spatial/exact_space.h"

namespace gnomon {

/// The coefficients of a plane as double-double numbers, each with a bound of its error: normal x + offset = 0.
struct DoubleDoublePlane {
  /// Bounds: see the source. Of planes that are not given by points or an axis the bound is infinite.
  explicit DoubleDoublePlane(const PlaneDefinition& plane);

  std::array<Halves, 3> normal;
  std::array<double, 3> normal_low{};
  std::array<double, 3> normal_error{};
  DoubleDouble offset;
  double offset_error = 0;
  double normal_defect = 0;  ///< how far rounding and low parts take the product of the normal and a vector of ones
};

/// Finds the point that three planes have in common.
///
/// Definition: an approximate inverse M of the matrix N of the normals takes an approximate point x, of which the
///             planes tell the exact heights r, to x - M r. Whatever M is, the common point is x + d with
///             d = -M r + (I - M N) d; so |I - M N| bounds the error.
/// After:      Newton's method with a certificate, as in verified linear systems.
class CommonPoint {
 public:
  CommonPoint(const DoubleDoublePlane& a, const DoubleDoublePlane& b, const DoubleDoublePlane& c);

  /// The point correctly rounded, found from one nearby; nothing if the bounds do not decide.
  std::optional<Point3> rounded(const Point3& nearby) const;

 private:
  using Triple = std::array<double, 3>;
  struct Step {
    Triple length;
    Triple error;
  };
  Step step_from(const std::array<Halves, 3>& x) const;

  std::array<const DoubleDoublePlane*, 3> planes_;
  std::array<Triple, 3> inverse_;
  Triple defect_;  ///< bounds of the row sums of |I - M N|
};

}  // namespace gnomon
