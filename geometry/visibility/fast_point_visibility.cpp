#include "geometry/visibility/fast_point_visibility.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/numbers/orientation.h"
#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/patient_shadow_tree.h"
#include "geometry/visibility/receiver_candidates.h"

namespace gnomon {
namespace {

using viewpoint::is_in_range;
using Shape = BlockerSet::Content::Shape;

/// A line of sight: from a point to a light, or towards one infinitely far away. Of a receiver's point the limit of
/// such lines from its front.
struct LineOfSight {
  Point3 from;
  Point3 light;      ///< the light's place, or the direction towards it
  bool ends = true;  ///< at the light
  const ReceiverFront* front = nullptr;

  /// The side on which the line starts, as below.
  int side(const Point3& a, const Point3& b, const Point3& c) const {
    const int side = exact_orientation(a, b, c, from);
    return side == 0 && front ? side_of_step(*front, a, b, c) : side;
  }

  /// The side of the light: +1 where a, b, c run counterclockwise seen from it.
  int light_side(const Point3& a, const Point3& b, const Point3& c) const {
    return ends ? exact_orientation(a, b, c, light) : exact_direction_side(a, b, c, light);
  }
};

enum class Meeting { misses, meets, undecided };

/// From beside the polygon's plane: the light lies beyond that plane and not outside of a plane through a side.
Meeting meeting(const LineOfSight& line, std::span<const Point3> corners) {
  const int side = line.side(corners[0], corners[1], corners[2]);
  const int light_side = line.light_side(corners[0], corners[1], corners[2]);
  if (side == 0 && light_side == 0) return Meeting::undecided;
  if (side * light_side >= 0) return Meeting::misses;
  bool touches = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point3& next = corners[k + 1 == corners.size() ? 0 : k + 1];
    const int beside = side * line.light_side(line.from, corners[k], next);
    if (beside > 0) return Meeting::misses;
    touches = touches || beside == 0;
  }
  return touches && line.front ? Meeting::undecided : Meeting::meets;
}

/// The light lies beyond the facets in front of the point, not in front of those in whose planes it is, and not outside
/// of a plane through the point and an edge of the silhouette.
Meeting meeting(const LineOfSight& line, const ConvexSolid& solid, std::vector<int>& sides) {
  const std::span<const Point3> points = solid.points();
  sides.clear();
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    const auto corner = [&](std::size_t i) -> const Point3& { return points[facet.loop[i]]; };
    sides.push_back(line.side(corner(0), corner(1), corner(2)));
    if (sides.back() < 0) continue;
    const int light_side = line.light_side(corner(0), corner(1), corner(2));
    if (light_side > 0 || (light_side == 0 && sides.back() > 0)) return Meeting::misses;
  }
  bool touches = false;
  for (const ConvexSolid::Edge& edge : solid.edges()) {
    if (sides[edge.left] * sides[edge.right] >= 0) continue;
    const int beside = sides[edge.left] * line.light_side(line.from, points[edge.from], points[edge.to]);
    if (beside > 0) return Meeting::misses;
    touches = touches || beside == 0;
  }
  return touches && line.front ? Meeting::undecided : Meeting::meets;
}

LineOfSight line_of_sight(const FastPointVisibility::SmallLight& light, const Point3& from) {
  if (const auto* point = std::get_if<PointLight>(&light)) return {from, point->position, true};
  const Point3& d = std::get<DirectionalLight>(light).direction;
  return {from, {-d.x, -d.y, -d.z}, false};
}

}  // namespace

FastPointVisibility::FastPointVisibility(SmallLight light, BlockerSet blockers)
    : light_(light), blockers_(std::move(blockers)) {}
FastPointVisibility::FastPointVisibility(SmallLight light, BlockerSet blockers, std::shared_ptr<PatientShadowTree> tree)
    : light_(light), blockers_(std::move(blockers)), patient_(std::move(tree)) {}

/// Threads count together, but not at every question, for they would wait for each other.
std::optional<Region> FastPointVisibility::region_by_tree(const Point3& point) {
  constexpr std::size_t told_at_once = 64;
  if (!tree_ && patient_ && ++untold_ == told_at_once) {
    tree_ = patient_->after(untold_);
    untold_ = 0;
  }
  return tree_ ? tree_->region_from(point) : std::nullopt;
}

std::optional<Region> FastPointVisibility::region_from(const Point3& point, const ReceiverPoint* receiver) {
  // Off all planes on its path a point is as all around it, so the limit from a receiver's front is no other.
  if (!receiver || receiver->under.empty()) {
    if (const std::optional<Region> region = region_by_tree(point)) return region;
  }
  const BlockerSet::Content& content = blockers_.content();
  LineOfSight line = line_of_sight(light_, point);
  const bool in_range = is_in_range(point) && is_in_range(line.light) && content.largest <= viewpoint::largest;
  if (!in_range || (line.ends && point == line.light)) return std::nullopt;
  content.collect_along({line.from, line.light, line.ends}, candidates_);
  if (receiver) {
    line.front = &receiver->front;
    if (!viewpoint::keep_before(*receiver, content, candidates_)) return std::nullopt;
  }
  bool decided = true;
  for (const std::uint32_t candidate : candidates_) {
    const Shape& shape = content.shapes[candidate];
    const Meeting met = shape.solid >= 0 ? meeting(line, content.solids[static_cast<std::size_t>(shape.solid)], sides_)
                                         : meeting(line, content.corners(shape));
    if (met == Meeting::meets) return Region::umbra;
    decided = decided && met != Meeting::undecided;
  }
  if (!decided) return std::nullopt;
  return Region::lit;
}

std::optional<Region> FastPointVisibility::region_from(const Point3& point) {
  return region_from(point, nullptr);
}

std::optional<Region> FastPointVisibility::region_of(const ReceiverPoint& receiver) {
  const LineOfSight line = line_of_sight(light_, receiver.point);
  const int side = line.ends ? side_of_front(receiver, line.light) : side_of_front_towards(receiver.front, line.light);
  return side > 0 ? region_from(receiver.point, &receiver) : Region::unlit;
}

}  // namespace gnomon
