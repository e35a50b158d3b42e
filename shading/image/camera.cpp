#include "shading/image/camera.h"

#include <cmath>
#include <numbers>

#include "shading/vector.h"

namespace gnomon::image {
namespace {

using shading::Vector;

Vector unit_vector_of(const Vector& a) {
  const Vector b = shading::of_size_one(a);
  return 1 / shading::length(b) * b;
}

Point3 point_at(const Vector& v) {
  return {v.x, v.y, v.z};
}

}  // namespace

Camera::Camera(const SceneCamera& camera) : eye_(camera.eye) {
  const Vector way{camera.look_at.x - camera.eye.x, camera.look_at.y - camera.eye.y, camera.look_at.z - camera.eye.z};
  const Vector ahead = unit_vector_of(way);
  const Vector right = unit_vector_of(cross(ahead, shading::of_size_one({camera.up.x, camera.up.y, camera.up.z})));
  const Vector down = cross(ahead, right);
  const double distance = shading::length(way);
  const double half_height = distance * std::tan(camera.fov * std::numbers::pi / 360);
  const double pixel = 2 * half_height / camera.height;
  const double half_width = pixel * camera.width / 2;
  corner_ = point_at(distance * ahead + -half_width * right + -half_height * down);
  right_ = point_at(pixel * right);
  down_ = point_at(pixel * down);
}

Ray Camera::ray(double x, double y) const {
  const auto at = [&](double eye, double corner, double right, double down) {
    return eye + (corner + x * right + y * down);
  };
  return {eye_,
          {at(eye_.x, corner_.x, right_.x, down_.x), at(eye_.y, corner_.y, right_.y, down_.y),
           at(eye_.z, corner_.z, right_.z, down_.z)}};
}

}  // namespace gnomon::image
