#pragma once

#include "geometry/planar/sight.h"

namespace gnomon {

/// A point of a receiver of the plane; the normal points to its front, its length means nothing.
struct PlanarReceiverPoint {
  Point2 point;
  Point2 normal;
};

/// Irradiance with a bound of |value - exact|.
struct BoundedIrradiance {
  double value = 0;
  double error = 0;
};

/// The irradiance of a point in flatland: radiance times the integral of cos(angle to the normal) over the angles under
/// which the light is seen, clipped by the receiver's horizon. A light all around the horizon gives 2 * radiance.
///
/// Definition: the sum, over the visible intervals, of the difference of the sines of their ends' angles to the normal.
/// Requires:   a linear light; the normal is not zero, all numbers are finite.
/// Degenerate: 0 on the light's line, where the light is seen under no angle.
/// Exactness:  what is visible and what is above the horizon is decided exactly; the sum is enclosed by intervals.
/// Units:      those of `radiance` times radian.
/// Throws:     PreconditionError.
/// After:      [P93] §4.2.2.
BoundedIrradiance planar_irradiance(const planar::Sight& sight, const PlanarReceiverPoint& receiver,
                                    double radiance = 1);

}  // namespace gnomon
