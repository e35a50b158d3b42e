#include "apps/proof/report/plain_visibility.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/proof/report/vectors.h"

namespace gnomon::report {
namespace {

double turn(const Point2& a, const Point2& b, const Point2& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

double doubled_area(const std::vector<Point2>& polygon) {
  double sum = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k) sum += turn(polygon[0], polygon[k - 1], polygon[k]);
  return sum;
}

Point2 on_edge(const Point2& a, const Point2& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// The convex hull, counterclockwise, by the sweep from left to right and back.
void make_hull(std::vector<Point2>& points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Point2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Point2& p : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  points = std::move(hull);
}

void set_box(const std::vector<Point2>& corners, Point2& low, Point2& high) {
  low = high = corners.front();
  for (const Point2& q : corners) {
    low = {std::min(low.x, q.x), std::min(low.y, q.y)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y)};
  }
}

}  // namespace

PlainVisibility::PlainVisibility(const AreaLight& light, std::span<const ConvexBlocker> blockers)
    : frame_(light.polygon), two_sided_(light.two_sided) {
  for (const std::uint32_t i : light.polygon.corners()) {
    light_.corners.push_back(frame_.flat(light.polygon.points()[i]));
  }
  set_box(light_.corners, light_.low, light_.high);
  doubled_area_ = doubled_area(light_.corners);
  for (const ConvexBlocker& blocker : blockers) add_blocker(blocker);
}

void PlainVisibility::add_blocker(const ConvexBlocker& blocker) {
  Shape shape;
  shape.first = static_cast<std::uint32_t>(corners_.size());
  const auto add = [&](std::span<const Point3> points, std::span<const std::uint32_t> corners) {
    for (const std::uint32_t i : corners) corners_.push_back({frame_.flat(points[i]), frame_.height(points[i])});
    shape.count = static_cast<std::uint32_t>(corners.size());
  };
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
    add(polygon->points(), polygon->corners());
  } else {
    const auto& solid = std::get<ConvexSolid>(blocker);
    shape.solid = true;
    add(solid.points(), solid.corners());
    const auto place = [&](std::uint32_t corner) {
      const auto at = std::lower_bound(solid.corners().begin(), solid.corners().end(), corner);
      return static_cast<std::uint32_t>(at - solid.corners().begin());
    };
    for (const ConvexSolid::Edge& edge : solid.edges()) {
      shape.edges.push_back(place(edge.from));
      shape.edges.push_back(place(edge.to));
    }
  }
  shapes_.push_back(std::move(shape));
}

/// What of the blocker lies between the light's plane and the eye.
void PlainVisibility::clip(const Shape& shape, double height) {
  const double nearest = height * (1 - 1e-9);
  const Corner* corners = corners_.data() + shape.first;
  clipped_.clear();
  const auto within = [&](const Corner& c) { return c.height >= 0 && c.height <= nearest; };
  const auto cut = [&](const Corner& a, const Corner& b) {
    double first = 0, last = 1;
    const double rise = b.height - a.height;
    for (const double level : {0.0, nearest}) {
      const bool low = level == 0;
      const double da = low ? a.height - level : level - a.height, db = low ? b.height - level : level - b.height;
      if (da < 0 && db < 0) return;
      const double share = (level - a.height) / rise;
      if (da < 0) first = std::max(first, share);
      if (db < 0) last = std::min(last, share);
    }
    if (first > last) return;
    if (first > 0) clipped_.push_back({on_edge(a.flat, b.flat, first), a.height + first * rise});
    if (last < 1) clipped_.push_back({on_edge(a.flat, b.flat, last), a.height + last * rise});
  };
  for (std::uint32_t k = 0; k < shape.count; ++k) {
    if (within(corners[k])) clipped_.push_back(corners[k]);
    if (!shape.solid) cut(corners[k], corners[(k + 1) % shape.count]);
  }
  for (std::size_t k = 0; k < shape.edges.size(); k += 2) cut(corners[shape.edges[k]], corners[shape.edges[k + 1]]);
}

void PlainVisibility::project(const Shape& shape, const Point2& foot, double height) {
  clip(shape, height);
  shadow_.clear();
  for (const Corner& c : clipped_) shadow_.push_back(on_edge(foot, c.flat, height / (height - c.height)));
  if (shadow_.size() < 3) return;
  if (shape.solid) make_hull(shadow_);
  if (shadow_.size() < 3) return;
  const double area = doubled_area(shadow_);
  if (area == 0) return;
  if (area < 0) std::reverse(shadow_.begin(), shadow_.end());
  append_outline();
}

void PlainVisibility::append_outline() {
  if (used_ == outlines_.size()) outlines_.emplace_back();
  Outline& outline = outlines_[used_];
  outline.corners.assign(shadow_.begin(), shadow_.end());
  set_box(outline.corners, outline.low, outline.high);
  if (meets(outline, light_)) ++used_;
}

