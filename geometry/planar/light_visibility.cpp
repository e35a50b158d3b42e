#include "gnomon/flatland.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/numbers/rounding.h"
#include "geometry/planar/light_line.h"
#include "geometry/planar/orientation.h"
#include "geometry/planar/visibility_query.h"

namespace gnomon::planar {
namespace {

std::vector<std::array<EventPoint, 2>> canonical_names(const std::vector<BlockerSegment>& blockers) {
  std::map<std::pair<double, double>, EventPoint> first;
  std::vector<std::array<EventPoint, 2>> names(blockers.size());
  for (std::uint32_t i = 0; i < blockers.size(); ++i) {
    for (const std::uint32_t end : {0U, 1U}) {
      const Point2& p = blockers[i][end];
      // Adding 0 makes one zero of the two.
      names[i][end] =
          first.try_emplace({p.x + 0.0, p.y + 0.0}, EventPoint{EventPointKind::blocker_end, i, end}).first->second;
    }
  }
  return names;
}

}  // namespace

/// What meets the light's line, each place with the name that comes first.
class LightVisibility::CrossingNames {
 public:
  explicit CrossingNames(const LightVisibility& visibility) {
    const auto light = visibility.flatland_.light();
    const auto& blockers = visibility.flatland_.blockers();
    for (std::uint32_t i = 0; i < blockers.size(); ++i) {
      for (const std::uint32_t end : {0U, 1U}) {
        if (orientation(light[0], light[1], blockers[i][end]) != 0) continue;
        names_.try_emplace(place_along(light, exact(blockers[i][end])), visibility.names_[i][end]);
      }
    }
  }

  const EventPoint& name(const Rational& place, const EventPoint& crossing) {
    return names_.try_emplace(place, crossing).first->second;
  }

 private:
  std::map<Rational, EventPoint> names_;
};

LightVisibility::LightVisibility(Flatland flatland)
    : flatland_(std::move(flatland)), names_(canonical_names(flatland_.blockers())) {
  if (flatland_.has_point_light()) return;
  CrossingNames names(*this);
  for (std::uint32_t i = 0; i < flatland_.blockers().size(); ++i) add_pieces(i, names);
}

void LightVisibility::add_pieces(std::uint32_t blocker, CrossingNames& names) {
  const auto light = flatland_.light();
  const BlockerSegment& ends = flatland_.blockers()[blocker];
  const int at_0 = orientation(light[0], light[1], ends[0]);
  const int at_1 = orientation(light[0], light[1], ends[1]);
  if (at_0 * at_1 <= 0) on_line_.push_back(blocker);
  for (const int side : {1, -1}) {
    auto& pieces = pieces_[side > 0 ? 0 : 1];
    if (at_0 != side && at_1 != side) continue;
    Piece piece{end_of(blocker, 0, side), end_of(blocker, 1, side)};
    if (at_0 == -side) piece[0] = crossing_of(blocker, 0, names);
    if (at_1 == -side) piece[1] = crossing_of(blocker, 1, names);
    pieces.push_back(piece);
  }
}

LightVisibility::End LightVisibility::end_of(std::uint32_t blocker, std::uint32_t end, double side) const {
  const auto light = flatland_.light();
  const Point2& p = flatland_.blockers()[blocker][end];
  End result{p, names_[blocker][end], false, p.x - light[0].x, p.y - light[0].y};
  if (orientation(light[0], light[1], p) == 0) return result;
  const double up = (light[1].x - light[0].x) * result.y;
  const double down = (light[1].y - light[0].y) * result.x;
  result.height = side * (up - down);
  result.height_error = product_error(std::fabs(up) + std::fabs(down));
  return result;
}

LightVisibility::End LightVisibility::crossing_of(std::uint32_t blocker, std::uint32_t below,
                                                  CrossingNames& names) const {
  const BlockerSegment& ends = flatland_.blockers()[blocker];
  const Rational place = crossing_place(flatland_.light(), ends);
  End result{ends[below], names.name(place, {EventPointKind::crossing, blocker, 0}), true};
  const double t = nearest_double(place);
  const double error = rounding_error(t);
  result.t = {t - error, t + error};
  return result;
}

VisibleLight LightVisibility::visible_light(const Point2& point) const {
  const Viewpoint from(point);
  return VisibilityQuery(*this, from).visible_light();
}

ExactNumber LightVisibility::exact_fraction(const Point2& point) const {
  const Viewpoint from(point);
  return exact_number(VisibilityQuery(*this, from).fraction());
}

VisibleFraction visible_fraction(const VisibleLight& seen) {
  if (seen.region == Region::lit) return {1, 0};
  VisibleFraction fraction;
  for (const VisibleInterval& interval : seen.intervals) {
    const double length = interval.to.t - interval.from.t;
    fraction.value += length;
    // The two roundings of the difference and of the sum, of numbers that are at most 1 and a little.
    fraction.error += interval.to.error + interval.from.error + 0x1p-51;
  }
  fraction.value = std::clamp(fraction.value, 0.0, 1.0);
  return fraction;
}

}  // namespace gnomon::planar
