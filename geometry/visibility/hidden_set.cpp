#include "geometry/visibility/hidden_set.h"

#include <algorithm>

namespace gnomon {
namespace {

using Boundary = HidingCondition::Boundary;
using Conditions = std::vector<HidingCondition>;

/// Linear in e, the length of the step; its sign for small e > 0.
struct Height {
  Rational at;
  Rational rise;

  int sign() const { return at != 0 ? at.sign() : rise.sign(); }
};

Height height(const ExactPlane& plane, const LimitPoint& p) {
  return {plane.height(p.place), plane.slope(p.step)};
}

/// One of the functions that describe a blocker, and its value at p.
struct Wall {
  ExactPlane plane;
  Height at_p;
};

ExactPlane combined(const Rational& a, const ExactPlane& p, const Rational& b, const ExactPlane& q) {
  return {a * p.normal - b * q.normal, a * p.offset - b * q.offset};
}

/// Below the plane through p and the line where two walls meet, p being above `front` and below `back`. The blocker
/// lies there.
HidingCondition below_silhouette(const Wall& front, const Wall& back) {
  return {combined(front.at_p.at, back.plane, back.at_p.at, front.plane), Boundary::belongs,
          combined(front.at_p.rise, back.plane, back.at_p.rise, front.plane)};
}

void add_wall(const Wall& wall, Conditions& conditions) {
  if (wall.at_p.sign() > 0) conditions.push_back({wall.plane, Boundary::excluded});
  if (wall.at_p.sign() == 0) conditions.push_back({wall.plane, Boundary::belongs});
}

void add_silhouette(const Wall& a, const Wall& b, Conditions& conditions) {
  const int product = a.at_p.sign() * b.at_p.sign();
  if (product < 0) conditions.push_back(a.at_p.sign() > 0 ? below_silhouette(a, b) : below_silhouette(b, a));
}

Wall wall(const ExactPlane& plane, const LimitPoint& p) {
  return {plane, height(plane, p)};
}

ExactPolygon corners_of(const ConvexPolygon& polygon) {
  ExactPolygon corners;
  for (const std::uint32_t i : polygon.corners()) corners.push_back(exact(polygon.points()[i]));
  return corners;
}

ExactPlane reversed(const ExactPlane& plane) {
  return {Rational(-1) * plane.normal, -plane.offset};
}

/// The plane through p and the side from a to b, and how it grows along the step.
HidingCondition below_side(const LimitPoint& p, const ExactVector& a, const ExactVector& b, bool above) {
  const ExactPlane plane = plane_through(p.place, a, b);
  const ExactVector turn = cross(b - a, p.step);
  const ExactPlane growth{turn, -dot(turn, a)};
  if (above) return {plane, Boundary::belongs, growth};
  return {reversed(plane), Boundary::belongs, reversed(growth)};
}

/// From beside the polygon's plane: the plane itself, and the planes through p and its sides.
Conditions conditions_from_off_plane(const ExactPolygon& corners, const ExactPlane& plane, const LimitPoint& p) {
  const bool above = height(plane, p).sign() > 0;
  Conditions conditions{{above ? plane : reversed(plane), Boundary::excluded}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    conditions.push_back(below_side(p, corners[i], corners[(i + 1) % corners.size()], above));
  }
  return conditions;
}

/// From a point of the polygon's plane: only what lies in the plane can be hidden; there the walls stand upright on the
/// polygon's sides, and neighbours are walls that meet at a corner.
Conditions conditions_from_plane(const ExactPolygon& corners, const ExactPlane& plane, const LimitPoint& p) {
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
  const LimitPoint& p;

  Conditions operator()(const ConvexPolygon& polygon) const {
    const ExactPolygon corners = corners_of(polygon);
    const ExactPlane plane = plane_through(corners[0], corners[1], corners[2]);
    return height(plane, p).sign() == 0 ? conditions_from_plane(corners, plane, p)
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

/// The first that is not 0 decides.
bool is_met(const Rational& height, const Rational& then, Boundary boundary) {
  const int sign = height != 0 ? height.sign() : then.sign();
  return boundary == Boundary::belongs ? sign <= 0 : sign < 0;
}

}  // namespace

std::vector<HidingCondition> hiding_conditions(const ConvexBlocker& blocker, const ExactVector& p) {
  return hiding_conditions(blocker, LimitPoint{p, {}});
}

std::vector<HidingCondition> hiding_conditions(const ConvexBlocker& blocker, const LimitPoint& p) {
  return std::visit(ConditionsFrom{p}, blocker);
}

bool hides(const std::vector<HidingCondition>& conditions, const ExactVector& l) {
  return std::all_of(conditions.begin(), conditions.end(),
                     [&](const HidingCondition& c) { return is_met(c.plane.height(l), c.then.height(l), c.boundary); });
}

bool hides_direction(const std::vector<HidingCondition>& conditions, const ExactVector& towards_light) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const HidingCondition& c) {
    return is_met(c.plane.slope(towards_light), c.then.slope(towards_light), c.boundary);
  });
}

}  // namespace gnomon