bool PlainVisibility::meets(const Outline& a, const Outline& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// The part of the edge from a to b inside the polygon.
bool PlainVisibility::stretch_inside(const Point2& a, const Point2& b, const Outline& polygon, Alongside alongside,
                                     Stretch& stretch) {
  const std::size_t count = polygon.corners.size();
  const Point2* from = &polygon.corners[count - 1];
  for (const Point2& to : polygon.corners) {
    const double at_a = turn(*from, to, a), at_b = turn(*from, to, b);
    from = &to;
    if (at_a == 0 && at_b == 0 && alongside == Alongside::excluded) return false;
    if (at_a < 0 && at_b < 0) return false;
    if (at_a < 0) stretch.from = std::max(stretch.from, at_a / (at_a - at_b));
    if (at_b < 0) stretch.to = std::min(stretch.to, at_a / (at_a - at_b));
    if (stretch.from >= stretch.to) return false;
  }
  return true;
}

/// Twice the area and the arc of a piece that has the visible part on its left.
void PlainVisibility::add_piece(const Point2& a, const Point2& b, Sum& sum) const {
  sum.area += a.x * b.y - a.y * b.x;
  const Point3 from = difference(frame_.lifted(a), eye_), to = difference(frame_.lifted(b), eye_);
  const Point3 axis = cross(from, to);
  const double sine = std::sqrt(dot(axis, axis));
  if (sine > 0) sum.arcs += std::atan2(sine, dot(from, to)) * dot(axis, normal_) / sine;
}

/// Adds what no outline but the owner covers. `owner` counts from 1, 0 is the light.
void PlainVisibility::add_uncovered(std::size_t owner, const Point2& a, const Point2& b, Stretch stretch, Sum& sum) {
  covers_.clear();
  for (std::size_t other = 1; other <= used_; ++other) {
    if (other == owner) continue;
    const bool belongs = owner == 0 || other < owner;
    Stretch cover = stretch;
    if (!stretch_inside(a, b, outlines_[other - 1], belongs ? Alongside::belongs : Alongside::excluded, cover))
      continue;
    if (cover.from <= stretch.from && cover.to >= stretch.to) return;
    covers_.push_back(cover);
  }
  std::sort(covers_.begin(), covers_.end(), [](const Stretch& s, const Stretch& t) { return s.from < t.from; });
  covers_.push_back({stretch.to, stretch.to});
  double at = stretch.from;
  for (const Stretch& cover : covers_) {
    if (cover.from > at) {
      const Point2 from = on_edge(a, b, at), to = on_edge(a, b, cover.from);
      // A blocker lies left of its edges, the visible part right of them.
      owner == 0 ? add_piece(from, to, sum) : add_piece(to, from, sum);
      ++(owner == 0 ? sum.light_pieces : sum.blocker_pieces);
    }
    at = std::max(at, cover.to);
  }
}

VisibilityAnswer PlainVisibility::visible_from(const Point3& p, const Point3& normal) {
  const double height = frame_.height(p);
  if (height == 0 || (height < 0 && !two_sided_)) return {Region::unlit, 0, 0};
  eye_ = p;
  normal_ = normal;
  used_ = 0;
  const Point2 foot = frame_.flat(p);
  if (height > 0) {
    for (const Shape& shape : shapes_) project(shape, foot, height);
  } else {
    for (Corner& c : corners_) c.height = -c.height;
    for (const Shape& shape : shapes_) project(shape, foot, -height);
    for (Corner& c : corners_) c.height = -c.height;
  }
  Sum sum;
  const auto walk = [&](std::size_t owner, const Outline& outline) {
    for (std::size_t k = 0; k < outline.corners.size(); ++k) {
      const Point2& a = outline.corners[k];
      const Point2& b = outline.corners[k + 1 == outline.corners.size() ? 0 : k + 1];
      Stretch stretch;
      if (owner != 0 && !stretch_inside(a, b, light_, Alongside::excluded, stretch)) continue;
      add_uncovered(owner, a, b, stretch, sum);
    }
  };
  walk(0, light_);
  for (std::size_t i = 1; i <= used_; ++i) walk(i, outlines_[i - 1]);
  if (sum.light_pieces + sum.blocker_pieces == 0) return {Region::umbra, 0, 0};
  const double irradiance = std::fabs(sum.arcs) / (2 * std::sqrt(dot(normal, normal)));
  if (sum.blocker_pieces == 0 && sum.area >= doubled_area_) return {Region::lit, 1, irradiance};
  return {Region::penumbra, sum.area / doubled_area_, irradiance};
}

}  // namespace gnomon::report
