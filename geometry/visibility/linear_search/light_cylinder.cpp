#include "geometry/visibility/linear_search/light_cylinder.h"

#include <algorithm>
#include <cmath>

namespace gnomon::viewpoint {
namespace {

Vector of_length_one(const Vector& v) {
  const double size = size_of(v);
  const Vector scaled{v.x / size, v.y / size, v.z / size};
  const double length = std::sqrt(dot(scaled, scaled));
  return {scaled.x / length, scaled.y / length, scaled.z / length};
}

/// The axis most across the vector.
Vector axis_across(const Vector& v) {
  const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
  if (x <= y && x <= z) return {1, 0, 0};
  return y <= z ? Vector{0, 1, 0} : Vector{0, 0, 1};
}

/// How far round the way along the edges of the square with its corners on the axes leads.
double turn_of(double x, double y) {
  const double share = y / (std::fabs(x) + std::fabs(y));
  if (x >= 0) return share;
  return y >= 0 ? 2 - share : -2 - share;
}

}  // namespace

LightCylinder::LightCylinder(const LinearLight& light) : start_(light.start) {
  const Vector way = light.end - light.start;
  along_ = of_length_one(way);
  first_ = of_length_one(cross(along_, axis_across(along_)));
  second_ = cross(along_, first_);
  length_ = dot(way, along_);
}

LightCylinder::Across LightCylinder::across(const Point3& p) const {
  const Vector step = p - start_;
  return {dot(step, first_), dot(step, second_)};
}

CylinderPlace LightCylinder::place_of(const Point3& p) const {
  const Vector step = p - start_;
  const double x = dot(step, first_);
  const double y = dot(step, second_);
  CylinderPlace place;
  place.distance = std::sqrt(x * x + y * y);
  place.along = dot(step, along_);
  place.error = 0x1p-44 * root_of_three * size_of(step) + tiny;
  const double doubt = place.error / place.distance;
  const bool is_clear = doubt <= widest_turn_error / 4;
  place.turn = is_clear ? turn_of(x, y) : 0;
  place.turn_error = is_clear ? 0x1p-40 + 2 * doubt : HUGE_VAL;
  return place;
}

LightCylinder::Across LightCylinder::nearest(std::span<const Point3> points, std::span<const PointPair> edges) const {
  Across best;
  double least = HUGE_VAL;
  for (const auto& [from, to] : edges) {
    const Across a = across(points[from]);
    const Across b = across(points[to]);
    const double x = b.x - a.x, y = b.y - a.y;
    const double whole = x * x + y * y;
    const double share = whole > 0 ? std::clamp(-(a.x * x + a.y * y) / whole, 0.0, 1.0) : 0;
    const Across foot{a.x + share * x, a.y + share * y};
    const double square = foot.x * foot.x + foot.y * foot.y;
    if (square < least) best = foot;
    least = std::min(least, square);
  }
  return best;
}

CylinderBox LightCylinder::box_of(std::span<const Point3> points, std::span<const PointPair> edges) const {
  const double start = place_of(points.front()).turn;
  double left = 0, right = 0, turn_error = 0;
  CylinderBox box{0, 0, HUGE_VAL, 0, HUGE_VAL, -HUGE_VAL};
  for (const Point3& p : points) {
    const CylinderPlace place = place_of(p);
    double turned = place.turn - start;
    if (turned > 2) turned -= 4;
    if (turned < -2) turned += 4;
    left = std::min(left, turned);
    right = std::max(right, turned);
    turn_error = std::max(turn_error, place.turn_error);
    box.high_distance = std::max(box.high_distance, place.distance + place.error);
    box.low_along = std::min(box.low_along, place.along - place.error);
    box.high_along = std::max(box.high_along, place.along + place.error);
  }
  box.low_turn = start + left - turn_error;
  box.high_turn = start + right + turn_error;
  const Across near = nearest(points, edges);
  const double length = std::sqrt(near.x * near.x + near.y * near.y);
  if (!(box.high_turn - box.low_turn < 2 - 0x1p-20) || !(length > 0)) {
    return {-3, 3, 0, box.high_distance, box.low_along, box.high_along};
  }
  for (const Point3& p : points) {
    const Across a = across(p);
    const double height = (a.x * near.x + a.y * near.y) / length;
    box.low_distance = std::min(box.low_distance, height - place_of(p).error);
  }
  box.low_distance = std::max(box.low_distance, 0.0);
  return box;
}

}  // namespace gnomon::viewpoint
