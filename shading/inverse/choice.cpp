#include "shading/inverse/choice.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/rounding.h"
#include "shading/inverse/lengths.h"
#include "shading/inverse/linear_program.h"

namespace gnomon::inverse {
namespace {

/// A cell's planes, each turned so that the cell lies within.
struct CellWalls {
  std::vector<Whole> bounding;
  std::vector<Whole> holding;  ///< of a flat cell: that all of it lies on
};

CellWalls walls_of(const DesignSpace& space, const Cell& cell) {
  std::vector<CellPlane> planes;
  for (const Corner& corner : cell.corners) planes.insert(planes.end(), corner.planes.begin(), corner.planes.end());
  std::ranges::sort(planes);
  planes.erase(std::ranges::unique(planes).begin(), planes.end());
  CellWalls walls;
  for (const CellPlane plane : planes) {
    const Whole& numbers = space.cells.plane(plane);
    const bool within = lies(space.cells, cell, plane, PlaneSide::within);
    const bool beyond = lies(space.cells, cell, plane, PlaneSide::beyond);
    if (within && beyond) walls.holding.push_back(numbers);
    if (within && !beyond) walls.bounding.push_back(numbers);
    if (beyond && !within) {
      walls.bounding.push_back(
          {Integer(-numbers[0]), Integer(-numbers[1]), Integer(-numbers[2]), Integer(-numbers[3])});
    }
  }
  return walls;
}

Rational measure(const Extent& extent, Choice choice, const Whole& plane) {
  const ExactVector normal = normal_of(plane);
  return choice == Choice::cube ? extent.cube_support(normal) : extent.length_above(normal);
}

/// The largest r with n x + |n| r <= -d for all planes, by the dual program: the least -d · y with Σ n y = 0,
/// Σ |n| y = 1. The multipliers are x and r.
StandardProgram ball_program(const CellWalls& walls, const Extent& extent, Choice choice) {
  StandardProgram program;
  program.right = {0, 0, 0, 1};
  const auto add = [&](const Whole& plane, const Rational& length, int sign) {
    const Rational s(sign);
    program.columns.push_back({Rational(s * plane[0]), Rational(s * plane[1]), Rational(s * plane[2]), length});
    program.cost.push_back(Rational(-s * plane[3]));
  };
  for (const Whole& plane : walls.bounding) add(plane, measure(extent, choice, plane), 1);
  for (const Whole& plane : walls.holding) {
    add(plane, 0, 1);
    add(plane, 0, -1);
  }
  return program;
}

ChosenPoint largest_ball(const CellWalls& walls, const Extent& extent, Choice choice) {
  const ProgramSolution solution = solved_program(ball_program(walls, extent, choice));
  if (solution.kind != ProgramSolution::Kind::optimal) throw DesignError("the feasible region holds balls of any size");
  const std::vector<Rational>& x = solution.multipliers;
  return {{x[0], x[1], x[2]}, x[3]};
}

/// The centre of the largest ball, then of the largest ball among the centres of all as large, until one is left.
ChosenPoint centre_of(DesignSpace& space, Cell cell, Choice choice) {
  std::optional<Rational> radius;
  while (true) {
    const Extent extent(space.cells, cell);
    if (extent.dimension() == 0) {
      return {coordinates(space.cells.corner(cell.corners[0].id)), radius.value_or(0)};
    }
    const CellWalls walls = walls_of(space, cell);
    const ChosenPoint ball = largest_ball(walls, extent, choice);
    if (!radius) radius = ball.radius;
    Cell centres = cell;
    for (const Whole& plane : walls.bounding) {
      const Rational offset = Rational(plane[3]) + measure(extent, choice, plane) * ball.radius;
      const CellPlane inner = space.add(whole_plane(normal_of(plane), offset), {});
      centres = part(space.cells, centres, inner, PlaneSide::within, FlatParts::kept);
    }
    // Lengths that were rounded up may leave a sliver of full dimension: its middle is near enough.
    if (dimension(space.cells, centres) >= extent.dimension()) return {ball.position, *radius};
    cell = std::move(centres);
  }
}

/// The cells whose balls may be largest, as doubles have it: exact work is for these.
std::vector<std::size_t> likely_cells(const DesignSpace& space, std::span<const Cell> cells, Choice choice) {
  constexpr double nearly = 1 - 1e-5;
  std::vector<double> radius;
  for (const Cell& cell : cells) {
    const Extent extent(space.cells, cell);
    const double r =
        extent.dimension() == 0 ? 0 : rough_multipliers(ball_program(walls_of(space, cell), extent, choice))[3];
    radius.push_back(std::isfinite(r) ? r : HUGE_VAL);
  }
  const double most = *std::ranges::max_element(radius);
  std::vector<std::size_t> likely;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (radius[k] >= nearly * most || radius[k] < 0) likely.push_back(k);
  }
  return likely;
}

/// Cells by a distance that they are not nearer than, as doubles have it, the nearest first.
std::vector<std::pair<double, std::size_t>> by_distance(const DesignSpace& space, std::span<const Cell> cells,
                                                        const Point3& p) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    double least = 0;
    for (const Whole& plane : walls_of(space, cells[k]).bounding) {
      const ExactVector normal = normal_of(plane);
      const Rational height = dot(normal, exact(p)) + Rational(plane[3]);
      if (height > 0) least = std::fmax(least, nearest_root(Rational(height * height / dot(normal, normal))));
    }
    order.emplace_back(least * (1 - 1e-12), k);
  }
  std::ranges::sort(order);
  return order;
}

Rational squared_distance(const ExactVector& a, const ExactVector& b) {
  const ExactVector v = a - b;
  return dot(v, v);
}

