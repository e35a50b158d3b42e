#include "geometry/spatial/body_pair.h"

#include <functional>
#include <span>
#include <utility>

namespace gnomon {

BodyPair::BodyPair(Body light_body, Body blocker_body)
    : light(std::move(light_body)), blocker(std::move(blocker_body)) {
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

Sides BodyPair::light_sides(std::uint32_t facet) const {
  return sides(std::span(facet_sides_).subspan(facet * light.corners.size(), light.corners.size()), std::identity{});
}

Sides BodyPair::light_sides(std::uint32_t facet, const std::vector<std::uint32_t>& corners) const {
  return sides(corners, [&](std::uint32_t j) { return facet_side(facet, j); });
}

Sides BodyPair::blocker_sides(std::uint32_t light_facet) const {
  const Point3 &a = light.facet_point(light_facet, 0), &b = light.facet_point(light_facet, 1),
               &c = light.facet_point(light_facet, 2);
  return sides(blocker.corners, [&](const Point3& corner) { return orientation(a, b, c, corner); });
}

}  // namespace gnomon
