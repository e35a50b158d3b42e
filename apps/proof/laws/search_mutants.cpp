#include "apps/proof/laws/law_lists.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/visibility/linear_search/cylinder_boxes.h"

namespace gnomon::laws {
namespace {

using viewpoint::CylinderBox;
using viewpoint::CylinderPlace;
using Keys = std::vector<std::string>;

/// What was asked of a search, and what it found.
struct Asked {
  const LinearLight& light;
  const std::vector<ConvexBlocker>& blockers;
  const LinearSearch& search;
  const std::vector<Point3>& points;
};

bool is_about_light(const LinearSearch& search) {
  return search.strategy == OccluderSearch::light_buffer || search.strategy == OccluderSearch::light_hierarchy;
}

Mutant finding(std::string name, std::string does, Keys caught_by, FoundOccluders (*broken)(const Asked&)) {
  Mutant mutant{std::move(name), std::move(does), Part::found_occluders, {}, std::move(caught_by)};
  mutant.subject.found_occluders = [broken](const LinearLight& light, const std::vector<ConvexBlocker>& blockers,
                                            const LinearSearch& search, const std::vector<Point3>& points) {
    return broken({light, blockers, search, points});
  };
  return mutant;
}

FoundOccluders found(const Asked& asked) {
  return found_occluders(asked.light, asked.blockers, asked.search, asked.points);
}

/// Leaves out the blockers of which `is_lost` is true, in cylindrical coordinates about the light.
template <class IsLost>
FoundOccluders without(const Asked& asked, const IsLost& is_lost) {
  FoundOccluders result = found(asked);
  if (!is_about_light(asked.search)) return result;
  const viewpoint::LightCylinder cylinder(asked.light);
  const BlockerSet blockers(asked.blockers);
  const std::vector<CylinderBox> boxes = cylinder_boxes(cylinder, blockers.content());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const CylinderPlace place = cylinder.place_of(asked.points[i]);
    if (!result[i] || place.turn_error > 1) continue;
    std::erase_if(*result[i], [&](std::uint32_t b) { return !boxes[b].is_all_round() && is_lost(place, boxes[b]); });
  }
  return result;
}

/// The point turned about the light by an angle, rounded.
Point3 turned(const LinearLight& light, const Point3& p, double angle) {
  const viewpoint::Vector way = step(light.start, light.end), from = step(light.start, p);
  const double length = std::sqrt(dot(way, way));
  const viewpoint::Vector axis = (1 / length) * way;
  const viewpoint::Vector along = dot(axis, from) * axis;
  const viewpoint::Vector across = from - along;
  const viewpoint::Vector to = along + std::cos(angle) * across + std::sin(angle) * cross(axis, across);
  return {light.start.x + to.x, light.start.y + to.y, light.start.z + to.z};
}

FoundOccluders in_next_section(const Asked& asked) {
  if (asked.search.strategy != OccluderSearch::light_buffer) return found(asked);
  std::vector<Point3> points;
  for (const Point3& p : asked.points) {
    points.push_back(turned(asked.light, p, 2 * std::numbers::pi / asked.search.parts));
  }
  return found({asked.light, asked.blockers, asked.search, points});
}

FoundOccluders without_far_side_of_seam(const Asked& asked) {
  return without(asked, [](const CylinderPlace& place, const CylinderBox& box) {
    return (box.high_turn > 2 && place.turn < 0) || (box.low_turn < -2 && place.turn > 0);
  });
}

FoundOccluders without_beside_from_left(const Asked& asked) {
  return without(
      asked, [](const CylinderPlace& place, const CylinderBox& box) { return place.along < 0 && box.low_along >= 0; });
}

/// Boxes are wider than what was rounded by about 2^-40 of a turn and 2^-44 of a length.
FoundOccluders without_margins(const Asked& asked) {
  return without(asked, [](const CylinderPlace& place, const CylinderBox& box) {
    const auto beside = [&](double turn) { return turn <= box.low_turn + 0x1p-39 || turn >= box.high_turn - 0x1p-39; };
    return beside(place.turn) && beside(place.turn + 4) && beside(place.turn - 4);
  });
}

FoundOccluders with_one_twice(const Asked& asked) {
  FoundOccluders result = found(asked);
  for (auto& of_point : result) {
    if (of_point && of_point->size() == asked.blockers.size()) of_point->push_back(of_point->back());
  }
  return result;
}

}  // namespace

std::vector<Mutant> search_mutants() {
  Mutant skip{
      "skip_first_in_grid", "the first blocker forgotten by a grid of ten", Part::searched_visibility, {}, {"LL2"}};
  skip.subject.searched_visibility = [](const auto& light, const auto& blockers, const auto& search, const auto& points,
                                        const auto& normal) {
    std::vector<ConvexBlocker> kept = blockers;
    if (search == LinearSearch{OccluderSearch::grid, 10}) kept.erase(kept.begin());
    return searched_visibility(light, kept, search, points, normal);
  };
  return {
      skip,
      finding("neighbour_section", "the next section of the light buffer read", {"LL1"}, in_next_section),
      finding("drop_seam_copy", "a blocker across the seam stored on one side only", {"LL1"}, without_far_side_of_seam),
      finding("drop_beside_from_left", "left of the light only what is left of it read", {"LL1"},
              without_beside_from_left),
      finding("strict_turns", "turns compared without a margin", {"LL1"}, without_margins),
      finding("swap_for_twice", "a blocker found twice where all are found", {"LL3"}, with_one_twice),
  };
}

}  // namespace gnomon::laws
