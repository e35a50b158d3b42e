#include "geometry/spatial/hull_pair.h"

#include <utility>

namespace gnomon {

HullPair::HullPair(Hull light_hull, Hull blocker_hull)
    : light(std::move(light_hull)), blocker(std::move(blocker_hull)) {
  if (!light.at_infinity) orientation_.include(light.corners);
  orientation_.include(blocker.corners);
  orientation_.close();
  facet_sides_.reserve(blocker.facets.size() * light.corners.size());
  for (std::uint32_t f = 0; f < blocker.facets.size(); ++f) {
    for (std::uint32_t j = 0; j < light.corners.size(); ++j) {
      const int side =
          side_of_light(blocker.facet_point(f, 0), blocker.facet_point(f, 1), blocker.facet_point(f, 2), j);
      facet_sides_.push_back(static_cast<std::int8_t>(side));
    }
  }
}

}  // namespace gnomon
