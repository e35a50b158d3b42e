#pragma once

/// The boundary of what is visible, edge by edge. Private to this folder.

#include <cstdint>
#include <vector>

#include "geometry/visibility/outline.h"

namespace gnomon::sight {

/// A point of the edge that is walked: one of its ends, or where it crosses a plane. Planes and rays by their indices
/// in the outlines.
struct Station {
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  enum class Kind : std::uint8_t { start, inner, end };
  Kind kind = Kind::start;
  bool rising = false;          ///< inner: the walk comes to the plane's positive side
  std::uint32_t plane = none;   ///< inner: the plane crossed
  std::uint32_t vertex = none;  ///< inner: the ray through an input point that lies there, if there is one
};

/// A part of the edge that is walked, from one station to a later one.
struct Stretch {
  Station from;
  Station to;
};

/// The edge that is walked: an outline's k-th, in its plane k from its ray k to the next. By indices: of the outline,
/// and of the plane and the two rays among those of all outlines.
struct Edge {
  std::uint32_t outline = 0;
  std::uint32_t plane = 0;
  std::uint32_t start = 0;
  std::uint32_t end = 0;

  /// The visible part lies left of a light's edge and right of a blocker's.
  bool of_light() const { return outline == 0; }
};

/// The ray of an input point that lies at the station, or Station::none.
inline std::uint32_t ray_at(const Edge& edge, const Station& station) {
  return station.kind == Station::Kind::start ? edge.start
         : station.kind == Station::Kind::end ? edge.end
                                              : station.vertex;
}

inline Edge edge_of(const Outlines& outlines, std::uint32_t outline, std::uint32_t k) {
  const Outline& o = outlines.list[outline];
  return {outline, o.first + k, o.first + k, o.first + o.after(k)};
}

/// A piece of the visible part's boundary, on which one edge is not covered.
struct Piece {
  Edge edge;
  Stretch stretch;
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
  bool stretch_inside(const Edge& edge, std::uint32_t outline, Alongside alongside, Stretch& result);

  /// Appends the parts of `whole` that none of the covers holds, in order; `covers` is sorted.
  /// Returns: true if there was one.
  bool append_uncovered(const Piece& whole, std::vector<Stretch>& covers, std::vector<Piece>& pieces) const;

  /// -1, 0, +1: which of two stations of the edge comes first.
  int order(const Edge& edge, const Station& a, const Station& b) const;

 private:
  const std::int8_t* sides_at(const Edge& edge, std::uint32_t outline);
  bool chord(const Edge& edge, std::uint32_t outline, Alongside alongside, Stretch& result);
  static bool alongside_chord(const Outline& outline, const std::int8_t* sides, Alongside alongside, Stretch& result);
  int side_of_end(std::uint32_t outline, std::uint32_t plane, const Edge& edge, std::uint32_t ray) const;
  bool clamp(const Edge& edge, std::uint32_t outline, Stretch& chord) const;
  int side_at(std::uint32_t plane, std::uint32_t ray) const {
    return side(apex_, outlines_.planes[plane], outlines_.rays[ray]);
  }

  Point3 apex_;
  const Outlines& outlines_;
  std::vector<std::int8_t> sides_;  ///< of the outline's rays at the edge's plane
};

}  // namespace gnomon::sight