bool is_in(const CellWalls& walls, const ExactVector& p) {
  const Whole point = whole_point(p);
  const auto on = [&](const Whole& plane) { return value(plane, point) == 0; };
  const auto within = [&](const Whole& plane) { return value(plane, point) <= 0; };
  return std::ranges::all_of(walls.holding, on) && std::ranges::all_of(walls.bounding, within);
}

/// Where the point falls on a plane or line that some planes have in common.
std::optional<ExactVector> foot(const ExactVector& p, std::span<const Whole> planes) {
  std::vector<ExactVector> normals;
  ExactVector foot = p;
  for (const Whole& plane : planes) {
    // Gram and Schmidt: the step along what is new in this normal keeps the planes before.
    ExactVector n = normal_of(plane);
    for (const ExactVector& earlier : normals) n = n - Rational(dot(n, earlier) / dot(earlier, earlier)) * earlier;
    const Rational height = dot(normal_of(plane), foot) + Rational(plane[3]);
    if (is_zero(n)) {
      if (height != 0) return std::nullopt;
      continue;
    }
    foot = foot - Rational(height / dot(n, n)) * n;
    normals.push_back(n);
  }
  return foot;
}

/// The nearest point lies in the cell, on a face, on an edge, or in a corner, and is the foot there.
ChosenPoint nearest_in(const DesignSpace& space, const Cell& cell, const ExactVector& p) {
  const CellWalls walls = walls_of(space, cell);
  std::vector<ExactVector> candidates;
  const auto try_planes = [&](std::vector<Whole> planes) {
    planes.insert(planes.begin(), walls.holding.begin(), walls.holding.end());
    const auto found = foot(p, planes);
    if (found && is_in(walls, *found)) candidates.push_back(*found);
  };
  try_planes({});
  if (candidates.empty()) {
    for (const Whole& a : walls.bounding) try_planes({a});
    for (const auto& [i, j] : edges(cell)) {
      std::vector<Whole> planes;
      for (const CellPlane plane : cell.corners[i].planes) {
        if (std::ranges::binary_search(cell.corners[j].planes, plane)) planes.push_back(space.cells.plane(plane));
      }
      try_planes(std::move(planes));
    }
    for (const Corner& corner : cell.corners) {
      const Whole& whole = space.cells.corner(corner.id);
      if (whole[3] != 0) candidates.push_back(coordinates(whole));
    }
  }
  const auto distance = [&](const ExactVector& q) { return squared_distance(p, q); };
  return {*std::ranges::min_element(candidates, std::less<>(), distance), 0};
}

/// The shortest vector s with n s <= -|n| for all planes through the origin: its angle to each has a sine of at least
/// 1 / |s|. It is the foot of the origin on one, two or three of the planes.
std::optional<ExactVector> shortest_inside(const std::vector<Whole>& bounding) {
  std::vector<Whole> planes;
  for (const Whole& plane : bounding) {
    const ExactVector normal = normal_of(plane);
    if (!is_zero(normal)) planes.push_back(whole_plane(normal, Rational(nearest_root(dot(normal, normal)))));
  }
  std::optional<ExactVector> shortest;
  const auto consider = [&](std::initializer_list<Whole> some) {
    const auto found = foot({}, std::span(some.begin(), some.size()));
    if (!found || (shortest && dot(*found, *found) >= dot(*shortest, *shortest))) return;
    const Whole point = whole_point(*found);
    if (std::ranges::all_of(planes, [&](const Whole& plane) { return value(plane, point) <= 0; })) shortest = found;
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    consider({planes[i]});
    for (std::size_t j = 0; j < i; ++j) {
      consider({planes[j], planes[i]});
      for (std::size_t k = 0; k < j; ++k) consider({planes[k], planes[j], planes[i]});
    }
  }
  return shortest;
}

bool is_before(const ExactVector& a, const ExactVector& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace

ChosenPoint chosen_point(DesignSpace& space, std::span<const Cell> cells, Choice choice,
                         const std::optional<Point3>& near) {
  std::optional<ChosenPoint> best;
  if (choice != Choice::nearest) {
    for (const std::size_t k : likely_cells(space, cells, choice)) {
      ChosenPoint point = centre_of(space, cells[k], choice);
      const bool is_better = !best || point.radius > best->radius ||
                             (point.radius == best->radius && is_before(point.position, best->position));
      if (is_better) best = std::move(point);
    }
    return *best;
  }
  Rational least = 0;
  for (const auto& [distance, k] : by_distance(space, cells, *near)) {
    if (best && Rational(distance) * Rational(distance) > least) break;
    ChosenPoint point = nearest_in(space, cells[k], exact(*near));
    const Rational square = squared_distance(point.position, exact(*near));
    const bool is_better = !best || square < least || (square == least && is_before(point.position, best->position));
    if (!is_better) continue;
    best = std::move(point);
    least = square;
  }
  return *best;
}

ChosenPoint chosen_direction(DesignSpace& space, std::span<const Cell> cones) {
  std::optional<ChosenPoint> best;
  Rational least = 0;
  for (const Cell& cone : cones) {
    const std::optional<ExactVector> shortest = shortest_inside(walls_of(space, cone).bounding);
    const Whole inside = middle(space.cells, cone);
    const ExactVector direction = shortest ? *shortest : normal_of(inside);
    const Rational square = shortest ? dot(direction, direction) : Rational(0);
    const bool is_better = !best || (square > 0 && (least == 0 || square < least));
    if (!is_better) continue;
    best = ChosenPoint{direction, square > 0 ? Rational(nearest_root(Rational(1 / square))) : Rational(0)};
    least = square;
  }
  return *best;
}

}  // namespace gnomon::inverse
