#include "gnomon/pair.h"

#include <algorithm>

#include "geometry/spatial/contact_walk.h"

namespace gnomon {
namespace {

/// The vertex that names a contact: the one of lowest index among all that touch.
LightVertex touching_vertex(const Ring& light, const TouchedCorners& touched) {
  if (touched.holds_light) return LightVertex{0};
  if (touched.first != touched.last) return LightVertex{light.side_lowest_vertex(touched.first)};
  return LightVertex{light.corner_index(touched.first)};
}

/// Passes on what for_each_contact finds: the plane through each blocker side, at the side's place in the file's order.
auto blocker_planes_into(std::vector<BlockerPlane>& planes, const StandardPair& pair) {
  planes.resize(pair.blocker.size());
  return [&](std::uint32_t k, const TouchedCorners& touched) {
    planes[pair.blocker.forward_side(k)] = blocker_plane(pair, k, touched);
  };
}

/// Collects light planes, which come in the cyclic order of the light's sides, each at most once.
class LightPlaneCollector {
 public:
  LightPlaneCollector(std::vector<LightPlane>& planes, const StandardPair& pair) : planes_(planes), pair_(pair) {
    planes_.reserve(pair.light.size());
  }

  /// The light sides from light corner `from` to `to`, each with the blocker corner.
  void add(std::uint32_t from, std::uint32_t to, std::uint32_t blocker_corner) {
    for (std::uint32_t j = from; j != to; j = pair_.light.next(j)) {
      if (j < latest_) first_ = static_cast<std::ptrdiff_t>(planes_.size());
      latest_ = j;
      planes_.push_back(light_plane(pair_, {j, blocker_corner}));
    }
  }

  /// Puts the planes into the file's order of the sides.
  void finish() {
    std::rotate(planes_.begin(), planes_.begin() + first_, planes_.end());
    if (pair_.light.reversed()) std::reverse(planes_.begin(), planes_.end());
  }

 private:
  std::vector<LightPlane>& planes_;
  const StandardPair& pair_;
  std::uint32_t latest_ = 0;
  std::ptrdiff_t first_ = 0;  ///< where the side of lowest number stands
};

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
  ExtremalPlanes planes;
  const auto add_separating = blocker_planes_into(planes.separating_blocker, pair);
  LightPlaneCollector between(planes.separating_light, pair);
  TouchedCorners first{};
  TouchedCorners before{};
  for_each_contact(pair, -1, [&](std::uint32_t k, const TouchedCorners& touched) {
    add_separating(k, touched);
    if (k == 0) {
      first = touched;
    } else {
      between.add(before.last, touched.first, k);
    }
    before = touched;
  });
  between.add(before.last, first.first, 0);
  between.finish();
  for_each_contact(pair, +1, blocker_planes_into(planes.supporting_blocker, pair));
  return planes;
}

ExtremalPlanes extremal_planes(const Light& light, const ConvexPolygon& blocker) {
  return extremal_planes(standard_pair(light, blocker));
}

}  // namespace gnomon
