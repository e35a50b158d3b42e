#include "geometry/discontinuity/shaft.h"

#include <algorithm>
#include <cmath>

namespace gnomon::event {
namespace {

/// Points of the shaft at finite places, and a direction towards the light if that is infinitely far away.
class ShaftBuilder {
 public:
  ShaftBuilder(const EventScene& scene, std::span<const Point3> points) {
    for (const Point3& p : points) add(p);
    face_ = points_.size();
    for (const LightVertex& v : scene.light_vertices) {
      const EventPoint& p = scene.points[v.point];
      p.kind == EventPoint::Kind::direction ? void(ways_.push_back({p.input.x, p.input.y, p.input.z})) : add(p.input);
    }
  }

  std::vector<RoughHalfSpace> half_spaces() {
    // Planes along the coordinate axes and along the middle way to the light.
    const RoughVector middle = way_to_light();
    const RoughVector axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const RoughVector& axis : axes) {
      try_normal(axis);
      try_normal(cross(axis, middle));
    }
    // Planes through an edge of the light and a point of the face.
    for (std::size_t i = face_; i < points_.size(); ++i) {
      const std::size_t j = i + 1 < points_.size() ? i + 1 : face_;
      for (std::size_t k = 0; k < std::min<std::size_t>(face_, 8); ++k) {
        try_normal(cross(step(points_[k], points_[i]), step(points_[k], points_[j])));
      }
    }
    return std::move(found_);
  }

 private:
  void add(const Point3& p) {
    points_.push_back(p);
    size_ = std::max({size_, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }

  RoughVector way_to_light() const {
    if (!ways_.empty()) return ways_.front();
    return step(points_.front(), points_.back());
  }

  /// Both half-spaces of planes with this normal that hold everything.
  void try_normal(const RoughVector& normal) {
    for (const double sign : {1.0, -1.0}) {
      const RoughVector n{sign * normal[0], sign * normal[1], sign * normal[2]};
      const double rounding = 0x1p-44 * sum_norm(n);
      if (std::any_of(ways_.begin(), ways_.end(),
                      [&](const RoughVector& w) { return dot(n, w) < -rounding * sum_norm(w); })) {
        continue;
      }
      const auto lowest = std::min_element(points_.begin(), points_.end(), [&](const Point3& p, const Point3& q) {
        return dot(n, {p.x, p.y, p.z}) < dot(n, {q.x, q.y, q.z});
      });
      found_.push_back({n, *lowest, rounding, 4 * rounding * size_ + 0x1p-1000});
    }
  }

  std::vector<Point3> points_;
  std::vector<RoughVector> ways_;
  std::size_t face_ = 0;
  double size_ = 0;
  std::vector<RoughHalfSpace> found_;
};

}  // namespace

std::vector<RoughHalfSpace> shaft(const EventScene& scene, std::span<const Point3> points) {
  return ShaftBuilder(scene, points).half_spaces();
}

}  // namespace gnomon::event
