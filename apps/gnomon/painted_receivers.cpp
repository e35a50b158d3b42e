#include "apps/gnomon/painted_receivers.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "apps/gnomon/receiver_rows.h"
#include "geometry/parallel.h"
#include "gnomon/irradiance.h"
#include "gnomon/visibility.h"
#include "shading/image/irradiance_mesh.h"
#include "shading/receiver_grid.h"

namespace gnomon {
namespace {

using LightOfWorkers = std::shared_ptr<std::vector<LightIrradiance>>;

/// What points on a facet are given by a light.
image::IrradianceAt irradiance_on(const SceneReceiver& receiver, const SceneLight& light, const OwnBlockers& own,
                                  const LightOfWorkers& of_workers, const LengthUnit& unit) {
  const Point3 normal = ReceiverGrid(receiver.shape, {1, 1}).normal();
  const ReceiverPoint there{{}, facet_front(receiver.shape), own.of(receiver.shape)};
  return [=, &light](std::size_t worker, const Point3& p) {
    ReceiverPoint point = there;
    point.point = p;
    return per_square_metre((*of_workers)[worker].received(point, normal), light.shape, unit);
  };
}

PaintedReceiver painted(const ReceiverResult& piece, const image::IrradianceMesh& mesh) {
  PaintedReceiver result{piece.light_id, piece.light, piece.side, {}, {}, mesh.triangles()};
  for (const image::IrradianceMesh::Corner& corner : mesh.corners()) {
    result.points.push_back(corner.point);
    result.irradiance.push_back(corner.irradiance);
  }
  return result;
}

/// The sides under one light, whose irradiances have one scale.
void paint_under_light(std::vector<PaintedReceiver>& all, const SpaceScene& scene, std::span<const SideResult> sides,
                       const PreparedObstacles& obstacles, unsigned threads) {
  const SceneLight& light = scene.lights[sides.front().front().light_id];
  const LengthUnit unit = *length_unit_named(scene.length_unit);
  const OwnBlockers own(obstacles.obstacles().blockers);
  const auto of_workers = std::make_shared<std::vector<LightIrradiance>>();
  for (unsigned t = 0; t < threads; ++t) of_workers->emplace_back(light.shape, light.strength, obstacles);
  std::vector<image::IrradianceMesh> meshes(sides.size());
  double largest = 0;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    for (const ReceiverResult& piece : sides[s]) {
      meshes[s].add(piece.mesh.drawing(),
                    irradiance_on(scene.receivers[piece.receiver_id], light, own, of_workers, unit));
    }
    meshes[s].begin(threads);
    largest = std::max(largest, meshes[s].largest());
  }
  for (std::size_t s = 0; s < sides.size(); ++s) {
    meshes[s].refine(largest, threads);
    all.push_back(painted(sides[s].front(), meshes[s]));
  }
}

}  // namespace

std::vector<PaintedReceiver> painted_receivers(const SpaceScene& scene, std::span<const ReceiverResult> divided,
                                               const Effort& effort) {
  const PreparedObstacles obstacles(scene_bodies(scene).obstacles);
  const std::vector<SideResult> sides = sides_of(divided);
  std::vector<PaintedReceiver> all;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    const auto same_light = [&](SideResult side) { return side.front().light_id == sides[first].front().light_id; };
    while (last < sides.size() && same_light(sides[last])) ++last;
    paint_under_light(all, scene, std::span(sides).subspan(first, last - first), obstacles,
                      thread_count(effort.threads));
  }
  return all;
}

}  // namespace gnomon
