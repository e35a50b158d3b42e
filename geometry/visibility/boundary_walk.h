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
  /// The memory is used as the walk needs it; its content is of no use to others.
  BoundaryWalk(const Point3& apex, const Outlines& outlines, std::vector<std::int8_t>& memory)
      : apex_(apex), outlines_(outlines), sides_(memory) {}

  /// The part of the edge inside the outline; true if it has positive length.
  /// Degenerate: where an edge of the outline runs along, `alongside` says on which side of it the outline must lie.
  bool stretch_inside(const Edge& edge, std::uint32_t outline, Alongside alongside, Stretch& result);

  /// Appends the parts of `whole` that none of the covers holds, in order; `covers` is sorted.
  /// Requires: `whole` has a positive length.
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
  std::vector<std::int8_t>& sides_;  ///< of the outline's rays at the edge's plane
};

inline Station station_at(std::uint32_t plane, bool rising, std::uint32_t vertex = Station::none) {
  return {Station::Kind::inner, rising, plane, vertex};
}

inline int risen(const Station& station, int sign) {
  return station.rising ? sign : -sign;
}

/// On which side of the edge's plane each ray of the outline runs.
inline const std::int8_t* BoundaryWalk::sides_at(const Edge& edge, std::uint32_t outline) {
  if (outline == 0) return outlines_.sides_of_light(edge.plane);
  const Outline& o = outlines_.list[outline];
  if (edge.of_light()) return outlines_.sides_at_pyramid(o, edge.plane);
  sides_.resize(o.count);
  for (std::uint32_t k = 0; k < o.count; ++k) sides_[k] = static_cast<std::int8_t>(side_at(edge.plane, o.first + k));
  return sides_.data();
}

/// Walking with the outline counterclockwise, one comes in where the outline's rays pass from left to right, and goes
/// out where they pass from right to left. A ray in the edge's plane belongs to the side of the ray before.
inline bool BoundaryWalk::chord(const Edge& edge, std::uint32_t outline, Alongside alongside, Stretch& result) {
  const Outline& o = outlines_.list[outline];
  const std::int8_t* sides = sides_at(edge, outline);
  bool crosses = false;
  int last = sides[o.count - 1];
  int passed = last == 0 ? sides[o.count - 2] : last;
  std::uint32_t k = o.count - 1;
  for (std::uint32_t next = 0; next < o.count; ++next) {
    const int now = sides[next];
    if (passed * now < 0) {
      crosses = true;
      (passed > 0 ? result.from : result.to) =
          station_at(o.first + k, passed > 0, last == 0 ? o.first + k : Station::none);
    }
    passed = now == 0 ? last : now;
    last = now;
    k = next;
  }
  return crosses || (alongside != Alongside::nothing && alongside_chord(o, sides, alongside, result));
}

/// On which side of a plane of the outline an end of the edge lies.
inline int BoundaryWalk::side_of_end(std::uint32_t outline, std::uint32_t plane, const Edge& edge,
                                     std::uint32_t ray) const {
  if (edge.of_light()) return outlines_.sides_of_light(plane)[ray];
  const Outline& o = outlines_.list[edge.outline];
  return outline == 0 ? outlines_.sides_at_pyramid(o, plane)[ray - o.first] : side_at(plane, ray);
}

/// In the edge's plane the outline is the sector, of less than half a turn, from the ray on its first plane to the ray
/// on its last; the edge is another. Half a turn on, each plane's line is crossed the other way: such a crossing bounds
/// nothing, but the edge's end before it (or after it) must then lie in the sector.
inline bool BoundaryWalk::clamp(const Edge& edge, std::uint32_t outline, Stretch& chord) const {
  const int first_at_end = side_of_end(outline, chord.from.plane, edge, edge.end);
  const int last_at_start = side_of_end(outline, chord.to.plane, edge, edge.start);
  if (first_at_end <= 0 && last_at_start <= 0) return false;
  const int first_at_start = side_of_end(outline, chord.from.plane, edge, edge.start);
  const int last_at_end = side_of_end(outline, chord.to.plane, edge, edge.end);
  if (first_at_end <= 0 && first_at_start <= 0) return false;
  if (last_at_start <= 0 && last_at_end <= 0) return false;
  if (first_at_start >= 0) chord.from = {Station::Kind::start};
  if (last_at_end >= 0) chord.to = {Station::Kind::end};
  return true;
}

inline bool BoundaryWalk::stretch_inside(const Edge& edge, std::uint32_t outline, Alongside alongside,
                                         Stretch& result) {
  return chord(edge, outline, alongside, result) && clamp(edge, outline, result);
}

/// The ray on which the edge crosses plane a is a.normal x edge.normal if the plane is rising, and the opposite if not;
/// the sign of its product with b.normal tells on which side of b it is.
inline int BoundaryWalk::order(const Edge& edge, const Station& a, const Station& b) const {
  if (a.kind != b.kind) return a.kind < b.kind ? -1 : 1;
  if (a.kind != Station::Kind::inner || a.plane == b.plane) return 0;
  if (a.vertex != Station::none) return risen(b, side_at(b.plane, a.vertex));
  if (b.vertex != Station::none) return -risen(a, side_at(a.plane, b.vertex));
  const std::vector<Plane>& planes = outlines_.planes;
  return risen(b, risen(a, triple(apex_, planes[a.plane], planes[edge.plane], planes[b.plane])));
}

}  // namespace gnomon::sight
