#include "geometry/discontinuity/shaft.h"

#include <algorithm>
#include <cmath>

#include "geometry/rounding.h"

namespace gnomon::event {
namespace {

using Vector = std::array<double, 3>;

Vector difference(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double sum_norm(const Vector& a) {
  return std::fabs(a[0]) + std::fabs(a[1]) + std::fabs(a[2]);
}

/// Points of the shaft at finite places, and a direction towards the light if that is infinitely far away.
class ShaftBuilder {
 public:
  ShaftBuilder(const EventScene& scene, std::span<const ExactVector> points) {
    for (const ExactVector& p : points) add({nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)});
    face_ = points_.size();
    for (const LightVertex& v : scene.light_vertices) {
      const EventPoint& p = scene.points[v.point];
      p.kind == EventPoint::Kind::direction ? void(ways_.push_back({p.input.x, p.input.y, p.input.z})) : add(p.input);
    }
  }

  std::vector<RoughHalfSpace> half_spaces() {
    // Planes along the coordinate axes and along the middle way to the light.
    const Vector middle = way_to_light();
    const Vector axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Vector& axis : axes) {
      try_normal(axis);
      try_normal(cross(axis, middle));
    }
    // Planes through an edge of the light and a point of the face.
    for (std::size_t i = face_; i < points_.size(); ++i) {
      const std::size_t j = i + 1 < points_.size() ? i + 1 : face_;
      for (std::size_t k = 0; k < std::min<std::size_t>(face_, 8); ++k) {
        try_normal(cross(difference(points_[i], points_[k]), difference(points_[j], points_[k])));
      }
    }
    return std::move(found_);
  }

 private:
  void add(const Point3& p) {
    points_.push_back(p);
    size_ = std::max({size_, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }

  Vector way_to_light() const {
    if (!ways_.empty()) return ways_.front();
    return difference(points_.back(), points_.front());
  }

  /// Both half-spaces of planes with this normal that hold everything.
  void try_normal(const Vector& normal) {
    for (const double sign : {1.0, -1.0}) {
      const Vector n{sign * normal[0], sign * normal[1], sign * normal[2]};
      const double rounding = 0x1p-44 * sum_norm(n);
      if (std::any_of(ways_.begin(), ways_.end(),
                      [&](const Vector& w) { return dot(n, w) < -rounding * sum_norm(w); })) {
        continue;
      }
      const auto lowest = std::min_element(points_.begin(), points_.end(), [&](const Point3& p, const Point3& q) {
        return dot(n, {p.x, p.y, p.z}) < dot(n, {q.x, q.y, q.z});
      });
      found_.push_back({n, *lowest, rounding, 4 * rounding * size_ + 0x1p-1000});
    }
  }

  std::vector<Point3> points_;
  std::vector<Vector> ways_;
  std::size_t face_ = 0;
  double size_ = 0;
  std::vector<RoughHalfSpace> found_;
};

}  // namespace

std::vector<RoughHalfSpace> shaft(const EventScene& scene, std::span<const ExactVector> points) {
  return ShaftBuilder(scene, points).half_spaces();
}

}  // namespace gnomon::event
