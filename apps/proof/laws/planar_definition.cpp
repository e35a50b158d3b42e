#include "apps/proof/laws/planar_definition.h"

#include <algorithm>
#include <utility>

namespace gnomon::laws {
namespace {

using Segment = std::pair<ExactVector, ExactVector>;

/// The cross product of two vectors of the plane.
Rational area(const ExactVector& a, const ExactVector& b) {
  return cross(a, b).z;
}

/// True if the open segment (p, l) meets the closed segment from a to b; a point of it is p + s (l - p).
bool is_blocked(const ExactVector& p, const ExactVector& l, const ExactVector& a, const ExactVector& b) {
  const ExactVector ray = l - p;
  const ExactVector edge = b - a;
  if (is_zero(ray)) return false;
  const Rational parallel = area(ray, edge);
  if (parallel != 0) {
    const Rational s = area(a - p, edge) / parallel;
    const Rational u = area(a - p, ray) / parallel;
    return s > 0 && s < 1 && u >= 0 && u <= 1;
  }
  if (area(a - p, ray) != 0) return false;
  const Rational s_a = dot(a - p, ray) / dot(ray, ray);
  const Rational s_b = dot(b - p, ray) / dot(ray, ray);
  return std::max(s_a, s_b) > 0 && std::min(s_a, s_b) < 1;
}

/// Adds t where l + t d lies on the line through q with direction e, if it does once and inside the light.
void add_cut(const ExactVector& l, const ExactVector& d, const ExactVector& q, const ExactVector& e,
             std::vector<Rational>& cuts) {
  const Rational parallel = area(d, e);
  if (parallel == 0) return;
  const Rational t = area(q - l, e) / parallel;
  if (t > 0 && t < 1) cuts.push_back(t);
}

/// Parameters along the light between which all or none of it is blocked from p: where it passes p, an end of a
/// blocker, a blocker's line or a line through p and an end.
std::vector<Rational> cuts_of(const ExactVector& l, const ExactVector& d, const ExactVector& p,
                              std::span<const Segment> blockers) {
  std::vector<Rational> cuts{0, 1};
  const ExactVector across{Rational(-d.y), d.x, 0};
  add_cut(l, d, p, across, cuts);
  for (const auto& [a, b] : blockers) {
    for (const ExactVector& q : {a, b}) add_cut(l, d, q, across, cuts);
    add_cut(l, d, a, b - a, cuts);
    for (const ExactVector& end : {a, b}) add_cut(l, d, p, end - p, cuts);
  }
  std::ranges::sort(cuts);
  return cuts;
}

bool is_blocked(const ExactVector& p, const ExactVector& l, std::span<const Segment> blockers) {
  return std::ranges::any_of(blockers,
                             [&](const Segment& blocker) { return is_blocked(p, l, blocker.first, blocker.second); });
}

std::vector<Segment> exact_segments(std::span<const std::array<Point2, 2>> blockers) {
  std::vector<Segment> segments;
  for (const auto& [a, b] : blockers) segments.emplace_back(exact(a), exact(b));
  return segments;
}

}  // namespace

ExactVector exact(const Point2& p) {
  return {Rational(p.x), Rational(p.y), 0};
}

int side_of(const ExactVector& a, const ExactVector& b, const ExactVector& p) {
  return sign(area(b - a, p - a));
}

Rational visible_fraction(std::span<const Point2> light, const std::array<Point2, 2>& blocker, const ExactVector& p) {
  return visible_fraction(light, std::span(&blocker, 1), p);
}

Rational visible_fraction(std::span<const Point2> light, std::span<const std::array<Point2, 2>> blockers,
                          const ExactVector& p) {
  if (light.size() == 1) return is_blocked(p, exact(light.front()), exact_segments(blockers)) ? 0 : 1;
  Rational visible = 0;
  for (const LightPart& part : visible_parts(light, blockers, p)) visible += part.to - part.from;
  return visible;
}

std::vector<LightPart> visible_parts(std::span<const Point2> light, std::span<const std::array<Point2, 2>> blockers,
                                     const ExactVector& p) {
  const std::vector<Segment> segments = exact_segments(blockers);
  const ExactVector l = exact(light.front());
  const ExactVector d = exact(light.back()) - l;
  const std::vector<Rational> cuts = cuts_of(l, d, p, segments);
  std::vector<LightPart> parts;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (cuts[k] == cuts[k + 1]) continue;
    const Rational middle = (cuts[k] + cuts[k + 1]) / 2;
    if (is_blocked(p, l + middle * d, segments)) continue;
    if (!parts.empty() && parts.back().to == cuts[k]) {
      parts.back().to = cuts[k + 1];
    } else {
      parts.push_back({cuts[k], cuts[k + 1]});
    }
  }
  return parts;
}

}  // namespace gnomon::laws
