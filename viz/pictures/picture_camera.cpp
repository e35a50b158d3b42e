#include "viz/pictures/picture_camera.h"

#include <vtkBoundingBox.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gnomon/errors.h"
#include "viz/vtk/vector.h"

namespace gnomon::viz {
namespace {

constexpr double elevation = 24 * std::numbers::pi / 180;
constexpr double label_half_height = 10;  ///< in pixels: a label may reach that far beyond its element

/// Toward the camera, at an angle around the up direction.
Point3 direction(const Point3& up, double azimuth) {
  const Point3 x{1, 0, 0};
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
    result = std::max({result, p.toward + std::abs(p.right) / half_width, p.toward + std::abs(p.up) / half_height});
  }
  return result;
}

/// Moving the focus to the middle of what is seen changes the perspective a little; a few rounds settle it.
PictureView framed(const PictureScene& scene, const Point3& toward, const Point3& up, const DrawingSize& size) {
  const Point3 right = unit(cross(up, toward));
  const Point3 upward = cross(toward, right);
  const std::vector<Point3> points = visible_points(scene);
  const double margin = 1 / (1 - 2 * std::max(0.03, label_half_height / size.height));
  PictureView view{{}, points.empty() ? Point3{} : points.front(), up};
  const double half_height = std::tan(view.angle / 2 * std::numbers::pi / 180);
  const double half_width = half_height * size.width / size.height;
  double away = scene.size;
  for (int round = 0; round < 12; ++round) {
    std::vector<Seen> seen;
    for (const Point3& p : points) {
      const Point3 d = p - view.focus;
      seen.push_back({dot(d, right), dot(d, upward), dot(d, toward)});
    }
    away = distance(seen, half_width / margin, half_height / margin);
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

/// Where the front is: toward a viewer who sees x run to the right.
Point3 front_of(const Point3& up) {
  return cross({1, 0, 0}, up);
}

PictureView preset_view(const PictureScene& scene, CameraPreset preset, const DrawingSize& size) {
  const Point3& up = scene.up;
  const Point3 front = front_of(up);
  const Point3 left = cross(front, up);
  switch (preset) {
    case CameraPreset::three_quarter:
      return framed(scene, best_direction(scene, up), up, size);
    case CameraPreset::front:
      return framed(scene, front, up, size);
    case CameraPreset::back:
      return framed(scene, -1 * front, up, size);
    case CameraPreset::left:
      return framed(scene, left, up, size);
    case CameraPreset::right:
      return framed(scene, -1 * left, up, size);
    case CameraPreset::top:
      return framed(scene, up, -1 * front, size);
    case CameraPreset::bottom:
      return framed(scene, -1 * up, front, size);
  }
  return {};
}

Point3 middle_of_box(const std::vector<Point3>& points) {
  vtkBoundingBox box;
  for (const Point3& p : points) box.AddPoint(p.x, p.y, p.z);
  double middle[3] = {0, 0, 0};
  if (box.IsValid()) box.GetCenter(middle);
  return {middle[0], middle[1], middle[2]};
}

PictureView placed_view(const PictureScene& scene, const CameraPlace& place) {
  const Point3 focus = place.focus ? *place.focus : middle_of_box(visible_points(scene));
  const Point3 toward = place.position - focus;
  if (length(toward) == 0) throw PreconditionError("the camera is where it looks");
  Point3 up = place.up.value_or(scene.up);
  const auto along_view = [&] { return length(cross(unit(up), unit(toward))) < 1e-6; };
  if (along_view() && !place.up) up = -1 * front_of(up);
  if (along_view()) throw PreconditionError("the camera's up direction is along its view");
  return {place.position, focus, up};
}

}  // namespace

PictureView picture_view(const PictureScene& scene, const std::variant<CameraPreset, CameraPlace>& camera,
                         const DrawingSize& size) {
  if (const auto* place = std::get_if<CameraPlace>(&camera)) return placed_view(scene, *place);
  return preset_view(scene, std::get<CameraPreset>(camera), size);
}

}  // namespace gnomon::viz
