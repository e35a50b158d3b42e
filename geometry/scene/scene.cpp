#include "gnomon/scene.h"

#include <algorithm>
#include <cmath>

#include "geometry/scene/scene_points.h"

namespace gnomon {
namespace {

std::vector<Point3> all_points(const SpaceScene& scene) {
  std::vector<Point3> points;
  const auto add = [&](std::span<const Point3> more) { points.insert(points.end(), more.begin(), more.end()); };
  for (const SceneLight& light : scene.lights) add(light_points(light.shape));
  for (const SceneBlocker& blocker : scene.blockers) add(blocker_points(blocker.shape));
  for (const SceneReceiver& receiver : scene.receivers) add(receiver.shape.points());
  return points;
}

std::vector<Point3> all_points(const PlaneScene& scene) {
  std::vector<Point3> points;
  const auto add = [&](const auto& elements) {
    for (const auto& element : elements) {
      for (const Point2& p : element.vertices) points.push_back({p.x, p.y, 0});
    }
  };
  add(scene.lights);
  add(scene.blockers);
  add(scene.receivers);
  return points;
}

Box3 bounding_box(const std::vector<Point3>& points) {
  Box3 box{points.front(), points.front()};
  for (const Point3& p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  return box;
}

/// Finite and with an interior; false for overflow and for growth that was lost to rounding.
bool is_interval(double min, double max) {
  return std::isfinite(min) && std::isfinite(max) && min < max;
}

struct PointsOf {
  std::span<const Point3> operator()(const ConvexPolygon& polygon) const { return polygon.points(); }
  std::span<const Point3> operator()(const Polytope& polytope) const { return polytope.vertices; }
  std::span<const Point3> operator()(const ConcavePolygon& polygon) const { return polygon.vertices; }
  std::span<const Point3> operator()(const Mesh& mesh) const { return mesh.vertices; }
};

}  // namespace

std::span<const Point3> blocker_points(const BlockerShape& shape) {
  return std::visit(PointsOf{}, shape);
}

const SceneFacts& facts(const Scene& scene) {
  return std::visit([](const SceneFacts& common) -> const SceneFacts& { return common; }, scene);
}

int dimension(const Scene& scene) {
  return std::holds_alternative<PlaneScene>(scene) ? 2 : 3;
}

std::optional<Box3> default_clip_box(const Scene& scene) {
  const bool is_flat = std::holds_alternative<PlaneScene>(scene);
  const std::vector<Point3> points = std::visit([](const auto& some) { return all_points(some); }, scene);
  if (points.empty()) return std::nullopt;
  const auto [min, max] = bounding_box(points);
  const double growth = std::hypot(max.x - min.x, max.y - min.y, max.z - min.z) / 2;
  const double depth = is_flat ? 0 : growth;
  const Box3 box{{min.x - growth, min.y - growth, min.z - depth}, {max.x + growth, max.y + growth, max.z + depth}};
  if (!is_interval(box.min.x, box.max.x) || !is_interval(box.min.y, box.max.y)) return std::nullopt;
  if (!is_flat && !is_interval(box.min.z, box.max.z)) return std::nullopt;
  // Sides may be finite where their difference is not.
  const double diagonal = std::hypot(box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z);
  return std::isfinite(diagonal) ? std::optional(box) : std::nullopt;
}

}  // namespace gnomon
