#pragma once

/// @file
/// The plane: what points see of one light behind many segments.
///
///     #include <gnomon/flatland.h>
///     int main() {
///       using namespace gnomon::planar;
///       const std::vector<gnomon::Point2> light = {{-3, 8}, {3, 8}};
///       const std::vector<BlockerSegment> walls = {{{{-4, 4}, {-0.25, 4}}}, {{{-0.5, 3}, {3.5, 3}}}};
///       const LightVisibility visibility(Flatland::from_points(light, walls));
///       return visibility.region({-0.375, 1}) == gnomon::Region::umbra && visibility.exact_fraction({9, 9}).exact ==
///       "1" ? 0 : 1;
///     }

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gnomon/names.h"
#include "gnomon/point.h"

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

/// An end of a visible interval: its name, and where it lies along the light as seen from the point.
struct IntervalEnd {
  EventPoint name;
  double t = 0;      ///< 0 at light end 0, 1 at light end 1
  double error = 0;  ///< bounds |t - exact|
};

/// A part of the light that is visible, up to single points. Orientation: from light end 0 toward light end 1.
struct VisibleInterval {
  IntervalEnd from;
  IntervalEnd to;
};

/// What a point sees of the light.
struct VisibleLight {
  Region region = Region::lit;
  /// In order along the light, with interior, disjoint. Of a visible point light: one, from light end 0 to itself.
  std::vector<VisibleInterval> intervals;
};

/// The visible fraction: a double and a bound on |fraction - exact|.
struct VisibleFraction {
  double value = 0;
  double error = 0;
};

VisibleFraction visible_fraction(const VisibleLight& seen);

/// The light as seen from any point: what the questions below share, prepared once.
///
/// Definition: a point is blocked from a point of the light if the open segment between them meets a blocker.
/// Degenerate: what hides a part of length zero of a linear light does not count; it hides a point light. A point on a
///             blocker is asked itself, not a limit from one side.
/// Exactness:  which ends bound the intervals, in which order, and the region: exact for every finite input.
/// Cost:       O(n) to prepare, O(n log n) for a point, less where much of the light is hidden.
class LightVisibility {
 public:
  explicit LightVisibility(Flatland flatland);

  const Flatland& flatland() const { return flatland_; }

  /// What the point sees of the light.
  VisibleLight visible_light(const Point2& point) const;

  /// The region of the point.
  Region region(const Point2& point) const { return visible_light(point).region; }

  /// The share of the light that the point sees, by length; of a point light 0 or 1.
  ExactNumber exact_fraction(const Point2& point) const;

 private:
  friend class VisibilityQuery;

  /// An end of a piece, relative to light end 0; heights are twice areas over the light, positive on the piece's side.
  struct End {
    Point2 point;  ///< the blocker's end; of a crossing, the end beyond the light's line
    EventPoint name;
    bool is_crossing = false;
    double x = 0;
    double y = 0;
    double height = 0;
    double height_error = 0;
    std::array<double, 2> t{};  ///< of a crossing: bounds of its place along the light
  };

  class CrossingNames;

  /// The part of a blocker on one side of the light's line. The blocker runs from the first end's point to the
  /// second's.
  using Piece = std::array<End, 2>;

  void add_pieces(std::uint32_t blocker, CrossingNames& names);
  End end_of(std::uint32_t blocker, std::uint32_t end, double side) const;
  End crossing_of(std::uint32_t blocker, std::uint32_t below, CrossingNames& names) const;

  Flatland flatland_;
  std::vector<std::array<EventPoint, 2>> names_;  ///< of the ends of every blocker
  std::array<std::vector<Piece>, 2> pieces_;      ///< left and right of the light
  std::vector<std::uint32_t> on_line_;            ///< blockers that meet the light's line
};

}  // namespace gnomon::planar
