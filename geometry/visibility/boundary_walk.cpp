#include "geometry/visibility/boundary_walk.h"

#include <algorithm>

namespace gnomon::sight {
namespace {

using Kind = Station::Kind;

Station at(const Plane& plane, bool rising, const Ray* vertex = nullptr) {
  return {Kind::inner, &plane, rising, vertex};
}

int risen(const Station& station, int sign) {
  return station.rising ? sign : -sign;
}

}  // namespace

/// An outline to the left of the edge runs the same way as the edge, one to the right against it. The planes before and
/// after the common edge cross it at its ends.
bool BoundaryWalk::alongside_chord(const Outline& outline, Alongside alongside, Stretch& result) const {
  const std::size_t count = signs_.size();
  const std::span<const Ray> rays = outlines_.rays_of(outline);
  const std::span<const Plane> planes = outlines_.planes_of(outline);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = k + 1 == count ? 0 : k + 1;
    if (signs_[k] != 0 || signs_[next] != 0) continue;
    const std::size_t before = k == 0 ? count - 1 : k - 1;
    const bool left = signs_[before] > 0;
    if (alongside != Alongside::either_side && (alongside == Alongside::same_side) != left) return false;
    const Station first = at(planes[before], left, &rays[k]);
    const Station last = at(planes[next], !left, &rays[next]);
    result = left ? Stretch{first, last} : Stretch{last, first};
    return true;
  }
  return false;
}

/// Walking with the outline counterclockwise, one comes in where the outline's rays pass from left to right, and goes
/// out where they pass from right to left.
bool BoundaryWalk::chord(const Edge& edge, const Outline& outline, Alongside alongside, Stretch& result) {
  const std::span<const Ray> rays = outlines_.rays_of(outline);
  const std::span<const Plane> planes = outlines_.planes_of(outline);
  const std::size_t count = rays.size();
  signs_.resize(count);
  bool left = false;
  bool right = false;
  for (std::size_t k = 0; k < count; ++k) {
    signs_[k] = side(apex_, *edge.plane, rays[k]);
    left = left || signs_[k] > 0;
    right = right || signs_[k] < 0;
  }
  if (!left || !right) return alongside != Alongside::nothing && alongside_chord(outline, alongside, result);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = k + 1 == count ? 0 : k + 1;
    const int passed = signs_[k] == 0 ? signs_[k == 0 ? count - 1 : k - 1] : signs_[k];
    if (passed * signs_[next] >= 0) continue;
    const Ray* vertex = signs_[k] == 0 ? &rays[k] : nullptr;
    (passed > 0 ? result.from : result.to) = at(planes[k], passed > 0, vertex);
  }
  return true;
}

/// In the edge's plane the outline is the sector, of less than half a turn, from the ray on its first plane to the ray
/// on its last; the edge is another. Half a turn on, each plane's line is crossed the other way: such a crossing bounds
/// nothing, but the edge's end before it (or after it) must then lie in the sector.
bool BoundaryWalk::clamp(const Edge& edge, Stretch& chord) const {
  const int first_at_end = side(apex_, *chord.from.plane, *edge.end);
  const int last_at_start = side(apex_, *chord.to.plane, *edge.start);
  if (first_at_end <= 0 && last_at_start <= 0) return false;
  const int first_at_start = side(apex_, *chord.from.plane, *edge.start);
  const int last_at_end = side(apex_, *chord.to.plane, *edge.end);
  if (first_at_end <= 0 && first_at_start <= 0) return false;
  if (last_at_start <= 0 && last_at_end <= 0) return false;
  if (first_at_start >= 0) chord.from = {Kind::start};
  if (last_at_end >= 0) chord.to = {Kind::end};
  return true;
}

bool BoundaryWalk::stretch_inside(const Edge& edge, const Outline& outline, Alongside alongside, Stretch& result) {
  return chord(edge, outline, alongside, result) && clamp(edge, result);
}

/// The ray on which the edge crosses plane a is a.normal x edge.normal if the plane is rising, and the opposite if not;
/// the sign of its product with b.normal tells on which side of b it is.
int BoundaryWalk::order(const Edge& edge, const Station& a, const Station& b) const {
  if (a.kind != b.kind) return a.kind < b.kind ? -1 : 1;
  if (a.kind != Kind::inner || a.plane == b.plane) return 0;
  if (a.vertex != nullptr) return risen(b, side(apex_, *b.plane, *a.vertex));
  if (b.vertex != nullptr) return -risen(a, side(apex_, *a.plane, *b.vertex));
  return risen(b, risen(a, triple(apex_, *a.plane, *edge.plane, *b.plane)));
}

bool BoundaryWalk::append_uncovered(const Piece& whole, std::vector<Stretch>& covers,
                                    std::vector<Piece>& pieces) const {
  const Edge& edge = whole.edge;
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
