#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/planar/partition.h"

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
std::vector<ReceiverEvent> receiver_events(const Sight& sight, const std::array<Point2, 2>& receiver);

}  // namespace gnomon::planar
