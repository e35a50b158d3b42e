#include <algorithm>
#include <utility>

#include "geometry/numbers/rounding.h"
#include "geometry/planar/light_line.h"
#include "geometry/planar/orientation.h"
#include "geometry/planar/visibility_query.h"

namespace gnomon::planar {
namespace {

/// A place on the light's line, with its name.
struct Place {
  Rational t;
  EventPoint name;

  friend bool operator<(const Place& a, const Place& b) { return a.t != b.t ? a.t < b.t : a.name < b.name; }
};

/// The part of a blocker on the light's line.
std::pair<Place, Place> extent(const Flatland& flatland, std::uint32_t blocker) {
  const auto light = flatland.light();
  const BlockerSegment& ends = flatland.blockers()[blocker];
  std::vector<Place> places;
  for (const std::uint32_t end : {0U, 1U}) {
    if (orientation(light[0], light[1], ends[end]) != 0) continue;
    places.push_back({place_along(light, exact(ends[end])), {EventPointKind::blocker_end, blocker, end}});
  }
  if (places.empty()) places.push_back({crossing_place(light, ends), {EventPointKind::crossing, blocker, 0}});
  const auto [first, last] = std::minmax(places.front(), places.back());
  return {first, last};
}

IntervalEnd interval_end(const Place& place) {
  const double t = nearest_double(place.t);
  return {place.name, t, place.name.kind == EventPointKind::light_end ? 0 : rounding_error(t)};
}

/// The part of the light's line that is seen: from `first` to `last`, the viewpoint between them.
struct Clear {
  Place first;
  Place last;
};

Clear clear_about(const Flatland& flatland, std::span<const std::uint32_t> blockers, const Place& viewpoint,
                  const Place& start, const Place& end) {
  Clear clear{std::min(start, viewpoint), std::max(end, viewpoint)};
  for (const std::uint32_t blocker : blockers) {
    const auto [first, last] = extent(flatland, blocker);
    if (last.t > viewpoint.t) clear.last = std::min(clear.last, first.t > viewpoint.t ? first : viewpoint);
    if (first.t < viewpoint.t) clear.first = std::max(clear.first, last.t < viewpoint.t ? last : viewpoint);
  }
  return clear;
}

}  // namespace

VisibleLight visible_along_line(const LightVisibility& visibility, std::span<const std::uint32_t> blockers,
                                const Viewpoint& from) {
  const Flatland& flatland = visibility.flatland();
  const Place start{0, {EventPointKind::light_end, 0, 0}}, end{1, {EventPointKind::light_end, 0, 1}};
  const Place viewpoint{place_along(flatland.light(), from.exact()), {EventPointKind::viewpoint, 0, 0}};
  const Clear clear = clear_about(flatland, blockers, viewpoint, start, end);
  const Place& first = clear.first.t <= 0 ? start : clear.first;
  const Place& last = clear.last.t >= 1 ? end : clear.last;
  if (first.t >= last.t) return {Region::umbra, {}};
  const bool whole = first.t == 0 && last.t == 1;
  return {whole ? Region::lit : Region::penumbra, {{interval_end(first), interval_end(last)}}};
}

bool is_blocked(const Viewpoint& from, const Point2& light, const BlockerSegment& blocker) {
  const int at_0 = orientation(from, light, blocker[0]);
  const int at_1 = orientation(from, light, blocker[1]);
  if (at_0 * at_1 > 0) return false;
  if (at_0 != 0 || at_1 != 0) {
    return orientation(from, blocker[0], blocker[1]) * orientation(blocker[0], blocker[1], light) < 0;
  }
  const ExactPoint p = from.exact(), l = exact(light), a = exact(blocker[0]), b = exact(blocker[1]);
  if (p == l) return false;
  const auto overlaps = [](const Rational& p1, const Rational& l1, const Rational& a1, const Rational& b1) {
    return std::max(a1, b1) > std::min(p1, l1) && std::min(a1, b1) < std::max(p1, l1);
  };
  return p.x != l.x ? overlaps(p.x, l.x, a.x, b.x) : overlaps(p.y, l.y, a.y, b.y);
}

}  // namespace gnomon::planar
