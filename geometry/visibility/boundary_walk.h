#pragma once

/// The boundary of what is visible, edge by edge. Private to this folder.

#include <cstdint>
#include <vector>

#include "geometry/visibility/outline.h"

namespace gnomon::sight {

/// A point of the edge that is walked: one of its ends, or where it crosses a plane.
struct Station {
  enum class Kind { start, inner, end };
  Kind kind = Kind::start;
  const Plane* plane = nullptr;  ///< inner: the plane crossed
  bool rising = false;           ///< inner: the walk comes to the plane's positive side
  const Ray* vertex = nullptr;   ///< inner: the input point that lies there, if there is one
};

/// A part of the edge that is walked, from one station to a later one.
struct Stretch {
  Station from;
  Station to;
};

/// The edge that is walked: in `plane`, from ray `start` to ray `end`.
struct Edge {
  const Plane* plane = nullptr;
  const Ray* start = nullptr;
  const Ray* end = nullptr;
  bool ahead = true;  ///< both rays certainly run towards the light's plane
};

/// A piece of the visible part's boundary, on which one edge is not covered.
struct Piece {
  Edge edge;
  Stretch stretch;
  const Outline* outline = nullptr;  ///< whose edge it is
  bool of_light = false;             ///< the visible part lies left of a light's edge and right of a blocker's
};

/// What counts as covered where an edge of another outline runs along the walked one.
enum class Alongside { nothing, same_side, other_side, either_side };

/// Walks edges past outlines.
///
/// Exactness: every order and every side is exact; doubles decide where their bound allows, exact arithmetic elsewhere.
class BoundaryWalk {
 public:
  BoundaryWalk(const Point3& apex, const Outlines& outlines) : apex_(apex), outlines_(outlines) {}

  /// The part of the edge inside the outline; true if it has positive length.
  /// Degenerate: where an edge of the outline runs along, `alongside` says on which side of it the outline must lie.
  bool stretch_inside(const Edge& edge, const Outline& outline, Alongside alongside, Stretch& result);

  /// Appends the parts of `whole` that none of the covers holds, in order; `covers` is sorted.
  /// Returns: true if there was one.
  bool append_uncovered(const Piece& whole, std::vector<Stretch>& covers, std::vector<Piece>& pieces) const;

  /// -1, 0, +1: which of two stations of the edge comes first.
  int order(const Edge& edge, const Station& a, const Station& b) const;

 private:
  bool chord(const Edge& edge, const Outline& outline, Alongside alongside, Stretch& result);
  bool alongside_chord(const Outline& outline, Alongside alongside, Stretch& result) const;
  bool clamp(const Edge& edge, Stretch& chord) const;

  Point3 apex_;
  const Outlines& outlines_;
  std::vector<int> signs_;  ///< of the outline's rays at the edge's plane
};

}  // namespace gnomon::sight
