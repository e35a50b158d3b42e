#include "geometry/visibility/visible_part.h"

#include <algorithm>
#include <utility>

namespace gnomon {
namespace {

using Boundary = HidingCondition::Boundary;
using Hidden = std::span<const std::vector<HidingCondition>>;
using Interval = VisiblePart::Interval;
using Polygons = std::vector<ExactPolygon>;
using Intervals = std::vector<Interval>;

/// A convex piece, cut by a plane; a part without interior is left out.
template <class Piece>
struct Cut {
  Piece below;
  Piece above;
};

Cut<ExactPolygon> cut(const ExactPolygon& polygon, const ExactPlane& plane) {
  Cut<ExactPolygon> result;
  std::vector<Rational> heights;
  for (const ExactVector& v : polygon) heights.push_back(plane.height(v));
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = i + 1 == polygon.size() ? 0 : i + 1;
    if (heights[i] <= 0) result.below.push_back(polygon[i]);
    if (heights[i] >= 0) result.above.push_back(polygon[i]);
    if (heights[i].sign() * heights[next].sign() >= 0) continue;
    const Rational share = heights[i] / (heights[i] - heights[next]);
    const ExactVector crossing = polygon[i] + share * (polygon[next] - polygon[i]);
    result.below.push_back(crossing);
    result.above.push_back(crossing);
  }
  // A convex polygon has an interior below the plane exactly if a vertex is strictly below.
  const auto none = [&](auto claim) { return std::none_of(heights.begin(), heights.end(), claim); };
  if (none([](const Rational& h) { return h < 0; })) result.below.clear();
  if (none([](const Rational& h) { return h > 0; })) result.above.clear();
  return result;
}

/// A linear light, with intervals for pieces.
struct Line {
  ExactVector start;
  ExactVector end;
};

Cut<Intervals> cut(const Interval& interval, const Line& line, const ExactPlane& plane) {
  const Rational from = plane.height(line.start);
  const Rational step = plane.height(line.end) - from;
  const Rational first = from + interval[0] * step;
  const Rational last = from + interval[1] * step;
  if (first <= 0 && last <= 0 && (first < 0 || last < 0)) return {{interval}, {}};
  if (first >= 0 && last >= 0) return {{}, {interval}};
  const Rational middle = -from / step;
  if (first < 0) return {{{interval[0], middle}}, {{middle, interval[1]}}};
  return {{{middle, interval[1]}}, {{interval[0], middle}}};
}

bool contains(const ExactPlane& plane, const ExactPolygon& points) {
  return std::all_of(points.begin(), points.end(), [&](const ExactVector& v) { return plane.height(v) == 0; });
}

/// The first plane of the condition that does not hold all the points.
const ExactPlane& deciding_plane(const HidingCondition& condition, const ExactPolygon& points) {
  return contains(condition.plane, points) ? condition.then : condition.plane;
}

/// The pieces of a convex polygon that the conditions leave visible: the polygon itself if they hide nothing of it.
Polygons visible_pieces(const ExactPolygon& polygon, const std::vector<HidingCondition>& conditions) {
  Polygons visible;
  ExactPolygon rest = polygon;
  for (const HidingCondition& condition : conditions) {
    const ExactPlane& plane = deciding_plane(condition, rest);
    if (contains(plane, rest)) {
      if (condition.boundary == Boundary::belongs) continue;
      return {polygon};
    }
    Cut<ExactPolygon> parts = cut(rest, plane);
    if (parts.below.empty()) return {polygon};
    if (!parts.above.empty()) visible.push_back(std::move(parts.above));
    rest = std::move(parts.below);
  }
  return visible;
}

Intervals visible_pieces(const Interval& interval, const Line& line, const std::vector<HidingCondition>& conditions) {
  Intervals visible;
  Interval rest = interval;
  for (const HidingCondition& condition : conditions) {
    const ExactPlane& plane = deciding_plane(condition, {line.start, line.end});
    if (contains(plane, {line.start, line.end})) {
      if (condition.boundary == Boundary::belongs) continue;
      return {interval};
    }
    const Cut<Intervals> parts = cut(rest, line, plane);
    if (parts.below.empty()) return {interval};
    visible.insert(visible.end(), parts.above.begin(), parts.above.end());
    rest = parts.below.front();
  }
  return visible;
}

/// Takes from every piece what each blocker hides.
template <class Piece, class Remainder>
std::vector<Piece> remaining(std::vector<Piece> pieces, Hidden hidden, Remainder remainder) {
  for (const std::vector<HidingCondition>& conditions : hidden) {
    std::vector<Piece> left;
    for (const Piece& piece : pieces) {
      std::vector<Piece> parts = remainder(piece, conditions);
      left.insert(left.end(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
    }
    pieces = std::move(left);
  }
  return pieces;
}

/// +1 in front of the polygon, -1 behind, 0 in its plane.
int side(const ExactPolygon& facet, const ExactVector& p) {
  const Rational height = plane_through(facet[0], facet[1], facet[2]).height(p);
  return height.sign();
}

bool shows_face(const ExactPolygon& facet, bool two_sided, const ExactVector& p) {
  const int visible_from = side(facet, p);
  return two_sided ? visible_from != 0 : visible_from > 0;
}

Region region_of_point_light(bool is_before, bool is_hidden) {
  return !is_before ? Region::unlit : is_hidden ? Region::umbra : Region::lit;
}

Rational length_of(const Intervals& intervals) {
  Rational length = 0;
  for (const Interval& interval : intervals) length += interval[1] - interval[0];
  return length;
}

/// What of a light counts, given the receiver's plane; without one all of it.
struct Before {
  const ExactPlane* plane;

  ExactPolygon of(const ExactPolygon& facet) const { return plane ? cut(facet, *plane).above : facet; }
  std::optional<Interval> of(const Line& line) const {
    const Interval all{Rational(0), Rational(1)};
    if (!plane) return all;
    if (contains(*plane, {line.start, line.end})) return std::nullopt;
    const Intervals above = cut(all, line, *plane).above;
    return above.empty() ? std::nullopt : std::optional(above.front());
  }
};

struct VisiblePartOf {
  Hidden hidden;
  const ExactVector& p;
  Before before;

  VisiblePart operator()(const PointLight& light) const {
    const ExactVector l = exact(light.position);
    const bool is_hidden = std::any_of(hidden.begin(), hidden.end(), [&](const auto& conditions) {
      return l == p ? conditions.empty() : hides(conditions, l);
    });
    return without_size(!before.plane || before.plane->height(l) > 0, is_hidden);
  }

  VisiblePart operator()(const DirectionalLight& light) const {
    const ExactVector towards_light = Rational(-1) * exact(light.direction);
    const bool is_hidden = std::any_of(hidden.begin(), hidden.end(), [&](const auto& conditions) {
      return hides_direction(conditions, towards_light);
    });
    return without_size(!before.plane || before.plane->slope(towards_light) > 0, is_hidden);
  }

  static VisiblePart without_size(bool is_before, bool is_hidden) {
    VisiblePart part;
    part.region = region_of_point_light(is_before, is_hidden);
    part.any_before = is_before;
    return part;
  }

  VisiblePart operator()(const LinearLight& light) const {
    const Line line{exact(light.start), exact(light.end)};
    VisiblePart part;
    part.before = before.of(line);
    part.any_before = part.before.has_value();
    part.region = Region::unlit;
    if (!part.any_before) return part;
    part.intervals = remaining(Intervals{*part.before}, hidden, [&](const Interval& piece, const auto& conditions) {
      return visible_pieces(piece, line, conditions);
    });
    std::sort(part.intervals.begin(), part.intervals.end());
    const Rational length = length_of(part.intervals);
    const bool is_whole = length == length_of({*part.before});
    part.region = length == 0 ? Region::umbra : is_whole ? Region::lit : Region::penumbra;
    return part;
  }

  VisiblePart operator()(const AreaLight& light) const {
    const Polygons facets = flat_facets(light.polygon);
    const auto is_seen = [&](const ExactPolygon& facet) { return shows_face(facet, light.two_sided, p); };
    const bool is_unlit = std::none_of(facets.begin(), facets.end(), is_seen);
    if (is_unlit && !before.plane) return {Region::unlit, {}, {}};
    VisiblePart part;
    part.any_before = false;
    bool all_hidden = true;
    bool any_hidden = false;
    for (const ExactPolygon& facet : facets) {
      VisibleFacet seen{facet, {}, before.of(facet)};
      if (before.plane && !is_unlit && !is_seen(facet)) seen.before.clear();
      if (seen.before.empty()) {
        part.facets.push_back(std::move(seen));
        continue;
      }
      part.any_before = true;
      if (!is_unlit) look_at(seen);
      all_hidden = all_hidden && seen.visible.empty();
      any_hidden = any_hidden || seen.visible != Polygons{seen.before};
      part.facets.push_back(std::move(seen));
    }
    part.region = is_unlit || !part.any_before ? Region::unlit
                  : all_hidden                 ? Region::umbra
                  : any_hidden                 ? Region::penumbra
                                               : Region::lit;
    return part;
  }

  void look_at(VisibleFacet& seen) const {
    seen.visible = remaining(Polygons{seen.before}, hidden, [](const ExactPolygon& piece, const auto& conditions) {
      return visible_pieces(piece, conditions);
    });
  }
};

}  // namespace

Polygons flat_facets(const ConvexPolygon& polygon) {
  const std::span<const Point3> points = polygon.points();
  Polygons facets;
  if (polygon.is_flat()) {
    facets.emplace_back();
    for (const std::uint32_t i : polygon.corners()) facets.front().push_back(exact(points[i]));
    return facets;
  }
  for (std::size_t i = 2; i < points.size(); ++i) {
    ExactPolygon triangle{exact(points[0]), exact(points[i - 1]), exact(points[i])};
    if (!is_zero(doubled_area(triangle))) facets.push_back(std::move(triangle));
  }
  return facets;
}

VisiblePart visible_part(const Light& light, std::span<const std::vector<HidingCondition>> hidden,
                         const ExactVector& p) {
  return std::visit(VisiblePartOf{hidden, p, {nullptr}}, light);
}

VisiblePart visible_part(const Light& light, std::span<const std::vector<HidingCondition>> hidden, const ExactVector& p,
                         const ExactPlane& receiver) {
  return std::visit(VisiblePartOf{hidden, p, {&receiver}}, light);
}

}  // namespace gnomon
