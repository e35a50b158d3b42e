#include "geometry/planar/visibility_query.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/numbers/rounding.h"
#include "geometry/planar/light_line.h"
#include "geometry/planar/orientation.h"

namespace gnomon::planar {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

IntervalEnd light_end(std::uint32_t end) {
  return {{EventPointKind::light_end, 0, end}, double(end), 0};
}

}  // namespace

VisibilityQuery::VisibilityQuery(const LightVisibility& visibility, const Viewpoint& from)
    : visibility_(visibility), from_(from) {
  const auto light = visibility.flatland().light();
  if (light.size() == 1) return;
  side_ = orientation(from, light[0], light[1]);
  x_ = from.near().x - light[0].x;
  y_ = from.near().y - light[0].y;
  const double dx = light[1].x - light[0].x, dy = light[1].y - light[0].y;
  height_ = side_ * (dx * y_ - dy * x_);
  height_error_ =
      product_error(std::fabs(dx * y_) + std::fabs(dy * x_)) + 2 * from.error() * (std::fabs(dx) + std::fabs(dy));
}

VisibleLight VisibilityQuery::visible_light() const {
  if (visibility_.flatland().has_point_light()) return of_point_light();
  return side_ == 0 ? visible_along_line(visibility_, visibility_.on_line_, from_) : off_the_line();
}

Rational VisibilityQuery::fraction() const {
  const VisibleLight seen = visible_light();
  if (seen.region != Region::penumbra) return seen.region == Region::lit ? 1 : 0;
  Rational sum = 0;
  for (const VisibleInterval& interval : seen.intervals) sum += place(interval.to.name) - place(interval.from.name);
  return sum;
}

Rational VisibilityQuery::place(const EventPoint& name) const {
  const auto light = visibility_.flatland().light();
  if (name.kind == EventPointKind::light_end) return name.end;
  const ExactPoint p = from_.exact();
  if (name.kind == EventPointKind::viewpoint) return place_along(light, p);
  const BlockerSegment& blocker = visibility_.flatland().blockers()[name.element];
  if (name.kind == EventPointKind::crossing) return crossing_place(light, blocker);
  const ExactPoint q = exact(blocker[name.end]);
  const Rational height_p = height_over(light, p), height_q = height_over(light, q);
  if (height_p == 0) return place_along(light, q);
  const ExactPoint start = exact(light[0]);
  const Rational area = (q.x - start.x) * (p.y - start.y) - (q.y - start.y) * (p.x - start.x);
  return area / (height_p - height_q);
}

/// True if the end lies nearer to the light's line than the viewpoint.
bool VisibilityQuery::is_below(const End& end) const {
  if (end.is_crossing) return true;
  const double above = height_ - end.height;
  const double error = height_error_ + end.height_error;
  if (above > 2 * error) return true;
  if (above < -2 * error) return false;
  const auto light = visibility_.flatland().light();
  return side_ * height_order(light[0], light[1], end.point, from_) > 0;
}

/// The line through the viewpoint p and the end q meets the light's line at t = (q x p) / (height p - height q), points
/// relative to light end 0.
VisibilityQuery::Bound VisibilityQuery::bound_of(const End& end) const {
  if (end.is_crossing) return {end.t[0], end.t[1], &end, end.name};
  const double left = end.x * y_, right = end.y * x_;
  const double area = side_ * (left - right);
  const double area_error =
      product_error(std::fabs(left) + std::fabs(right)) + 2 * from_.error() * (std::fabs(end.x) + std::fabs(end.y));
  const double depth = height_ - end.height;
  const double depth_error = height_error_ + end.height_error + 0x1p-52 * std::fabs(depth);
  if (!(depth > 4 * depth_error)) return {-infinity, infinity, &end, end.name};
  const double t = area / depth;
  // |t - exact| <= (area_error + |t| depth_error) / (depth - depth_error) + rounding; 2 stands for 4/3 and roundings.
  const double error = 2 * (area_error + std::fabs(t) * depth_error) / depth + rounding_error(t);
  return {t - error, t + error, &end, end.name};
}

std::optional<VisibilityQuery::Hidden> VisibilityQuery::hidden_between(const LightVisibility::Piece& piece) const {
  const Bound first = bound_of(piece[0]);
  const Bound last = bound_of(piece[1]);
  if (first.high < last.low) return Hidden{first, last};
  if (last.high < first.low) return Hidden{last, first};
  const int turn = side_ * orientation(from_, piece[0].point, piece[1].point);
  if (turn == 0) return std::nullopt;
  return turn > 0 ? Hidden{first, last} : Hidden{last, first};
}

