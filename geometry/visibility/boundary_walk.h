#pragma once

/// The boundary of what is visible, edge by edge. Private to this folder.

#include <cstdint>
#include <vector>

#include "geometry/visibility/silhouette.h"

namespace gnomon::viewpoint {

/// A point of the edge that is walked: one of its ends, or where it crosses a plane. Planes and rays by their indices
/// in the silhouettes.
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

/// The edge that is walked: a silhouette's k-th, in its plane k from its ray k to the next. By indices: of the
/// silhouette, and of the plane and the two rays among those of all silhouettes.
struct Edge {
  std::uint32_t silhouette = 0;
  std::uint32_t plane = 0;
  std::uint32_t start = 0;
  std::uint32_t end = 0;

  /// The visible part lies left of a light's edge and right of a blocker's.
  bool of_light() const { return silhouette == 0; }
};

/// The ray of an input point that lies at the station, or Station::none.
inline std::uint32_t ray_at(const Edge& edge, const Station& station) {
  return station.kind == Station::Kind::start ? edge.start
         : station.kind == Station::Kind::end ? edge.end
                                              : station.vertex;
}

inline Edge edge_of(const Silhouettes& silhouettes, std::uint32_t silhouette, std::uint32_t k) {
  const Silhouette& o = silhouettes.list[silhouette];
  return {silhouette, o.first + k, o.first + k, o.first + o.after(k)};
}

/// A piece of the visible part's boundary, on which one edge is not covered.
struct Piece {
  Edge edge;
  Stretch stretch;
};

/// What counts as covered where an edge of another silhouette runs along the walked one.
enum class Alongside { nothing, same_side, other_side, either_side };

/// Walks edges past silhouettes.
///
/// Exactness: every order and every side is exact; doubles decide where their bound allows, exact arithmetic elsewhere.
class BoundaryWalk {
 public:
  /// The memory is used as the walk needs it; its content is of no use to others.
  BoundaryWalk(const Point3& apex, const Silhouettes& silhouettes, std::vector<std::int8_t>& memory)
      : apex_(apex), silhouettes_(silhouettes), sides_(memory) {}

  /// The part of the edge inside the silhouette; true if it has positive length.
  /// Degenerate: where an edge of the silhouette runs along, `alongside` says on which side of it the silhouette must
  /// lie.
  bool stretch_inside(const Edge& edge, std::uint32_t silhouette, Alongside alongside, Stretch& result);

  /// Appends the parts of `whole` that none of the covers holds, in order; `covers` is sorted.
  /// Requires: `whole` has a positive length.
  /// Returns: true if there was one.
  bool append_uncovered(const Piece& whole, std::vector<Stretch>& covers, std::vector<Piece>& pieces) const;

  /// -1, 0, +1: which of two stations of the edge comes first.
  int order(const Edge& edge, const Station& a, const Station& b) const;

 private:
  const std::int8_t* sides_at(const Edge& edge, std::uint32_t silhouette);
  bool chord(const Edge& edge, std::uint32_t silhouette, Alongside alongside, Stretch& result);
  static bool alongside_chord(const Silhouette& silhouette, const std::int8_t* sides, Alongside alongside,
                              Stretch& result);
  int side_of_end(std::uint32_t silhouette, std::uint32_t plane, const Edge& edge, std::uint32_t ray) const;
  bool clamp(const Edge& edge, std::uint32_t silhouette, Stretch& chord) const;
  int side_at(std::uint32_t plane, std::uint32_t ray) const {
    return side(apex_, silhouettes_.planes[plane], silhouettes_.rays[ray]);
  }

