#include "apps/proof/report/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/proof/report/draws.h"
#include "apps/proof/report/embree_visibility.h"
#include "apps/proof/report/measurement.h"
#include "apps/proof/report/shapes.h"
#include "apps/proof/report/triangle_scenes.h"
#include "apps/proof/report/vectors.h"
#include "gnomon/visibility.h"

namespace gnomon::report {
namespace {

/// Triangles stay exactly flat however their corners are rounded.
struct Scene {
  AreaLight light{ConvexPolygon::from_points({{-.5, -.5, 4}, {0, .5, 4}, {.5, -.5, 4}})};
  std::vector<ConvexBlocker> blockers;
  std::vector<Point3> points;
};

Scene scene_at(double distance, std::size_t points) {
  const TriangleScene drawn = triangle_scene(16);
  const Point3 offset{distance, 0, 0};
  Scene scene;
  scene.light = mapped(scene.light, 1, offset);
  for (const ConvexBlocker& blocker : drawn.blockers) scene.blockers.push_back(mapped(blocker, 1, offset));
  for (std::size_t i = 0; i < points; ++i) scene.points.push_back(sum(drawn.points[i], offset));
  return scene;
}

using Turn = std::array<Point3, 3>;

/// By a random unit quaternion.
Turn random_turn(Draws& draws) {
  std::array<double, 4> q{};
  double squared = 0;
  do {
    for (double& component : q) component = draws.between(-1, 1);
    squared = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  } while (squared < 0.1 || squared > 1);
  for (double& component : q) component /= std::sqrt(squared);
  const auto& [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

Point3 turned(const Turn& turn, const Point3& p) {
  return {dot(turn[0], p), dot(turn[1], p), dot(turn[2], p)};
}

ConvexPolygon turned(const Turn& turn, const ConvexPolygon& polygon) {
  std::vector<Point3> points;
  for (const Point3& p : polygon.points()) points.push_back(turned(turn, p));
  return ConvexPolygon::from_points(std::move(points));
}

Scene turned(const Turn& turn, const Scene& scene) {
  Scene result;
  result.light.polygon = turned(turn, scene.light.polygon);
  for (const ConvexBlocker& blocker : scene.blockers) {
    result.blockers.emplace_back(turned(turn, std::get<ConvexPolygon>(blocker)));
  }
  for (const Point3& p : scene.points) result.points.push_back(turned(turn, p));
  return result;
}

/// What is said of a scene's points.
struct Answers {
  std::vector<Visibility> exact;
  std::vector<Visibility> gnomon;
  std::vector<double> embree;
};

Answers answers(const Scene& scene) {
  const Obstacles obstacles{scene.blockers, {}};
  LightVisibility gnomon(scene.light, PreparedObstacles(obstacles));
  EmbreeVisibility embree(scene.light, scene.blockers);
  embree.place(Placing::regular, 16);
  Answers result;
  for (const Point3& p : scene.points) {
    result.exact.push_back(exact_visibility(scene.light, obstacles, p));
    result.gnomon.push_back(gnomon.at(p));
    result.embree.push_back(embree.visible_from(p, {0, 0, 1}).fraction);
  }
  return result;
}

bool is_wrong(const Visibility& found, const Visibility& truth) {
  return found.region != truth.region ||
         std::fabs(found.fraction - truth.fraction) > found.error_bound + truth.error_bound;
}

RotationResult rotated_at(double distance, Effort effort) {
  const Scene scene = scene_at(distance, effort == Effort::quick ? 16 : 64);
  const Answers before = answers(scene);
  RotationResult result;
  result.distance = distance;
  Errors exact, embree;
  Draws draws(1);
  for (std::size_t turns = effort == Effort::quick ? 4 : 32; turns > 0; --turns) {
    const Answers after = answers(turned(random_turn(draws), scene));
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      exact.add(std::fabs(after.exact[i].fraction - before.exact[i].fraction), before.exact[i].fraction);
      embree.add(std::fabs(after.embree[i] - before.embree[i]), before.exact[i].fraction);
      result.regions_changed += after.exact[i].region != before.exact[i].region ? 1 : 0;
      result.wrong_gnomon += is_wrong(after.gnomon[i], after.exact[i]) ? 1 : 0;
    }
  }
  exact.finish();
  embree.finish();
  result.points = exact.results;
  result.rms = exact.rms;
  result.most = exact.most;
  result.embree_rms = embree.rms;
  result.embree_most = embree.most;
  return result;
}

}  // namespace

std::vector<RotationResult> rotation_results(Effort effort) {
  std::vector<RotationResult> results;
  for (const double distance : {0.0, 1e3, 1e6}) results.push_back(rotated_at(distance, effort));
  return results;
}

}  // namespace gnomon::report
