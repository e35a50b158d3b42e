#include "shading/illumination/lights_together.h"

#include "geometry/bodies/own_blockers.h"
#include "geometry/numbers/vector3.h"

namespace gnomon::illumination {

LightsTogether::LightsTogether(std::span<const IlluminationLight> lights, const Obstacles& obstacles,
                               std::span<const ConvexPolygon> receivers, const LengthUnit& unit, unsigned workers)
    : lights_(lights.size()), unit_(unit), of_workers_(workers) {
  const OwnBlockers own(obstacles.blockers);
  for (const ConvexPolygon& receiver : receivers) {
    const FacetFront front = facet_front(receiver);
    const auto& [a, b, c] = front.corners;
    const Vector3<double> normal = cross(step(a, b), step(a, c));
    receivers_.push_back({{{}, front, own.of(receiver)}, {normal.x, normal.y, normal.z}});
  }
  const PreparedObstacles prepared(obstacles);
  for (std::uint32_t l = 0; l < lights.size(); ++l) {
    for (const Light& part : lights[l].parts) {
      parts_.push_back({part, l});
      for (auto& worker : of_workers_) worker.emplace_back(part, lights[l].strength, prepared);
    }
  }
}

std::vector<Irradiance> LightsTogether::each(std::size_t worker, std::uint32_t receiver, const Point3& p) {
  evaluations_.fetch_add(1, std::memory_order_relaxed);
  ReceiverPoint there = receivers_[receiver].point;
  there.point = p;
  std::vector<Irradiance> of_lights(lights_);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Irradiance found = of_workers_[worker][k].received(there, receivers_[receiver].normal);
    const Irradiance parts[] = {of_lights[parts_[k].of], per_square_metre(found, parts_[k].light, unit_)};
    of_lights[parts_[k].of] = k == 0 || parts_[k - 1].of != parts_[k].of ? parts[1] : total_irradiance(parts);
  }
  return of_lights;
}

Irradiance LightsTogether::sum(std::size_t worker, std::uint32_t receiver, const Point3& p) {
  return total_irradiance(each(worker, receiver, p));
}

}  // namespace gnomon::illumination
