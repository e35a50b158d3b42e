#pragma once

#include <optional>

#include "geometry/visibility/light_visibility.h"
#include "shading/irradiance.h"

namespace gnomon {

/// The irradiance that one light gives to receivers behind obstacles.
///
/// Definition: what is visible of the light before the receiver (exact_received), above its horizon: lambert_irradiance
/// for
///             area lights, the integral of cosine over squared distance for linear and point lights, the cosine for
///             directional ones; times the light's strength.
/// Degenerate: infinite at a visible point of a point or linear light. Positive exactly where exact_received says lit
/// or
///             penumbra, if the strength is.
/// Exactness:  with an error bound. What is visible is exact; where the fast level does not decide, or has no bound
///             below 1e-6 of the strength, the exact level makes the polygons.
/// Cost:       memory is kept for the next question, so one object per thread.
class LightIrradiance {
 public:
  /// `strength` is radiance [W/(m² sr)], intensity per length [W/(sr m)], intensity [W/sr] or irradiance [W/m²] of an
  /// area, linear, point or directional light, and not negative.
  LightIrradiance(Light light, double strength, PreparedObstacles obstacles);

  /// Requires: finite coordinates, a normal that is not zero.
  /// Throws:   PreconditionError for a normal without direction.
  Irradiance at(const Point3& p, const Point3& normal);

  /// The same of a receiver's point whose front is given otherwise, as a facet's plane; `normal` is then that of the
  /// facet up to rounding, and gives the cosines.
  Irradiance received(const ReceiverPoint& receiver, const Point3& normal);

 private:
  std::optional<Irradiance> fast_answer(const ReceiverPoint& receiver, const Point3& normal);
  Irradiance exact_answer(const ReceiverPoint& receiver, const Point3& normal) const;

  Light light_;
  double strength_;
  PreparedObstacles obstacles_;
  FastLevel fast_;
};

}  // namespace gnomon
