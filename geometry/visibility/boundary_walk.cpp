#include "geometry/visibility/boundary_walk.h"

#include <algorithm>

namespace gnomon::viewpoint {

/// A silhouette to the left of the edge runs the same way as the edge, one to the right against it. The planes before
/// and after the common edge cross it at its ends.
bool BoundaryWalk::alongside_chord(const Silhouette& silhouette, const std::int8_t* sides, Alongside alongside,
                                   Stretch& result) {
  for (std::uint32_t k = 0; k < silhouette.count; ++k) {
    const std::uint32_t next = silhouette.after(k);
    if (sides[k] != 0 || sides[next] != 0) continue;
    const std::uint32_t before = silhouette.before(k);
    const bool left = sides[before] > 0;
    if (alongside != Alongside::either_side && (alongside == Alongside::same_side) != left) return false;
    const Station first = station_at(silhouette.first + before, left, silhouette.first + k);
    const Station last = station_at(silhouette.first + next, !left, silhouette.first + next);
    result = left ? Stretch{first, last} : Stretch{last, first};
    return true;
  }
  return false;
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

}  // namespace gnomon::viewpoint
