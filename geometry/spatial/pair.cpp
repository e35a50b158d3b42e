#include "geometry/spatial/pair.h"

#include <algorithm>

#include "geometry/spatial/contact_walk.h"
#include "geometry/spatial/pair_sides.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

/// In standard position all of a blocker lies on one side of the light's plane, and the other way round.
Ring light_ring(const Light& light, const PairSides& sides) {
  if (const auto* point = std::get_if<PointLight>(&light)) return Ring(*point);
  if (const auto* line = std::get_if<LinearLight>(&light)) return Ring(*line);
  return Ring(std::get<AreaLight>(light).polygon, sides.blocker.positive);
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

std::vector<TouchedCorners> contacts(const StandardPair& pair, int outward) {
  std::vector<TouchedCorners> contacts(pair.blocker.size());
  for_each_contact(pair, outward, [&](std::uint32_t k, const TouchedCorners& touched) { contacts[k] = touched; });
  return contacts;
}

}  // namespace

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

StandardPair standard_pair(const Light& light, const ConvexPolygon& blocker, const PairSides& sides) {
  return {light_ring(light, sides), Ring(blocker, sides.light.negative), sides.orientation};
}

StandardPair standard_pair(const Light& light, const ConvexPolygon& blocker) {
  const PairSides sides = pair_sides(light, blocker);
  if (pair_position(light, sides) != Position::standard) {
    throw PreconditionError("the light and the blocker are not in standard position");
  }
  return standard_pair(light, blocker, sides);
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
