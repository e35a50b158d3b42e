#include "geometry/visibility/boundary_walk.h"

#include <algorithm>

namespace gnomon::sight {
namespace {

using Kind = Station::Kind;

Station at(std::uint32_t plane, bool rising, std::uint32_t vertex = Station::none) {
  return {Kind::inner, rising, plane, vertex};
}

int risen(const Station& station, int sign) {
  return station.rising ? sign : -sign;
}

}  // namespace

/// On which side of the edge's plane each ray of the outline runs.
const std::int8_t* BoundaryWalk::sides_at(const Edge& edge, std::uint32_t outline) {
  if (outline == 0) return outlines_.sides_of_light(edge.plane);
  const Outline& o = outlines_.list[outline];
  if (edge.of_light()) return outlines_.sides_at_pyramid(o, edge.plane);
  sides_.resize(o.count);
  for (std::uint32_t k = 0; k < o.count; ++k) sides_[k] = static_cast<std::int8_t>(side_at(edge.plane, o.first + k));
  return sides_.data();
}

/// An outline to the left of the edge runs the same way as the edge, one to the right against it. The planes before and
/// after the common edge cross it at its ends.
bool BoundaryWalk::alongside_chord(const Outline& outline, const std::int8_t* sides, Alongside alongside,
                                   Stretch& result) {
  for (std::uint32_t k = 0; k < outline.count; ++k) {
    const std::uint32_t next = outline.after(k);
    if (sides[k] != 0 || sides[next] != 0) continue;
    const std::uint32_t before = outline.before(k);
    const bool left = sides[before] > 0;
    if (alongside != Alongside::either_side && (alongside == Alongside::same_side) != left) return false;
    const Station first = at(outline.first + before, left, outline.first + k);
    const Station last = at(outline.first + next, !left, outline.first + next);
    result = left ? Stretch{first, last} : Stretch{last, first};
    return true;
  }
  return false;
}

/// Walking with the outline counterclockwise, one comes in where the outline's rays pass from left to right, and goes
/// out where they pass from right to left. A ray in the edge's plane belongs to the side of the ray before.
bool BoundaryWalk::chord(const Edge& edge, std::uint32_t outline, Alongside alongside, Stretch& result) {
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
      (passed > 0 ? result.from : result.to) = at(o.first + k, passed > 0, last == 0 ? o.first + k : Station::none);
    }
    passed = now == 0 ? last : now;
    last = now;
    k = next;
  }
  return crosses || (alongside != Alongside::nothing && alongside_chord(o, sides, alongside, result));
}

/// On which side of a plane of the outline an end of the edge lies.
int BoundaryWalk::side_of_end(std::uint32_t outline, std::uint32_t plane, const Edge& edge, std::uint32_t ray) const {
  if (edge.of_light()) return outlines_.sides_of_light(plane)[ray];
  const Outline& o = outlines_.list[edge.outline];
  return outline == 0 ? outlines_.sides_at_pyramid(o, plane)[ray - o.first] : side_at(plane, ray);
}

/// In the edge's plane the outline is the sector, of less than half a turn, from the ray on its first plane to the ray
/// on its last; the edge is another. Half a turn on, each plane's line is crossed the other way: such a crossing bounds
/// nothing, but the edge's end before it (or after it) must then lie in the sector.
bool BoundaryWalk::clamp(const Edge& edge, std::uint32_t outline, Stretch& chord) const {
  const int first_at_end = side_of_end(outline, chord.from.plane, edge, edge.end);
  const int last_at_start = side_of_end(outline, chord.to.plane, edge, edge.start);
  if (first_at_end <= 0 && last_at_start <= 0) return false;
  const int first_at_start = side_of_end(outline, chord.from.plane, edge, edge.start);
  const int last_at_end = side_of_end(outline, chord.to.plane, edge, edge.end);
  if (first_at_end <= 0 && first_at_start <= 0) return false;
  if (last_at_start <= 0 && last_at_end <= 0) return false;
  if (first_at_start >= 0) chord.from = {Kind::start};
  if (last_at_end >= 0) chord.to = {Kind::end};
  return true;
}

bool BoundaryWalk::stretch_inside(const Edge& edge, std::uint32_t outline, Alongside alongside, Stretch& result) {
  return chord(edge, outline, alongside, result) && clamp(edge, outline, result);
}

/// The ray on which the edge crosses plane a is a.normal x edge.normal if the plane is rising, and the opposite if not;
/// the sign of its product with b.normal tells on which side of b it is.
int BoundaryWalk::order(const Edge& edge, const Station& a, const Station& b) const {
  if (a.kind != b.kind) return a.kind < b.kind ? -1 : 1;
  if (a.kind != Kind::inner || a.plane == b.plane) return 0;
  if (a.vertex != Station::none) return risen(b, side_at(b.plane, a.vertex));
  if (b.vertex != Station::none) return -risen(a, side_at(a.plane, b.vertex));
  const std::vector<Plane>& planes = outlines_.planes;
  return risen(b, risen(a, triple(apex_, planes[a.plane], planes[edge.plane], planes[b.plane])));
}

bool BoundaryWalk::append_uncovered(const Piece& whole, std::vector<Stretch>& covers,
                                    std::vector<Piece>& pieces) const {
  const Edge& edge = whole.edge;
  if (covers.empty()) {
    pieces.push_back(whole);
    return true;
  }
  if (covers.size() > 1) {
    std::sort(covers.begin(), covers.end(),
              [&](const Stretch& a, const Stretch& b) { return order(edge, a.from, b.from) < 0; });
  }
  const std::size_t before = pieces.size();
  Station reached = whole.stretch.from;
  const auto append_until = [&](const Station& until) {
    if (order(edge, reached, until) >= 0) return;
    pieces.push_back(whole);
    pieces.back().stretch = {reached, until};
  };
  for (const Stretch& cover : covers) {
    if (order(edge, cover.from, whole.stretch.to) >= 0) break;
    append_until(cover.from);
    if (order(edge, cover.to, reached) > 0) reached = cover.to;
  }
  append_until(whole.stretch.to);
  return pieces.size() > before;
}

}  // namespace gnomon::sight
