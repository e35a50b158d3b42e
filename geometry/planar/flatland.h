#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace gnomon::planar {

/// An opaque closed segment of the plane.
using BlockerSegment = std::array<Point2, 2>;

/// One point or linear light among any number of segment blockers, which may touch, cross and overlap each other and
/// the light, and lie on its line.
///
/// Blockers are named by their place in the list given, their ends 0 and 1, the light's ends 0 and 1. A point light has
/// the end 0 alone. Lights of the plane have no back.
class Flatland {
 public:
  /// Requires: one or two light points; the two points of a segment differ; all are finite.
  /// Throws:   PreconditionError.
  static Flatland from_points(std::span<const Point2> light, std::span<const BlockerSegment> blockers);

  bool has_point_light() const { return light_size_ == 1; }

  /// The ends of the light: one or two points.
  std::span<const Point2> light() const { return {light_.data(), light_size_}; }

  const std::vector<BlockerSegment>& blockers() const { return blockers_; }

 private:
  Flatland() = default;

  std::array<Point2, 2> light_{};
  std::uint32_t light_size_ = 1;
  std::vector<BlockerSegment> blockers_;
};

/// The segments of a polyline, in order.
///
/// Requires: at least two points, consecutive ones different.
std::vector<BlockerSegment> segments_of_polyline(std::span<const Point2> polyline);

/// What a point that makes an event is.
enum class EventPointKind : std::uint8_t {
  light_end,    ///< end `end` of the light
  blocker_end,  ///< end `end` of blocker `element`
  crossing,     ///< where blocker `element` crosses the light's line, off its own ends
  viewpoint,    ///< the point that looks, on the light itself
};

/// A point named by input elements. What does not apply is 0.
/// Degenerate: ends of blockers in one place bear the name of the first, a crossing that of what lies in its place.
struct EventPoint {
  EventPointKind kind = EventPointKind::light_end;
  std::uint32_t element = 0;
  std::uint32_t end = 0;

  // clang-tidy 14 takes the zero that the order is compared with for a pointer.
  friend auto operator<=>(const EventPoint&, const EventPoint&) = default;  // NOLINT(modernize-use-nullptr)
};

}  // namespace gnomon::planar