  Point3 apex_;
  const Silhouettes& silhouettes_;
  std::vector<std::int8_t>& sides_;  ///< of the silhouette's rays at the edge's plane
};

inline Station station_at(std::uint32_t plane, bool rising, std::uint32_t vertex = Station::none) {
  return {Station::Kind::inner, rising, plane, vertex};
}

inline int risen(const Station& station, int sign) {
  return station.rising ? sign : -sign;
}

/// On which side of the edge's plane each ray of the silhouette runs.
inline const std::int8_t* BoundaryWalk::sides_at(const Edge& edge, std::uint32_t silhouette) {
  if (silhouette == 0) return silhouettes_.sides_of_light(edge.plane);
  const Silhouette& o = silhouettes_.list[silhouette];
  if (edge.of_light()) return silhouettes_.sides_at_pyramid(o, edge.plane);
  sides_.resize(o.count);
  for (std::uint32_t k = 0; k < o.count; ++k) sides_[k] = static_cast<std::int8_t>(side_at(edge.plane, o.first + k));
  return sides_.data();
}

/// Walking with the silhouette counterclockwise, one comes in where the silhouette's rays pass from left to right, and
/// goes out where they pass from right to left. A ray in the edge's plane belongs to the side of the ray before.
inline bool BoundaryWalk::chord(const Edge& edge, std::uint32_t silhouette, Alongside alongside, Stretch& result) {
  const Silhouette& o = silhouettes_.list[silhouette];
  const std::int8_t* sides = sides_at(edge, silhouette);
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

/// On which side of a plane of the silhouette an end of the edge lies.
inline int BoundaryWalk::side_of_end(std::uint32_t silhouette, std::uint32_t plane, const Edge& edge,
                                     std::uint32_t ray) const {
  if (edge.of_light()) return silhouettes_.sides_of_light(plane)[ray];
  const Silhouette& o = silhouettes_.list[edge.silhouette];
  return silhouette == 0 ? silhouettes_.sides_at_pyramid(o, plane)[ray - o.first] : side_at(plane, ray);
}

/// In the edge's plane the silhouette is the sector, of less than half a turn, from the ray on its first plane to the
/// ray on its last; the edge is another. Half a turn on, each plane's line is crossed the other way: such a crossing
/// bounds nothing, but the edge's end before it (or after it) must then lie in the sector.
inline bool BoundaryWalk::clamp(const Edge& edge, std::uint32_t silhouette, Stretch& chord) const {
  const int first_at_end = side_of_end(silhouette, chord.from.plane, edge, edge.end);
  const int last_at_start = side_of_end(silhouette, chord.to.plane, edge, edge.start);
  if (first_at_end <= 0 && last_at_start <= 0) return false;
  const int first_at_start = side_of_end(silhouette, chord.from.plane, edge, edge.start);
  const int last_at_end = side_of_end(silhouette, chord.to.plane, edge, edge.end);
  if (first_at_end <= 0 && first_at_start <= 0) return false;
  if (last_at_start <= 0 && last_at_end <= 0) return false;
  if (first_at_start >= 0) chord.from = {Station::Kind::start};
  if (last_at_end >= 0) chord.to = {Station::Kind::end};
  return true;
}

inline bool BoundaryWalk::stretch_inside(const Edge& edge, std::uint32_t silhouette, Alongside alongside,
                                         Stretch& result) {
  return chord(edge, silhouette, alongside, result) && clamp(edge, silhouette, result);
}

/// The ray on which the edge crosses plane a is a.normal x edge.normal if the plane is rising, and the opposite if not;
/// the sign of its product with b.normal tells on which side of b it is.
inline int BoundaryWalk::order(const Edge& edge, const Station& a, const Station& b) const {
  if (a.kind != b.kind) return a.kind < b.kind ? -1 : 1;
  if (a.kind != Station::Kind::inner || a.plane == b.plane) return 0;
  if (a.vertex != Station::none) return risen(b, side_at(b.plane, a.vertex));
  if (b.vertex != Station::none) return -risen(a, side_at(a.plane, b.vertex));
  const std::vector<Plane>& planes = silhouettes_.planes;
  return risen(b, risen(a, triple(apex_, planes[a.plane], planes[edge.plane], planes[b.plane])));
}

}  // namespace gnomon::viewpoint
