#include "geometry/spatial/pair.h"

#include <algorithm>

#include "geometry/errors.h"
#include "geometry/spatial/position.h"

namespace gnomon {
namespace {

Ring light_ring(const Light& light, const Point3& blocker_point) {
  if (const auto* point = std::get_if<PointLight>(&light)) return Ring(*point);
  if (const auto* line = std::get_if<LinearLight>(&light)) return Ring(*line);
  const ConvexPolygon& polygon = std::get<AreaLight>(light).polygon;
  const Ring forward(polygon, false);
  const int side = exact_orientation(forward.corner(0), forward.corner(1), forward.corner(2), blocker_point);
  return Ring(polygon, side > 0);
}

Ring blocker_ring(const ConvexPolygon& blocker, const Point3& light_point) {
  const Ring forward(blocker, false);
  const int side = exact_orientation(forward.corner(0), forward.corner(1), forward.corner(2), light_point);
  return Ring(blocker, side < 0);
}

/// Walks the extremal light corner around an area light. `outward` is +1 for supporting planes (no light corner on the
/// positive side), -1 for separating planes (none on the negative side).
/// While the blocker side advances, the extremal corner only moves forward: both rings turn the same way, and the
/// blocker lies strictly on one side of the light's plane.
std::vector<TouchedCorners> walk_area_light(const StandardPair& pair, int outward) {
  const Ring& light = pair.light;
  const Ring& blocker = pair.blocker;
  std::vector<TouchedCorners> contacts(blocker.size());
  Point3 start = blocker.corner(0);
  Point3 end = blocker.corner(1);
  const auto gain = [&](std::uint32_t from, std::uint32_t to) {
    return outward * pair.orientation(start, end, light.corner(from), light.corner(to));
  };
  std::uint32_t j = 0;
  for (std::uint32_t candidate = 1; candidate < light.size(); ++candidate) {
    if (gain(j, candidate) > 0) j = candidate;
  }
  if (gain(j, light.previous(j)) == 0) j = light.previous(j);
  for (std::uint32_t k = 0;; ++k) {
    int step = gain(j, light.next(j));
    for (; step > 0; step = gain(j, light.next(j))) j = light.next(j);
    contacts[k] = {j, step == 0 ? light.next(j) : j, false};
    if (k + 1 == blocker.size()) return contacts;
    start = end;
    end = blocker.corner(blocker.next(k + 1));
  }
}

/// Signs of (blocker side, light start, light end) for a linear light.
std::vector<int> linear_light_signs(const StandardPair& pair) {
  std::vector<int> signs(pair.blocker.size());
  for (std::uint32_t k = 0; k < signs.size(); ++k) {
    signs[k] = pair.orientation(pair.blocker.corner(k), pair.blocker.corner(pair.blocker.next(k)), pair.light.corner(0),
                                pair.light.corner(1));
  }
  return signs;
}

/// A side coplanar with the light is touched by both ends; which end comes first is what its neighbours touch.
std::vector<TouchedCorners> linear_light_contacts(const StandardPair& pair, int outward) {
  const std::vector<int> signs = linear_light_signs(pair);
  const std::uint32_t size = pair.blocker.size();
  const auto touched = [&](std::uint32_t k) { return outward * signs[k] > 0 ? 1u : 0u; };
  std::vector<TouchedCorners> contacts(size);
  for (std::uint32_t k = 0; k < size; ++k) {
    std::uint32_t before = k;
    while (signs[before] == 0) before = pair.blocker.previous(before);
    std::uint32_t after = k;
    while (signs[after] == 0) after = pair.blocker.next(after);
    contacts[k] = {touched(before), touched(after), signs[k] == 0};
  }
  return contacts;
}

std::vector<TouchedCorners> contacts(const StandardPair& pair, int outward) {
  if (pair.light.size() == 1) return std::vector<TouchedCorners>(pair.blocker.size(), {0, 0, true});
  return pair.light.size() == 2 ? linear_light_contacts(pair, outward) : walk_area_light(pair, outward);
}

void include_corners(OrientationFilter& filter, const Ring& ring) {
  for (std::uint32_t k = 0; k < ring.size(); ++k) filter.include(ring.corner(k));
}

}  // namespace

StandardPair standard_pair(const Light& light, const ConvexPolygon& blocker) {
  if (pair_position(light, blocker) != Position::standard) {
    throw PreconditionError("the light and the blocker are not in standard position");
  }
  const Ring lights = light_ring(light, blocker.points().front());
  const Ring blockers = blocker_ring(blocker, lights.corner(0));
  StandardPair pair{lights, blockers, {}};
  include_corners(pair.orientation, pair.light);
  include_corners(pair.orientation, pair.blocker);
  pair.orientation.close();
  return pair;
}

std::vector<TouchedCorners> separating_contacts(const StandardPair& pair) {
  return contacts(pair, -1);
}

std::vector<TouchedCorners> supporting_contacts(const StandardPair& pair) {
  return contacts(pair, +1);
}

bool light_line_meets_blocker(const StandardPair& pair) {
  if (pair.light.size() != 2) return false;
  const std::vector<int> signs = linear_light_signs(pair);
  const auto [low, high] = std::minmax_element(signs.begin(), signs.end());
  return *low * *high >= 0;
}

}  // namespace gnomon
