#include "viz/picture_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viz/vector.h"

namespace gnomon::viz {
namespace {

constexpr double elevation = 24 * std::numbers::pi / 180;
constexpr double margin = 1.06;

Point3 middle_of(const std::vector<PictureBlock>& blocks) {
  Point3 sum;
  double count = 0;
  for (const PictureBlock& block : blocks) {
    for (const Point3& p : points_of(*block.data)) {
      sum = sum + p;
      ++count;
    }
  }
  return count > 0 ? 1 / count * sum : sum;
}

Point3 up_of(const PictureScene& scene) {
  const Point3 to_lights = unit(middle_of(scene.lights) - middle_of(scene.blockers));
  const double x = std::abs(to_lights.x);
  const double y = std::abs(to_lights.y);
  const double z = std::abs(to_lights.z);
  if (z >= 0.5 || z >= std::max(x, y)) return {0, 0, to_lights.z < -0.5 ? -1.0 : 1.0};
  return y >= x ? Point3{0, std::copysign(1.0, to_lights.y), 0} : Point3{std::copysign(1.0, to_lights.x), 0, 0};
}

/// Toward the camera, at an angle around the up direction.
Point3 direction(const Point3& up, double azimuth) {
  const Point3 x = up.x != 0 ? Point3{0, 1, 0} : Point3{1, 0, 0};
  const Point3 level = std::cos(azimuth) * x + std::sin(azimuth) * cross(up, x);
  return std::cos(elevation) * level + std::sin(elevation) * up;
}

double shown_area(const PictureScene& scene, const Point3& to_camera) {
  double area = 0;
  for (const PictureReceiver& receiver : scene.receivers) {
    const double slope = dot(receiver.plane.normal, to_camera);
    area += polygon_area(receiver.polygon) * (receiver.ends_scene ? std::max(slope, 0.0) : std::abs(slope));
  }
  return area;
}

/// The first direction looks along no axis; another one must show a good deal more to be taken instead.
Point3 best_direction(const PictureScene& scene, const Point3& up) {
  Point3 best;
  double most = -1;
  for (const double degrees : {-62.0, -118.0, -28.0, -152.0, 28.0, 152.0, 62.0, 118.0}) {
    const Point3 candidate = direction(up, degrees * std::numbers::pi / 180);
    const double area = shown_area(scene, candidate);
    if (area > 1.02 * most) {
      best = candidate;
      most = area;
    }
  }
  return best;
}

/// A point in the camera's axes, seen from the focus.
struct Seen {
  double right;
  double up;
  double toward;
};

/// How far the camera must be away to see all points.
double distance(const std::vector<Seen>& points, double half_width, double half_height) {
  double result = 0;
  for (const Seen& p : points) {
    result = std::max(
        {result, p.toward + margin * std::abs(p.right) / half_width, p.toward + margin * std::abs(p.up) / half_height});
  }
  return result;
}

}  // namespace

PictureView three_quarter_view(const PictureScene& scene, double width_to_height) {
  const Point3 up = up_of(scene);
  const Point3 toward = best_direction(scene, up);
  const Point3 right = unit(cross(up, toward));
  const Point3 upward = cross(toward, right);
  const std::vector<Point3> points = visible_points(scene);
  PictureView view{{}, points.empty() ? Point3{} : points.front(), up};
  const double half_height = std::tan(view.angle / 2 * std::numbers::pi / 180);
  const double half_width = half_height * width_to_height;

  // Moving the focus to the middle of what is seen changes the perspective a little; a few rounds settle it.
  double away = scene.size;
  for (int round = 0; round < 12; ++round) {
    std::vector<Seen> seen;
    for (const Point3& p : points) {
      const Point3 d = p - view.focus;
      seen.push_back({dot(d, right), dot(d, upward), dot(d, toward)});
    }
    away = distance(seen, half_width, half_height);
    const auto middle = [&](auto side) {
      const auto [low, high] =
          std::ranges::minmax(seen, {}, [&](const Seen& p) { return p.*side / (away - p.toward); });
      return away / 2 * (low.*side / (away - low.toward) + high.*side / (away - high.toward));
    };
    if (!seen.empty()) view.focus = view.focus + middle(&Seen::right) * right + middle(&Seen::up) * upward;
  }
  view.position = view.focus + away * toward;
  return view;
}

bool is_seen_from_inside(const PictureReceiver& receiver, const PictureView& view) {
  return !receiver.ends_scene || receiver.plane.distance(view.position) > 0;
}

}  // namespace gnomon::viz
