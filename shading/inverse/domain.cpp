#include <algorithm>

#include "shading/inverse/design_space.h"

namespace gnomon::inverse {
namespace {

DesignWall domain_wall(std::size_t side) {
  DesignWall wall;
  wall.kind = DesignWall::Kind::domain;
  wall.edge = static_cast<std::uint32_t>(side);
  return wall;
}

/// The cell that has all given points for corners; planes are those of the domain.
Cell cell_of(DesignSpace& space, const std::vector<Whole>& corners, const std::vector<CellPlane>& planes) {
  Cell cell;
  for (const Whole& whole : corners) {
    Corner corner{space.cells.add_corner(whole), {}};
    for (const CellPlane plane : planes) {
      if (space.cells.side(plane, corner.id) == 0) corner.planes.push_back(plane);
    }
    cell.corners.push_back(std::move(corner));
  }
  return cell;
}

/// The hull of points and directions, with its planes and given ones. Those that are no corners lie on too few planes
/// to be kept.
Cell hull_cell(DesignSpace& space, const std::vector<Whole>& generators, std::vector<CellPlane> planes = {}) {
  const auto half_spaces = hull_half_spaces(generators);
  if (!half_spaces) throw DesignError("the domain has no interior");
  for (const Whole& plane : *half_spaces) planes.push_back(space.add(plane, domain_wall(planes.size())));
  Cell cell = cell_of(space, generators, planes);
  Cell corners;
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const auto hides = [&](const Corner& other) {
      const bool is_same = space.cells.corner(other.id) == space.cells.corner(cell.corners[i].id);
      const bool is_more = std::ranges::includes(other.planes, cell.corners[i].planes);
      return &other != &cell.corners[i] && is_more && (!is_same || other.id < cell.corners[i].id);
    };
    if (std::ranges::none_of(cell.corners, hides)) corners.corners.push_back(cell.corners[i]);
  }
  return corners;
}

Cell box_cell(DesignSpace& space, const std::array<Rational, 3>& least, const std::array<Rational, 3>& most) {
  std::vector<CellPlane> planes;
  for (std::size_t side = 0; side < 6; ++side) {
    ExactVector normal;
    normal[side / 2] = side % 2 == 0 ? -1 : 1;
    const Rational offset = side % 2 == 0 ? least[side / 2] : Rational(-most[side / 2]);
    planes.push_back(space.add(whole_plane(normal, offset), domain_wall(side)));
  }
  std::vector<Whole> corners;
  for (unsigned c = 0; c < 8; ++c) {
    ExactVector p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = c >> k & 1U ? most[k] : least[k];
    corners.push_back(whole_point(p));
  }
  return cell_of(space, corners, planes);
}

std::array<Rational, 3> numbers(const Point3& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

/// A corner of planes of the space is a quotient of two determinants of whole numbers, the lower one at least 1.
Cell everywhere(DesignSpace& space) {
  std::size_t bits = 1;
  for (CellPlane p = 0; p < space.cells.plane_count(); ++p) {
    for (const Integer& x : space.cells.plane(p)) bits = std::max(bits, mpz_sizeinbase(x.backend().data(), 2));
  }
  Integer far = 1;
  far <<= static_cast<unsigned>(3 * bits + 8);
  const Rational most(far), least(Integer(-far));
  return box_cell(space, {least, least, least}, {most, most, most});
}

Cell polygon_cell(DesignSpace& space, const std::vector<Point3>& points) {
  const ConvexPolygon polygon = ConvexPolygon::from_points(points);
  if (!polygon.is_flat()) throw DesignError("the domain's vertices do not lie exactly in one plane");
  std::vector<ExactVector> corners;
  for (const std::uint32_t i : polygon.corners()) corners.push_back(exact(points[i]));
  const ExactVector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  std::vector<CellPlane> planes = {
      space.add(whole_plane(normal, Rational(-dot(normal, corners[0]))), domain_wall(corners.size()))};
  std::vector<Whole> wholes;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const ExactVector out = cross(corners[(k + 1) % corners.size()] - corners[k], normal);
    planes.push_back(space.add(whole_plane(out, Rational(-dot(out, corners[k]))), domain_wall(k)));
    wholes.push_back(whole_point(corners[k]));
  }
  return cell_of(space, wholes, planes);
}

Cell segment_cell(DesignSpace& space, const Point3& from, const Point3& to, std::size_t number) {
  const ExactVector a = exact(from), b = exact(to), along = b - a;
  ExactVector axis;
  axis[along.x == 0 ? 0 : along.y == 0 ? 1 : 2] = 1;
  if (is_zero(cross(along, axis))) axis = {1, 0, 0};
  const ExactVector across = cross(along, axis), other = cross(along, across);
  std::vector<CellPlane> planes;
  const auto add = [&](const ExactVector& normal, const ExactVector& through, std::size_t side) {
    planes.push_back(space.add(whole_plane(normal, Rational(-dot(normal, through))), domain_wall(side)));
  };
  add(across, a, number);
  add(other, a, number);
  add(Rational(-1) * along, a, number);
  add(along, b, number + 1);
  return cell_of(space, {whole_point(a), whole_point(b)}, planes);
}

/// Directions are a cone whose corners are at infinity. All of them are six cones over the sides of a cube.
std::vector<Cell> direction_cells(DesignSpace& space, const std::vector<Point3>& rays) {
  std::vector<std::vector<Whole>> cones;
  if (rays.empty()) {
    for (std::size_t side = 0; side < 6; ++side) {
      std::vector<Whole>& cone = cones.emplace_back();
      for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        ExactVector ray;
        ray[side / 2] = side % 2 == 0 ? -1 : 1;
        ray[(side / 2 + 1) % 3] = u;
        ray[(side / 2 + 2) % 3] = v;
        cone.push_back(whole_direction(ray));
      }
    }
  } else {
    std::vector<Whole>& cone = cones.emplace_back();
    for (const Point3& ray : rays) cone.push_back(whole_direction(ray));
  }
  const CellPlane infinity = space.add({0, 0, 0, 1}, domain_wall(0));
  std::vector<Cell> cells;
  for (std::vector<Whole>& cone : cones) {
    cone.push_back({0, 0, 0, 1});
    const Cell cell = section(space.cells, hull_cell(space, cone, {infinity}), infinity);
    if (dimension(space.cells, cell) < 2) throw DesignError("the domain's directions have no cone between them");
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace

bool contains(const DesignSpace& space, const Wall& wall, CornerId point) {
  return space.cells.side(wall.plane, point) < (wall.is_closed ? 1 : 0);
}

bool contains(const DesignSpace& space, const ConvexSet& set, CornerId point) {
  return std::ranges::all_of(set.walls, [&](const Wall& wall) { return contains(space, wall, point); });
}

bool holds(const DesignSpace& space, const GoalSets& goal, CornerId point) {
  const auto in = [&](const ConvexSet& set) { return contains(space, set, point); };
  return std::ranges::all_of(goal.on, [&](CellPlane p) { return space.cells.side(p, point) == 0; }) &&
         std::ranges::all_of(goal.within, [&](const Wall& wall) { return contains(space, wall, point); }) &&
         std::ranges::all_of(goal.any, [&](const auto& sets) { return std::ranges::any_of(sets, in); }) &&
         std::ranges::none_of(goal.none, in);
}

std::vector<Cell> domain_cells(DesignSpace& space, const DesignDomain& domain) {
  const std::vector<Point3>& v = domain.vertices;
  std::vector<Cell> cells;
  switch (domain.shape) {
    case DomainShape::everywhere:
      return {everywhere(space)};
    case DomainShape::box:
      return {box_cell(space, numbers(v[0]), numbers(v[1]))};
    case DomainShape::polygon:
      return {polygon_cell(space, v)};
    case DomainShape::directions:
      return direction_cells(space, v);
    case DomainShape::polytope: {
      std::vector<Whole> points;
      for (const Point3& p : v) points.push_back(whole_point(p));
      return {hull_cell(space, points)};
    }
    case DomainShape::segment:
    case DomainShape::polyline:
      for (std::size_t k = 0; k + 1 < v.size(); ++k) cells.push_back(segment_cell(space, v[k], v[k + 1], k));
  }
  return cells;
}

}  // namespace gnomon::inverse
