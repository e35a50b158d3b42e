#include "geometry/visibility/linear_search/light_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/visibility/linear_search/cylinder_boxes.h"

namespace gnomon::viewpoint {
namespace {

/// The triangle in cylindrical coordinates: where it may be for every exact triangle that is rounded to it.
///
/// Bound. At a distance d the triangle reaches from d start_slope to length + d end_slope. Each slope is off by at most
/// 1.1 error (1 + |its value|) / distance, the length by its own error; multiplied by a distance up to the point's
/// and doubled that is less than `slack`.
class TriangleSpan {
 public:
  TriangleSpan(const CylinderPlace& place, const LightCylinder& cylinder, double turn_scale)
      : low_turn_(turn_scale * (place.turn - place.turn_error)),
        high_turn_(turn_scale * (place.turn + place.turn_error)),
        distance_(place.distance + place.error),
        length_(cylinder.length()),
        start_slope_(place.along / place.distance),
        end_slope_((place.along - length_) / place.distance) {
    const double steepest = std::max(std::fabs(start_slope_), std::fabs(end_slope_));
    slack_ = 4 * (place.error + cylinder.length_error()) * (1 + steepest);
  }

  bool may_meet(const Box3& box) const {
    const double near = box.min.y;
    if (!((box.min.x <= high_turn_) & (low_turn_ <= box.max.x) & (near <= distance_))) return false;
    const double far = std::min(box.max.y, distance_);
    const double low = start_slope_ * (start_slope_ >= 0 ? near : far);
    const double high = length_ + end_slope_ * (end_slope_ >= 0 ? far : near);
    return (box.max.z >= low - slack_) & (box.min.z <= high + slack_);
  }

 private:
  double low_turn_, high_turn_, distance_, length_, start_slope_, end_slope_;
  double slack_ = 0;
};

/// A power of two near the mean distance of the boxes from the light.
double scale_of_turns(const std::vector<CylinderBox>& boxes) {
  double sum = 0;
  for (const CylinderBox& box : boxes) sum += box.low_distance + box.high_distance;
  const double mean = sum / (2 * static_cast<double>(boxes.size()));
  return mean > 1e-200 && mean < 1e200 ? std::exp2(std::round(std::log2(mean))) : 1;
}

}  // namespace

LightHierarchy::LightHierarchy(const LinearLight& light, BlockerSet blockers)
    : blockers_(std::move(blockers)), cylinder_(light) {
  const std::vector<CylinderBox> about = cylinder_boxes(cylinder_, blockers_.content());
  turn_scale_ = scale_of_turns(about);
  std::vector<Box3> boxes;
  for (std::uint32_t b = 0; b < about.size(); ++b) {
    const CylinderBox& box = about[b];
    add(box, 0, b, boxes);
    if (box.is_all_round()) continue;
    if (box.high_turn > 2 - LightCylinder::widest_turn_error) add(box, -4, b, boxes);
    if (box.low_turn < -2 + LightCylinder::widest_turn_error) add(box, 4, b, boxes);
  }
  boxes_ = BoxHierarchy(boxes);
}

void LightHierarchy::add(const CylinderBox& box, double turned, std::uint32_t owner, std::vector<Box3>& boxes) {
  boxes.push_back({{turn_scale_ * (box.low_turn + turned), box.low_distance, box.low_along},
                   {turn_scale_ * (box.high_turn + turned), box.high_distance, box.high_along}});
  owners_.push_back(owner);
}

void LightHierarchy::find_candidates(const LightTriangle& triangle, std::vector<std::uint32_t>& found,
                                     SearchCounts& counts) const {
  const CylinderPlace place = cylinder_.place_of(triangle.corners[0]);
  if (place.turn_error > LightCylinder::widest_turn_error) {
    counts.visited += blockers_.content().collect(triangle.pyramid, found);
    return;
  }
  const TriangleSpan span(place, cylinder_, turn_scale_);
  const auto meets = [&](const Box3& box) { return span.may_meet(box); };
  counts.visited += boxes_.search(meets, found);
  for (std::uint32_t& box : found) box = owners_[box];
}

}  // namespace gnomon::viewpoint