/// What a piece hides of the light's line: what is seen of it between the line and the viewpoint's height.
std::optional<VisibilityQuery::Hidden> VisibilityQuery::hidden_by(const LightVisibility::Piece& piece) const {
  const bool first_below = is_below(piece[0]);
  const bool last_below = is_below(piece[1]);
  if (first_below && last_below) return hidden_between(piece);
  if (!first_below && !last_below) return std::nullopt;
  const int turn = side_ * orientation(from_, piece[0].point, piece[1].point) * (first_below ? 1 : -1);
  if (turn == 0) return std::nullopt;
  const Bound seen = bound_of(piece[first_below ? 0 : 1]);
  if (turn > 0) return Hidden{seen, {infinity, infinity, nullptr, {}}};
  return Hidden{{-infinity, -infinity, nullptr, {}}, seen};
}

/// The order of two places along the light's line.
int VisibilityQuery::compare(const Bound& a, const Bound& b) const {
  if (a.high < b.low) return -1;
  if (a.low > b.high) return 1;
  if (a.name == b.name) return 0;
  const auto is_input = [](const Bound& bound) { return bound.end == nullptr || !bound.end->is_crossing; };
  if (!is_input(a) || !is_input(b)) return CGAL::compare(place(a.name), place(b.name));
  const auto point = [&](const Bound& bound) {
    return bound.end != nullptr ? bound.end->point : visibility_.flatland().light()[bound.name.end];
  };
  return -side_ * orientation(from_, point(a), point(b));
}

/// True if a lies behind b, or in one place with it and has the name that comes first.
bool VisibilityQuery::comes_after(const Bound& a, const Bound& b) const {
  const int order = compare(a, b);
  return order > 0 || (order == 0 && a.name < b.name);
}

IntervalEnd VisibilityQuery::interval_end(const Bound& bound) const {
  if (bound.end == nullptr) return light_end(bound.name.end);
  const double t = bound.low / 2 + bound.high / 2;
  const double error = (bound.high / 2 - bound.low / 2) * (1 + 0x1p-50) + rounding_error(t);
  if (error < 0x1p-40) return {bound.name, t, error};
  const double exact_t = nearest_double(place(bound.name));
  return {bound.name, exact_t, rounding_error(exact_t)};
}

IntervalEnd VisibilityQuery::named_end(const EventPoint& name) const {
  if (name.kind == EventPointKind::light_end) return light_end(name.end);
  if (name.kind == EventPointKind::blocker_end && side_ != 0) {
    const End end = visibility_.end_of(name.element, name.end, side_);
    return interval_end(bound_of(end));
  }
  const double t = nearest_double(place(name));
  return {name, t, rounding_error(t)};
}

VisibleLight VisibilityQuery::off_the_line() const {
  const Bound zero{0, 0, nullptr, light_end(0).name}, one{1, 1, nullptr, light_end(1).name};
  Bound low = zero, high = one;
  std::vector<Hidden> inner;
  for (const LightVisibility::Piece& piece : visibility_.pieces_[side_ > 0 ? 0 : 1]) {
    const std::optional<Hidden> hidden = hidden_by(piece);
    if (!hidden || compare(hidden->stop, zero) <= 0 || compare(hidden->start, one) >= 0) continue;
    const bool at_start = compare(hidden->start, zero) <= 0;
    const bool at_end = compare(hidden->stop, one) >= 0;
    if (at_start && at_end) return {Region::umbra, {}};
    if (at_start) {
      if (comes_after(hidden->stop, low)) low = hidden->stop;
    } else if (at_end) {
      const int order = compare(hidden->start, high);
      if (order < 0 || (order == 0 && hidden->start.name < high.name)) high = hidden->start;
    } else {
      inner.push_back(*hidden);
    }
  }
  return from_gaps(low, high, inner);
}

/// What is left of the light between `low` and `high` by hidden intervals.
VisibleLight VisibilityQuery::from_gaps(const Bound& low, const Bound& high, std::vector<Hidden>& inner) const {
  if (compare(low, high) >= 0) return {Region::umbra, {}};
  std::ranges::sort(inner, [&](const Hidden& a, const Hidden& b) {
    const int order = compare(a.start, b.start);
    return order < 0 || (order == 0 && a.start.name < b.start.name);
  });
  VisibleLight seen;
  Bound reached = low;
  for (const Hidden& hidden : inner) {
    if (compare(hidden.start, high) >= 0) break;
    if (compare(hidden.start, reached) > 0) {
      seen.intervals.push_back({interval_end(reached), interval_end(hidden.start)});
    }
    if (comes_after(hidden.stop, reached)) reached = hidden.stop;
  }
  if (compare(reached, high) < 0) seen.intervals.push_back({interval_end(reached), interval_end(high)});
  const bool whole = low.end == nullptr && high.end == nullptr && inner.empty();
  seen.region = whole ? Region::lit : seen.intervals.empty() ? Region::umbra : Region::penumbra;
  return seen;
}

VisibleLight VisibilityQuery::of_point_light() const {
  const Flatland& flatland = visibility_.flatland();
  const bool blocked = std::ranges::any_of(flatland.blockers(), [&](const BlockerSegment& blocker) {
    return is_blocked(from_, flatland.light().front(), blocker);
  });
  if (blocked) return {Region::umbra, {}};
  return {Region::lit, {{light_end(0), light_end(0)}}};
}

}  // namespace gnomon::planar
