#pragma once

/// @file
/// The plane: where along a receiver the light changes, and how much arrives.
///
///     #include <gnomon/flatland_receiver.h>
///     int main() {
///       using namespace gnomon;
///       const Point2 light[] = {{-2, 4}, {2, 4}};
///       const planar::BlockerSegment wall = {{{-1, 2}, {1, 2}}};
///       const planar::LightVisibility visibility(planar::Flatland::from_points(light, {&wall, 1}));
///       const auto events = planar::receiver_events(visibility, {{{-9, 1}, {9, 1}}});
///       return events.size() == 4 && planar_irradiance(visibility, {{3, 1}, {0, 1}}).value > 0 ? 0 : 1;
///     }

#include <array>
#include <cstdint>
#include <vector>

#include "gnomon/flatland.h"
#include "gnomon/flatland_partition.h"

namespace gnomon::planar {

/// The lowest derivative of the visible fraction, and of the irradiance, that jumps.
enum class Discontinuity : std::uint8_t {
  d0,  ///< the value itself: the receiver meets a blocker whose sides hide different measures
  d1,  ///< the first derivative: what is visible changes its formula
};

/// A point of a receiver at which what is visible of the light changes.
struct ReceiverEvent {
  double place = 0;  ///< along the receiver, from 0 at its first end to 1; the exact place, rounded to nearest
  Discontinuity order = Discontinuity::d1;
  BoundaryName name;  ///< what the receiver crosses there; of several the first by kind, then by element
};

/// The events strictly between a receiver's ends, in order.
///
/// Definition: points beside which the named visible intervals differ from one side to the other.
/// Requires:   a linear light; the receiver's ends differ.
/// Degenerate: a receiver along a blocker or an event line is asked for its own points, not for a limit from its front.
/// Exactness:  all decisions are exact.
/// Throws:     PreconditionError.
/// After:      [P93] §4.2.3.2.
std::vector<ReceiverEvent> receiver_events(const LightVisibility& visibility, const std::array<Point2, 2>& receiver);

}  // namespace gnomon::planar

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
BoundedIrradiance planar_irradiance(const planar::LightVisibility& visibility, const PlanarReceiverPoint& receiver,
                                    double radiance = 1);

}  // namespace gnomon
