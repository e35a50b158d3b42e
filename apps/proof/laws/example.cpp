#include "apps/proof/laws/example.h"

#include <utility>

namespace gnomon::laws {
namespace {

BlockerShape scene_shape(const ConvexBlocker& blocker) {
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) return *polygon;
  const auto points = std::get<ConvexSolid>(blocker).points();
  return Polytope{{points.begin(), points.end()}};
}

std::string blocker_name(std::size_t i) {
  return "blocker_" + std::to_string(i);
}

}  // namespace

Example spatial_example(const Light& light, std::span<const ConvexBlocker> blockers, std::vector<Point3> points) {
  SpaceScene scene;
  scene.lights.push_back({"light", light});
  for (const ConvexBlocker& blocker : blockers) {
    scene.blockers.push_back({blocker_name(scene.blockers.size()), scene_shape(blocker)});
  }
  return {std::move(scene), std::move(points)};
}

Example planar_example(std::span<const Point2> light, std::span<const planar::BlockerSegment> blockers,
                       std::span<const Point2> points) {
  PlaneScene scene;
  scene.lights.push_back({"light", {light.begin(), light.end()}});
  for (const planar::BlockerSegment& blocker : blockers) {
    scene.blockers.push_back({blocker_name(scene.blockers.size()), {blocker.begin(), blocker.end()}});
  }
  Example result{std::move(scene), {}};
  for (const Point2& p : points) result.points.push_back({p.x, p.y, 0});
  return result;
}

}  // namespace gnomon::laws
