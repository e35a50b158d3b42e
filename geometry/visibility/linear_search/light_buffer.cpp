#include "geometry/visibility/linear_search/light_buffer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/visibility/linear_search/cylinder_boxes.h"

namespace gnomon::viewpoint {
namespace {

/// Exceeds what the arc tangent below may round.
constexpr double angle_margin = 0x1p-40;

/// The angle of a turn from -2 to below 2: that of -2 is -pi, so the zero must be negative.
double angle_of(double turn) {
  const double x = 1 - std::fabs(turn);
  const double y = turn > 1 ? 2 - turn : turn < -1 ? -(2 + turn) : turn;
  return std::atan2(y, x);
}

}  // namespace

/// Sections are equal angles, from half a turn before angle 0 on, and go on beyond a whole turn.
std::int64_t LightBuffer::section_of(double turn) const {
  const double wholes = std::floor((turn + 2) / 4);
  const double share = angle_of(turn - 4 * wholes) / (2 * std::numbers::pi) + 0.5 + wholes;
  return static_cast<std::int64_t>(std::floor(share * sections_));
}

std::size_t LightBuffer::list_of(std::int64_t section, Region region) const {
  const std::int64_t within = (section % sections_ + sections_) % sections_;
  return static_cast<std::size_t>(within) * regions + static_cast<std::size_t>(region);
}

template <class Visit>
void LightBuffer::for_each_list(const CylinderBox& box, const Visit& visit) const {
  const std::int64_t first = box.is_all_round() ? 0 : section_of(box.low_turn - angle_margin);
  const std::int64_t last = box.is_all_round() ? sections_ - 1 : section_of(box.high_turn + angle_margin);
  const double end = cylinder_.length() + cylinder_.length_error();
  for (std::int64_t s = first; s <= std::min(last, first + sections_ - 1); ++s) {
    if (box.low_along < 0) visit(list_of(s, Region::left));
    if (box.high_along >= 0 && box.low_along <= end) visit(list_of(s, Region::beside));
    if (box.high_along > cylinder_.length() - cylinder_.length_error()) visit(list_of(s, Region::right));
  }
}

/// Counts what each list is to hold, turns the counts into places, and fills these from their ends.
LightBuffer::LightBuffer(const LinearLight& light, BlockerSet blockers, std::uint32_t sections)
    : blockers_(std::move(blockers)), cylinder_(light), sections_(sections) {
  const std::vector<CylinderBox> boxes = cylinder_boxes(cylinder_, blockers_.content());
  ends_.assign(regions * sections + 1, 0);
  for (const CylinderBox& box : boxes) for_each_list(box, [&](std::size_t list) { ++ends_[list + 1]; });
  for (std::size_t list = 1; list < ends_.size(); ++list) ends_[list] += ends_[list - 1];
  members_.resize(ends_.back());
  std::vector<std::uint32_t> order(boxes.size());
  for (std::uint32_t b = 0; b < order.size(); ++b) order[b] = b;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return boxes[a].low_distance < boxes[b].low_distance; });
  for (const std::uint32_t b : order) {
    for_each_list(boxes[b], [&](std::size_t list) { members_[ends_[list]++] = {boxes[b].low_distance, b}; });
  }
}

void LightBuffer::find_candidates(const LightTriangle& triangle, std::vector<std::uint32_t>& found,
                                  SearchCounts& counts) const {
  const CylinderPlace place = cylinder_.place_of(triangle.corners[0]);
  if (place.turn_error > LightCylinder::widest_turn_error) {
    counts.visited += blockers_.content().collect(triangle.pyramid, found);
    return;
  }
  found.clear();
  const auto gather = [&](std::size_t list) {
    const std::size_t first = list == 0 ? 0 : ends_[list - 1];
    for (std::size_t m = first; m < ends_[list]; ++m) {
      ++counts.gathered;
      if (members_[m].distance > place.distance + place.error) break;
      found.push_back(members_[m].blocker);
    }
  };
  const std::int64_t last = section_of(place.turn + place.turn_error);
  for (std::int64_t s = section_of(place.turn - place.turn_error); s <= last; ++s) {
    gather(list_of(s, Region::beside));
    if (place.along - place.error < 0) gather(list_of(s, Region::left));
    if (place.along + place.error > cylinder_.length() - cylinder_.length_error()) gather(list_of(s, Region::right));
  }
}

}  // namespace gnomon::viewpoint
