#include <algorithm>
#include <cmath>

#include "apps/proof/laws/subject.h"
#include "shading/inverse/feasible_region.h"
#include "shading/inverse/goal_sets.h"

namespace gnomon::laws {
namespace {

/// +1 inside a cell, 0 on its boundary, -1 outside.
int place_in(const inverse::DesignSpace& space, const inverse::Cell& cell, inverse::CornerId point) {
  using enum inverse::PlaneSide;
  int place = 1;
  for (const inverse::Corner& corner : cell.corners) {
    for (const inverse::CellPlane plane : corner.planes) {
      const int side = space.cells.side(plane, point);
      const bool is_within = lies(space.cells, cell, plane, within), is_beyond = lies(space.cells, cell, plane, beyond);
      if ((side > 0 && is_within) || (side < 0 && is_beyond)) return -1;
      if (side == 0 && !(is_within && is_beyond)) place = 0;
    }
  }
  return place;
}

/// A domain with the position well inside.
DesignDomain domain_about(const Design& design, const Point3& p) {
  if (design.variable == FreeVariable::direction) return {DomainShape::directions, {}};
  if (design.variable == FreeVariable::scale) return {DomainShape::segment, {{0.5, 0, 0}, {2, 0, 0}}};
  const double reach = 1 + std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
  return {DomainShape::box, {{p.x - reach, p.y - reach, p.z - reach}, {p.x + reach, p.y + reach, p.z + reach}}};
}

}  // namespace

std::optional<bool> design_place(const Design& design, const DesignObstacles& obstacles, const Point3& position) {
  inverse::DesignSpace space;
  std::vector<inverse::GoalSets> goals;
  for (std::uint32_t g = 0; g < design.goals.size(); ++g) goals.push_back(goal_sets(space, design, g, obstacles));
  const bool is_direction = design.variable == FreeVariable::direction;
  const inverse::CornerId point =
      space.cells.add_corner(is_direction ? inverse::whole_direction(position) : inverse::whole_point(position));
  for (inverse::CellPlane plane = 0; plane < space.cells.plane_count(); ++plane) {
    if (space.cells.side(plane, point) == 0) return std::nullopt;
  }
  const auto found = feasible_cells(space, domain_about(design, position), goals, {});
  if (found.is_flat && !found.cells.empty()) return std::nullopt;
  int best = -1;
  for (const inverse::Cell& cell : found.cells) best = std::max(best, place_in(space, cell, point));
  if (best == 0) return std::nullopt;
  return best > 0;
}

}  // namespace gnomon::laws
