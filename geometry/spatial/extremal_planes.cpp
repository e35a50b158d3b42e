#include "geometry/spatial/extremal_planes.h"

#include <algorithm>

#include "geometry/spatial/pair.h"

namespace gnomon {
namespace {

/// The vertex that names a contact: the one of lowest index among all that touch.
LightVertex touching_vertex(const Ring& light, const TouchedCorners& touched) {
  if (touched.holds_light) return LightVertex{0};
  if (touched.first != touched.last) return LightVertex{light.side_lowest_vertex(touched.first)};
  return LightVertex{light.corner_index(touched.first)};
}

std::vector<BlockerPlane> blocker_planes(const StandardPair& pair, const std::vector<TouchedCorners>& contacts) {
  std::vector<BlockerPlane> planes(contacts.size());
  for (std::uint32_t k = 0; k < contacts.size(); ++k) {
    planes[k] = blocker_plane(pair, k, contacts[k]);
  }
  if (pair.blocker.reversed()) std::reverse(planes.begin(), planes.end());
  return planes;
}

}  // namespace

BlockerPlane blocker_plane(const StandardPair& pair, std::uint32_t k, const TouchedCorners& touched) {
  return {BlockerEdge{pair.blocker.side_edge(k)}, touching_vertex(pair.light, touched)};
}

LightPlane light_plane(const StandardPair& pair, const LightSideContact& contact) {
  return {LightEdge{pair.light.side_edge(contact.light_side)},
          BlockerVertex{pair.blocker.corner_index(contact.blocker_corner)}};
}

std::vector<LightSideContact> separating_light_contacts(const StandardPair& pair,
                                                        const std::vector<TouchedCorners>& separating) {
  std::vector<LightSideContact> contacts;
  contacts.reserve(pair.light.size());
  for (std::uint32_t k = 0; k < separating.size(); ++k) {
    const std::uint32_t corner = pair.blocker.next(k);
    for (std::uint32_t j = separating[k].last; j != separating[corner].first; j = pair.light.next(j)) {
      contacts.push_back({j, corner});
    }
  }
  return contacts;
}

ExtremalPlanes extremal_planes(const StandardPair& pair) {
  const std::vector<TouchedCorners> separating = separating_contacts(pair);
  std::vector<LightSideContact> sides = separating_light_contacts(pair, separating);
  std::sort(sides.begin(), sides.end(), [&](const LightSideContact& a, const LightSideContact& b) {
    return pair.light.reversed() ? a.light_side > b.light_side : a.light_side < b.light_side;
  });
  ExtremalPlanes planes;
  planes.separating_blocker = blocker_planes(pair, separating);
  planes.supporting_blocker = blocker_planes(pair, supporting_contacts(pair));
  planes.separating_light.reserve(sides.size());
  for (const LightSideContact& side : sides) planes.separating_light.push_back(light_plane(pair, side));
  return planes;
}

ExtremalPlanes extremal_planes(const Light& light, const ConvexPolygon& blocker) {
  return extremal_planes(standard_pair(light, blocker));
}

}  // namespace gnomon
