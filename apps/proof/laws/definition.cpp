#include "apps/proof/laws/definition.h"

#include <algorithm>

#include "gnomon/errors.h"

namespace gnomon::laws {
namespace {

using Polygon = std::vector<ExactVector>;

/// The half-spaces whose intersection holds exactly the points that p is kept from seeing by the blocker: the cone
/// from p over the blocker, and the far side of the blocker's plane (closed here; its border has no measure unless
/// the whole light lies in it).
std::vector<ExactPlane> hidden_from(const ExactVector& p, const Polygon& blocker) {
  const ExactPlane plane = plane_of(blocker);
  const ExactVector inner = middle(blocker);
  std::vector<ExactPlane> half_spaces = {plane.side(p) < 0 ? plane : plane.reversed()};
  for (std::size_t i = 0; i < blocker.size(); ++i) {
    const ExactPlane side = plane_through(p, blocker[i], blocker[(i + 1) % blocker.size()]);
    half_spaces.push_back(side.side(inner) > 0 ? side : side.reversed());
  }
  return half_spaces;
}

Polygon clipped(const Polygon& polygon, const ExactPlane& plane) {
  std::vector<Rational> heights;
  for (const ExactVector& p : polygon) heights.push_back(plane.height(p));
  if (std::ranges::all_of(heights, [](const Rational& height) { return sign(height) >= 0; })) return polygon;
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    const ExactVector &a = polygon[i], &b = polygon[next];
    const Rational &height_a = heights[i], &height_b = heights[next];
    if (sign(height_a) >= 0) kept.push_back(a);
    if (sign(height_a) * sign(height_b) < 0) kept.push_back(a + Rational(height_a / (height_a - height_b)) * (b - a));
  }
  return kept;
}

/// Share of the polygon's area inside all half-spaces.
Rational share_of_area(const Polygon& polygon, const std::vector<ExactPlane>& half_spaces) {
  Polygon part = polygon;
  for (const ExactPlane& plane : half_spaces) {
    part = clipped(part, plane);
    if (part.empty()) return 0;
  }
  const ExactVector normal = plane_of(polygon).normal;
  return Rational(dot(plane_of(part).normal, normal) / dot(normal, normal));
}

/// Share of the segment's length inside all half-spaces.
Rational share_of_length(const ExactVector& a, const ExactVector& b, const std::vector<ExactPlane>& half_spaces) {
  Rational from = 0;
  Rational to = 1;
  for (const ExactPlane& plane : half_spaces) {
    const Rational at_a = plane.height(a);
    const Rational rise = plane.height(b) - at_a;
    if (sign(rise) == 0 && sign(at_a) < 0) return 0;
    if (sign(rise) == 0) continue;
    const Rational zero = -at_a / rise;
    if (sign(rise) > 0) from = std::max(from, zero);
    if (sign(rise) < 0) to = std::min(to, zero);
  }
  return std::max(Rational(0), Rational(to - from));
}

bool shows_its_back(const Light& light, const ExactVector& p) {
  const AreaLight* area = std::get_if<AreaLight>(&light);
  if (!area) return false;
  const int side = plane_of(exact(area->polygon.points())).side(p);
  return area->two_sided ? side == 0 : side <= 0;
}

}  // namespace

std::vector<ExactVector> vertices(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light)) return {exact(point->position)};
  if (const auto* linear = std::get_if<LinearLight>(&light)) return {exact(linear->start), exact(linear->end)};
  if (const auto* area = std::get_if<AreaLight>(&light)) return exact(area->polygon.points());
  throw PreconditionError("a directional light has no vertices");
}

bool stands_apart(const Light& light, const ConvexPolygon& blocker) {
  const Polygon hindrance = exact(blocker.points());
  const ExactPlane plane = plane_of(hindrance);
  const Polygon emitter = vertices(light);
  const int side = plane.side(emitter[0]);
  const auto on_that_side = [&](const ExactVector& l) { return plane.side(l) == side; };
  if (side == 0 || !std::ranges::all_of(emitter, on_that_side)) return false;
  const AreaLight* area = std::get_if<AreaLight>(&light);
  if (!area) return true;
  const ExactPlane front = plane_of(emitter);
  const int lit_side = area->two_sided ? front.side(hindrance[0]) : 1;
  return lit_side != 0 &&
         std::ranges::all_of(hindrance, [&](const ExactVector& b) { return front.side(b) == lit_side; });
}

std::optional<Rational> visible_fraction(const Light& light, const ConvexPolygon& blocker, const ExactVector& p) {
  if (shows_its_back(light, p)) return std::nullopt;
  const Polygon hindrance = exact(blocker.points());
  const Polygon emitter = vertices(light);
  const ExactPlane plane = plane_of(hindrance);
  const bool flush = common_side(plane, emitter) == 0;
  if (flush && plane.side(p) == 0) throw PreconditionError("the point and the light lie in the blocker's plane");
  if (flush || plane.side(p) == 0) return Rational(1);
  const std::vector<ExactPlane> hidden = hidden_from(p, hindrance);
  if (emitter.size() == 1) {
    return Rational(std::ranges::all_of(hidden, [&](const auto& h) { return h.side(emitter[0]) >= 0; }) ? 0 : 1);
  }
  if (emitter.size() == 2) return Rational(1 - share_of_length(emitter[0], emitter[1], hidden));
  return Rational(1 - share_of_area(emitter, hidden));
}

bool lies_on(const ExactVector& p, const ConvexPolygon& blocker) {
  const Polygon polygon = exact(blocker.points());
  const ExactPlane plane = plane_of(polygon);
  if (plane.side(p) != 0) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactVector edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (sign(dot(cross(edge, p - polygon[i]), plane.normal)) < 0) return false;
  }
  return true;
}

bool segment_meets(const ExactVector& p, const ExactVector& l, const ConvexPolygon& blocker) {
  const ExactPlane plane = plane_of(exact(blocker.points()));
  const Rational height_p = plane.height(p);
  const Rational height_l = plane.height(l);
  if (sign(height_p) == 0 && sign(height_l) == 0) throw PreconditionError("the segment lies in the blocker's plane");
  if (sign(height_p) * sign(height_l) > 0) return false;
  return lies_on(p + Rational(height_p / (height_p - height_l)) * (l - p), blocker);
}

}  // namespace gnomon::laws
