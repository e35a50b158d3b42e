#include "shading/receiver_grid.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/numbers/orientation.h"
#include "geometry/planar/orientation.h"
#include "shading/exact_direction.h"
#include "shading/vector.h"

namespace gnomon {
namespace {

using shading::length;
using shading::length_above;
using shading::of_size_one;
using shading::scaled;
using shading::Vector;

Vector vector(const Point3& p) {
  return {p.x, p.y, p.z};
}

Point3 point_of(const Vector& v) {
  return {v.x, v.y, v.z};
}

/// The shares of a direction between which the corners lie.
struct Range {
  double low = 0;
  double high = 0;
};

Range range(std::span<const Vector> corners, const Vector& direction) {
  Range result;
  for (const Vector& corner : corners) {
    const double share = dot(corner, direction) / dot(direction, direction);
    result = {std::min(result.low, share), std::max(result.high, share)};
  }
  return result;
}

/// Of unit length, at right angles to the polygon.
Vector unit_normal(std::span<const Point3> corners) {
  std::vector<ExactVector> polygon;
  for (const Point3& corner : corners) polygon.push_back(exact(corner));
  const Vector normal = shading::direction_of(doubled_area(polygon));
  return 1 / length(normal) * normal;
}

/// The corners relative to the first, all divided by 2^exponent: the largest coordinate is from 1 to 2.
struct RelativeCorners {
  std::vector<Vector> corners;
  int exponent = 0;
};

RelativeCorners relative_corners(std::span<const Point3> corners) {
  RelativeCorners result;
  // A quarter of what differs by more than the largest double.
  const bool huge =
      std::any_of(corners.begin(), corners.end(), [](const Point3& p) { return shading::exponent(vector(p)) > 1020; });
  const int before = huge ? 2 : 0;
  for (const Point3& corner : corners) {
    result.corners.push_back(scaled(vector(corner), -before) + -1 * scaled(vector(corners[0]), -before));
  }
  int size = shading::exponent(result.corners[1]);
  for (const Vector& corner : result.corners) {
    if (length_above(corner) > 0) size = std::max(size, shading::exponent(corner));
  }
  for (Vector& corner : result.corners) corner = scaled(corner, -size);
  result.exponent = size + before;
  return result;
}

/// The point without the coordinate that is largest in the normal.
Point2 flattened(const Point3& p, const Point3& normal) {
  const double x = std::fabs(normal.x);
  const double y = std::fabs(normal.y);
  const double z = std::fabs(normal.z);
  if (x >= y && x >= z) return {p.y, p.z};
  return y >= z ? Point2{p.x, p.z} : Point2{p.x, p.y};
}

}  // namespace

ReceiverGrid::ReceiverGrid(const ConvexPolygon& receiver, const std::array<std::uint32_t, 2>& shape) : shape_(shape) {
  for (const std::uint32_t i : receiver.corners()) corners_.push_back(receiver.points()[i]);
  const auto [corners, exponent] = relative_corners(corners_);
  const Vector normal = unit_normal(corners_);
  const Vector u = of_size_one(corners[1]);
  const Vector v = cross(normal, u);
  const Range along_u = range(corners, u);
  const Range along_v = range(corners, v);
  const auto in_true_size = [power = exponent](const Vector& d) { return scaled(d, power); };
  const Vector first = in_true_size(along_u.low * u + along_v.low * v);
  origin_ = point_of(vector(corners_[0]) + first);
  u_ = point_of(in_true_size((along_u.high - along_u.low) * u));
  v_ = point_of(in_true_size((along_v.high - along_v.low) * v));
  normal_ = point_of(normal);
}

Point3 ReceiverGrid::point(std::size_t index) const {
  const std::size_t column = index % shape_[0], row = index / shape_[0];
  const double s = (static_cast<double>(column) + 0.5) / shape_[0];
  const double t = (static_cast<double>(row) + 0.5) / shape_[1];
  return {origin_.x + s * u_.x + t * v_.x, origin_.y + s * u_.y + t * v_.y, origin_.z + s * u_.z + t * v_.z};
}

bool ReceiverGrid::has_finite_points() const {
  // What is added on the way is largest at the ends of rows.
  for (const std::size_t corner : {std::size_t{0}, std::size_t{shape_[0]} - 1, size() - shape_[0], size() - 1}) {
    const Point3 p = point(corner);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
  }
  return true;
}

bool ReceiverGrid::is_on_receiver(const Point3& point) const {
  const Point2 p = flattened(point, normal_);
  bool left = false;
  bool right = false;
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Point3& next = corners_[k + 1 == corners_.size() ? 0 : k + 1];
    const int side = planar::orientation(flattened(corners_[k], normal_), flattened(next, normal_), p);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !left || !right;
}

/// Of differences from the first corner, so that no sum overflows.
Point3 mean_of_corners(const ConvexPolygon& polygon) {
  const std::span<const std::uint32_t> corners = polygon.corners();
  const Point3& first = polygon.points()[corners[0]];
  Point3 mean = first;
  const auto count = static_cast<double>(corners.size());
  for (const std::uint32_t i : corners) {
    const Point3& p = polygon.points()[i];
    mean.x += p.x / count - first.x / count;
    mean.y += p.y / count - first.y / count;
    mean.z += p.z / count - first.z / count;
  }
  return mean;
}

Point3 moved_along(const Point3& p, const Point3& normal, double length) {
  const Vector n = of_size_one(vector(normal));
  const double step = length / shading::length(n);
  return {p.x + step * n.x, p.y + step * n.y, p.z + step * n.z};
}

}  // namespace gnomon
