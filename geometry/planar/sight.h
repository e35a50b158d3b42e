#pragma once

#include <array>
#include <vector>

#include "geometry/exact_number.h"
#include "geometry/planar/flatland.h"
#include "geometry/region.h"

namespace gnomon::planar {

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
class Sight {
 public:
  explicit Sight(Flatland flatland);

  const Flatland& flatland() const { return flatland_; }

  /// What the point sees of the light.
  VisibleLight visible_light(const Point2& point) const;

  /// The region of the point.
  Region region(const Point2& point) const { return visible_light(point).region; }

  /// The share of the light that the point sees, by length; of a point light 0 or 1.
  ExactNumber exact_fraction(const Point2& point) const;

 private:
  friend class SightQuery;

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
