#include "apps/gnomon/receiver_reflection.h"

#include <array>
#include <cstddef>
#include <vector>

#include "apps/gnomon/receiver_rows.h"
#include "apps/gnomon/viewed_surface.h"
#include "geometry/parallel.h"
#include "gnomon/irradiance.h"
#include "gnomon/visibility.h"
#include "shading/receiver_grid.h"

namespace gnomon {
namespace {

/// The pieces of one side of a receiver and one light.
class SideSeen {
 public:
  SideSeen(const SpaceScene& scene, const PreparedObstacles& obstacles, std::span<const ReceiverResult> side,
           const ReceiverViews& seen, unsigned threads)
      : scene_(scene),
        light_(scene.lights[side.front().light_id]),
        unit_(*length_unit_named(scene.length_unit)),
        own_(obstacles.obstacles().blockers),
        eye_(eye_named(seen.eye, scene)),
        surface_(scene, {{light_.name, {&light_}}}, chosen_material(seen.material, side.front().side, scene).material,
                 obstacles, {threads, {}}) {
    for (unsigned t = 0; t < threads; ++t) irradiance_.emplace_back(light_.shape, light_.strength, obstacles);
  }

  void tell(ReceiverResult& piece) {
    const ConvexPolygon& facet = scene_.receivers[piece.receiver_id].shape;
    const Point3 normal = ReceiverGrid(facet, {1, 1}).normal();
    const ReceiverPoint there{{}, facet_front(facet), own_.of(facet)};
    const std::vector<Point3> points = piece.mesh.drawing().points;
    piece.irradiance.resize(points.size());
    piece.radiance.resize(points.size());
    for_all(points.size(), static_cast<unsigned>(irradiance_.size()), [&](std::size_t i, std::size_t worker) {
      ReceiverPoint receiver = there;
      receiver.point = points[i];
      piece.irradiance[i] = per_square_metre(irradiance_[worker].received(receiver, normal), light_.shape, unit_);
      piece.radiance[i] = surface_.at(worker, receiver, normal, eye_).lights.front();
    });
  }

 private:
  const SpaceScene& scene_;
  const SceneLight& light_;
  LengthUnit unit_;
  OwnBlockers own_;
  std::array<double, 3> eye_;
  ViewedSurface surface_;
  std::vector<LightIrradiance> irradiance_;  ///< of every worker
};

}  // namespace

void add_reflection(DiscontinuityResult& result, const DivisionPlan& plan, const ReceiverViews& seen,
                    const Effort& effort) {
  const PreparedObstacles obstacles(plan.bodies.obstacles);
  std::size_t first = 0;
  for (const SideResult side : sides_of(result.receivers)) {
    SideSeen eye(*plan.space, obstacles, side, seen, thread_count(effort.threads));
    for (std::size_t k = 0; k < side.size(); ++k) eye.tell(result.receivers[first + k]);
    first += side.size();
  }
}

}  // namespace gnomon
