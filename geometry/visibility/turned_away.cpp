#include "geometry/visibility/turned_away.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <utility>

#include "geometry/bodies/boxes.h"
#include "geometry/numbers/orientation.h"

namespace gnomon::viewpoint {
namespace {

using Content = BlockerSet::Content;

/// Flat blockers that share edges, as sets; and of each set's root whether it has no other edge and where it lies.
struct Surfaces {
  boost::disjoint_sets_with_storage<> sets;
  std::vector<bool> is_closed;
  std::vector<Box3> boxes;
};

Surfaces surfaces_of(const Content& blockers) {
  const std::size_t count = blockers.shapes.size();
  Surfaces result{boost::disjoint_sets_with_storage<>(count), std::vector<bool>(count, true),
                  std::vector<Box3>(count, empty_box3())};
  for (std::uint32_t s = 0; s < count; ++s) {
    const Content::Shape& shape = blockers.shapes[s];
    for (std::uint32_t k = shape.first; k < shape.first + shape.count; ++k) {
      if (blockers.mates[k].shape != Content::Mate::none) result.sets.union_set(s, blockers.mates[k].shape);
    }
  }
  for (std::uint32_t s = 0; s < count; ++s) {
    const Content::Shape& shape = blockers.shapes[s];
    const std::size_t root = result.sets.find_set(s);
    if (shape.solid >= 0) result.is_closed[root] = false;
    for (std::uint32_t k = shape.first; k < shape.first + shape.count; ++k) {
      if (!blockers.mates[k].is_opposite) result.is_closed[root] = false;
      include(result.boxes[root], blockers.points[k]);
    }
  }
  return result;
}

bool is_before(const Point3& p, std::span<const Point3> facet) {
  return exact_orientation(facet[0], facet[1], facet[2], p) > 0;
}

}  // namespace

TurnedAway::TurnedAway(const Content& blockers, std::span<const Point3> light) {
  Surfaces surfaces = surfaces_of(blockers);
  const Box3 around_light = box_around(light);
  box_of_.assign(blockers.shapes.size(), none);
  for (std::uint32_t s = 0; s < blockers.shapes.size(); ++s) {
    const std::size_t root = surfaces.sets.find_set(s);
    if (!surfaces.is_closed[root] || overlap(surfaces.boxes[root], around_light)) continue;
    const std::span<const Point3> facet = blockers.corners(blockers.shapes[s]);
    const bool has_light_before =
        std::any_of(light.begin(), light.end(), [&](const Point3& corner) { return is_before(corner, facet); });
    if (!has_light_before) box_of_[s] = static_cast<std::uint32_t>(root);
  }
  boxes_ = std::move(surfaces.boxes);
}

void TurnedAway::remove_from(std::vector<std::uint32_t>& found, const Point3& point) const {
  std::erase_if(found, [&](std::uint32_t b) { return box_of_[b] != none && !holds(boxes_[box_of_[b]], point); });
}

}  // namespace gnomon::viewpoint
