#include "geometry/visibility/hidden_set.h"

#include <algorithm>

namespace gnomon {
namespace {

using Boundary = HidingCondition::Boundary;
using Conditions = std::vector<HidingCondition>;

/// One of the functions that describe a blocker, and its value at p.
struct Wall {
  ExactPlane plane;
  Rational at_p;
};

/// The plane through p and the line where two walls meet, p being above `front` and below `back`. The blocker lies
/// below it.
ExactPlane silhouette_plane(const Wall& front, const Wall& back) {
  return {front.at_p * back.plane.normal - back.at_p * front.plane.normal,
          front.at_p * back.plane.offset - back.at_p * front.plane.offset};
}

void add_wall(const Wall& wall, Conditions& conditions) {
  if (wall.at_p > 0) conditions.push_back({wall.plane, Boundary::excluded});
  if (wall.at_p == 0) conditions.push_back({wall.plane, Boundary::belongs});
}

void add_silhouette(const Wall& a, const Wall& b, Conditions& conditions) {
  if (a.at_p > 0 && b.at_p < 0) conditions.push_back({silhouette_plane(a, b), Boundary::belongs});
  if (b.at_p > 0 && a.at_p < 0) conditions.push_back({silhouette_plane(b, a), Boundary::belongs});
}

Wall wall(const ExactPlane& plane, const ExactVector& p) {
  return {plane, plane.height(p)};
}

ExactPolygon corners_of(const ConvexPolygon& polygon) {
  ExactPolygon corners;
  for (const std::uint32_t i : polygon.corners()) corners.push_back(exact(polygon.points()[i]));
  return corners;
}

ExactPlane reversed(const ExactPlane& plane) {
  return {Rational(-1) * plane.normal, -plane.offset};
}

/// From beside the polygon's plane: the plane itself, and the planes through p and its sides.
Conditions conditions_from_off_plane(const ExactPolygon& corners, const ExactPlane& plane, const ExactVector& p) {
  const bool above = plane.height(p) > 0;
  Conditions conditions{{above ? plane : reversed(plane), Boundary::excluded}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactPlane side = plane_through(p, corners[i], corners[(i + 1) % corners.size()]);
    conditions.push_back({above ? side : reversed(side), Boundary::belongs});
  }
  return conditions;
}

/// From a point of the polygon's plane: only what lies in the plane can be hidden; there the walls stand upright on the
/// polygon's sides, and neighbours are walls that meet at a corner.
Conditions conditions_from_plane(const ExactPolygon& corners, const ExactPlane& plane, const ExactVector& p) {
  Conditions conditions{{plane, Boundary::belongs}, {reversed(plane), Boundary::belongs}};
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactVector outward = cross(corners[(i + 1) % corners.size()] - corners[i], plane.normal);
    walls.push_back(wall({outward, -dot(outward, corners[i])}, p));
  }
  for (std::size_t i = 0; i < walls.size(); ++i) {
    add_wall(walls[i], conditions);
    add_silhouette(walls[i], walls[(i + 1) % walls.size()], conditions);
  }
  return conditions;
}

struct ConditionsFrom {
  const ExactVector& p;

  Conditions operator()(const ConvexPolygon& polygon) const {
    const ExactPolygon corners = corners_of(polygon);
    const ExactPlane plane = plane_through(corners[0], corners[1], corners[2]);
    return plane.height(p) == 0 ? conditions_from_plane(corners, plane, p)
                                : conditions_from_off_plane(corners, plane, p);
  }

  Conditions operator()(const ConvexSolid& solid) const {
    std::vector<Wall> walls;
    for (const ConvexSolid::Facet& facet : solid.facets()) {
      const auto corner = [&](std::size_t i) { return exact(solid.points()[facet.loop[i]]); };
      walls.push_back(wall(plane_through(corner(0), corner(1), corner(2)), p));
    }
    Conditions conditions;
    for (const Wall& w : walls) add_wall(w, conditions);
    for (const ConvexSolid::Edge& edge : solid.edges()) {
      add_silhouette(walls[edge.left], walls[edge.right], conditions);
    }
    return conditions;
  }
};

bool is_met(const Rational& height, Boundary boundary) {
  return boundary == Boundary::belongs ? height <= 0 : height < 0;
}

}  // namespace

std::vector<HidingCondition> hiding_conditions(const ConvexBlocker& blocker, const ExactVector& p) {
  return std::visit(ConditionsFrom{p}, blocker);
}

bool hides(const std::vector<HidingCondition>& conditions, const ExactVector& l) {
  return std::all_of(conditions.begin(), conditions.end(),
                     [&](const HidingCondition& c) { return is_met(c.plane.height(l), c.boundary); });
}

bool hides_direction(const std::vector<HidingCondition>& conditions, const ExactVector& towards_light) {
  return std::all_of(conditions.begin(), conditions.end(),
                     [&](const HidingCondition& c) { return is_met(c.plane.slope(towards_light), c.boundary); });
}

}  // namespace gnomon
