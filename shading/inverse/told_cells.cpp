#include "shading/inverse/told_cells.h"

#include <algorithm>

#include "geometry/numbers/rounding.h"

namespace gnomon::inverse {
namespace {

void add_corners(const DesignSpace& space, const Cell& cell, bool may_be_far, FeasibleCell& result) {
  for (const Corner& corner : cell.corners) {
    Whole whole = space.cells.corner(corner.id);
    const bool far = whole[3] == 0 || (may_be_far && is_far(space, corner));
    if (far) {
      Integer most = 1;
      for (std::size_t k = 0; k < 3; ++k) most = std::max(most, Integer(abs(whole[k])));
      whole[3] = most;
    }
    const ExactVector p = coordinates(whole);
    result.corners.push_back({nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)});
    result.at_infinity.push_back(far);
  }
}

/// The corners of a flat cell, one beside the next.
std::vector<std::uint32_t> polygon_loop(const Cell& cell) {
  std::vector<std::vector<std::uint32_t>> next(cell.corners.size());
  for (const auto& [a, b] : edges(cell)) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  std::vector<std::uint32_t> loop = {0};
  for (std::uint32_t before = ~0U; loop.size() < cell.corners.size();) {
    const std::uint32_t here = loop.back();
    if (next[here].size() < 2) break;
    loop.push_back(next[here][0] != before ? next[here][0] : next[here][1]);
    before = here;
  }
  return loop;
}

}  // namespace

bool is_far(const DesignSpace& space, const Corner& corner) {
  return std::ranges::any_of(corner.planes,
                             [&](CellPlane p) { return space.names[p].kind == DesignWall::Kind::domain; });
}

FeasibleCell told(const DesignSpace& space, const Cell& cell, bool may_be_far) {
  FeasibleCell result;
  add_corners(space, cell, may_be_far, result);
  const int n = dimension(space.cells, cell);
  if (n < 2) return result;
  for (const CellFace& face : faces(space.cells, cell)) {
    if (n == 2) continue;
    result.faces.push_back(face.corners);
    result.walls.emplace_back(space.names[face.plane]);
  }
  if (n > 2) return result;
  result.faces.push_back(polygon_loop(cell));
  result.walls.emplace_back(std::nullopt);
  return result;
}

}  // namespace gnomon::inverse
