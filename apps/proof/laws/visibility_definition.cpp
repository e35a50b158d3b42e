#include "apps/proof/laws/visibility_definition.h"

#include <algorithm>
#include <array>
#include <optional>

namespace gnomon::laws {
namespace {

using Polygon = std::vector<ExactVector>;

Walls walls_of(const ConvexPolygon& polygon) {
  const Polygon points = exact(polygon.points());
  const ExactPlane plane = plane_of(points);
  Walls result = {plane, plane.reversed()};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ExactVector& a = points[i];
    const ExactVector& b = points[(i + 1) % points.size()];
    result.push_back(plane_through(a, b, b + plane.normal));
    if (result.back().side(middle(points)) > 0) result.back() = result.back().reversed();
  }
  return result;
}

/// True if one of the planes holds all three points.
bool holds_all(const Walls& planes, const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  return std::ranges::any_of(
      planes, [&](const ExactPlane& plane) { return plane.side(a) == 0 && plane.side(b) == 0 && plane.side(c) == 0; });
}

Walls walls_of(const ConvexSolid& solid) {
  const Polygon points = exact(solid.points());
  Walls result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const ExactPlane plane = plane_through(points[i], points[j], points[k]);
        if (is_zero(plane.normal) || holds_all(result, points[i], points[j], points[k])) continue;
        const std::optional<int> side = common_side(plane, points);
        if (!side) continue;
        result.push_back(*side < 0 ? plane : plane.reversed());
      }
    }
  }
  return result;
}

/// The part 0 < t < 1 (or 0 < t, for a ray) of a line on which all functions at + t * rise are not positive, is not
/// empty. Each bounds t by a closed end; the two ends of the segment are open.
bool has_common_part(const std::vector<std::array<Rational, 2>>& functions, bool endless) {
  std::optional<Rational> from;  // closed; nothing: the open end 0
  std::optional<Rational> to;    // closed; nothing: the open end 1 or none
  for (const auto& [at, rise] : functions) {
    if (sign(rise) == 0) {
      if (sign(at) > 0) return false;
      continue;
    }
    const Rational zero = -at / rise;
    if (sign(rise) < 0 && (!from || zero > *from)) from = zero;
    if (sign(rise) > 0 && (!to || zero < *to)) to = zero;
  }
  if (to && sign(*to) <= 0) return false;
  if (from && !endless && *from >= 1) return false;
  return !from || !to || *from <= *to;
}

bool meets(const Walls& blocker, const ExactVector& p, const ExactVector& step, bool endless) {
  std::vector<std::array<Rational, 2>> functions;
  for (const ExactPlane& wall : blocker) functions.push_back({wall.height(p), dot(wall.normal, step)});
  return has_common_part(functions, endless);
}

/// For every two walls with p above one and below the other, the plane through p and the line they meet in.
Walls planes_between(const Walls& blocker, const ExactVector& p) {
  std::vector<Rational> heights;
  for (const ExactPlane& wall : blocker) heights.push_back(wall.height(p));
  Walls result;
  for (std::size_t i = 0; i < blocker.size(); ++i) {
    if (sign(heights[i]) <= 0) continue;
    for (std::size_t j = 0; j < blocker.size(); ++j) {
      if (sign(heights[j]) >= 0) continue;
      // The combination of the two that vanishes at p: positive weights, so it is not positive in the blocker.
      const Rational &a = heights[i], &b = heights[j];
      result.push_back(
          {a * blocker[j].normal - b * blocker[i].normal, Rational(a * blocker[j].offset - b * blocker[i].offset)});
    }
  }
  return result;
}

/// Closed half-spaces below planes that hold, up to sets without area, the hidden points; and planes that must not hold
/// the whole light.
struct HiddenSpace {
  Walls below;
  Walls strictly_below;
};

/// Eliminates the place on the segment from the inequalities of all walls, pair by pair.
HiddenSpace hidden_space(const Walls& blocker, const ExactVector& p) {
  HiddenSpace space{planes_between(blocker, p), {}};
  for (const ExactPlane& wall : blocker) {
    const int side = wall.side(p);
    if (side == 0) space.below.push_back(wall);
    if (side > 0) space.strictly_below.push_back(wall);
  }
  return space;
}

Polygon clipped_below(const Polygon& polygon, const ExactPlane& plane) {
  std::vector<Rational> heights;
  for (const ExactVector& p : polygon) heights.push_back(plane.height(p));
  if (std::ranges::all_of(heights, [](const Rational& height) { return sign(height) <= 0; })) return polygon;
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    const ExactVector &a = polygon[i], &b = polygon[next];
    const Rational &at_a = heights[i], &at_b = heights[next];
    if (sign(at_a) <= 0) kept.push_back(a);
    if (sign(at_a) * sign(at_b) < 0) kept.push_back(a + Rational(at_a / (at_a - at_b)) * (b - a));
  }
  return kept;
}

Polygon hidden_part(Polygon polygon, const HiddenSpace& space) {
  for (const ExactPlane& plane : space.strictly_below) {
    if (common_side(plane, polygon) == 0) return {};
    polygon = clipped_below(polygon, plane);
    if (polygon.size() < 3) return {};
  }
  for (const ExactPlane& plane : space.below) {
    polygon = clipped_below(polygon, plane);
    if (polygon.size() < 3) return {};
  }
  return polygon;
}

ExactVector twice_area(const Polygon& polygon) {
  ExactVector sum;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum = sum + cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum;
}

/// The area of what the blockers from `next` on hide of a part, in the direction of `normal`.
Rational hidden_area(const Polygon& part, const std::vector<HiddenSpace>& spaces, std::size_t next,
                     const ExactVector& normal) {
  Rational sum = 0;
  for (std::size_t i = next; i < spaces.size(); ++i) {
    const Polygon hidden = hidden_part(part, spaces[i]);
    if (hidden.empty()) continue;
    sum += dot(twice_area(hidden), normal) - hidden_area(hidden, spaces, i + 1, normal);
  }
  return sum;
}

}  // namespace

Walls walls(const ConvexBlocker& blocker) {
  return std::visit([](const auto& shape) { return walls_of(shape); }, blocker);
}

bool is_blocked(const Walls& blocker, const ExactVector& p, const ExactVector& l) {
  return p != l && meets(blocker, p, l - p, false);
}

bool is_blocked_towards(const Walls& blocker, const ExactVector& p, const ExactVector& direction) {
  return meets(blocker, p, direction, true);
}

Rational visible_length_share(const ExactVector& start, const ExactVector& end, const std::vector<Walls>& blockers,
                              const ExactVector& p) {
  std::vector<Rational> places = {0, 1};
  // A point of the light does not hide itself: nowhere may it be the one place that is asked for a whole stretch.
  const ExactVector along = end - start;
  const auto add = [&](const ExactPlane& plane) {
    const Rational at = plane.height(start);
    const Rational rise = plane.height(end) - at;
    if (sign(rise) == 0) return;
    const Rational zero = -at / rise;
    if (zero > 0 && zero < 1) places.push_back(zero);
  };
  add({along, dot(along, p)});
  for (const Walls& blocker : blockers) {
    for (const ExactPlane& wall : blocker) add(wall);
    for (const ExactPlane& plane : planes_between(blocker, p)) add(plane);
  }
  std::ranges::sort(places);
  Rational visible = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] == places[i - 1]) continue;
    const ExactVector l = start + Rational((places[i - 1] + places[i]) / 2) * along;
    const bool blocked = std::ranges::any_of(blockers, [&](const Walls& b) { return is_blocked(b, p, l); });
    if (!blocked) visible += places[i] - places[i - 1];
  }
  return visible;
}

Rational visible_area_share(const std::vector<ExactVector>& polygon, const std::vector<Walls>& blockers,
                            const ExactVector& p) {
  std::vector<HiddenSpace> spaces;
  for (const Walls& blocker : blockers) spaces.push_back(hidden_space(blocker, p));
  const ExactVector normal = twice_area(polygon);
  return Rational(1 - hidden_area(polygon, spaces, 0, normal) / dot(normal, normal));
}

std::vector<std::vector<ExactVector>> light_facets(const ConvexPolygon& polygon) {
  const Polygon points = exact(polygon.points());
  if (polygon.is_flat()) return {points};
  std::vector<Polygon> facets;
  for (std::size_t i = 2; i < points.size(); ++i) {
    Polygon triangle = {points[0], points[i - 1], points[i]};
    if (!is_zero(twice_area({{}, triangle[1] - triangle[0], triangle[2] - triangle[0]}))) facets.push_back(triangle);
  }
  return facets;
}

bool is_unlit(const Light& light, const ExactVector& p) {
  const AreaLight* area = std::get_if<AreaLight>(&light);
  if (!area) return false;
  return std::ranges::all_of(light_facets(area->polygon), [&](const Polygon& facet) {
    const int side = plane_of(facet).side(p);
    return area->two_sided ? side == 0 : side <= 0;
  });
}

Region region_behind(const std::vector<Walls>& blockers, const Light& light, const ExactVector& p) {
  if (is_unlit(light, p)) return Region::unlit;
  std::vector<Rational> shares;
  if (const auto* point = std::get_if<PointLight>(&light)) {
    const ExactVector l = exact(point->position);
    const auto hides = [&](const Walls& b) {
      return is_blocked(b, p, l) || std::ranges::all_of(b, [&](const ExactPlane& wall) { return wall.side(p) < 0; });
    };
    shares = {Rational(std::ranges::any_of(blockers, hides) ? 0 : 1)};
  } else if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
    const ExactVector towards = Rational(-1) * exact(sun->direction);
    const auto hides = [&](const Walls& b) { return is_blocked_towards(b, p, towards); };
    shares = {Rational(std::ranges::any_of(blockers, hides) ? 0 : 1)};
  } else if (const auto* line = std::get_if<LinearLight>(&light)) {
    shares = {visible_length_share(exact(line->start), exact(line->end), blockers, p)};
  } else {
    for (const auto& facet : light_facets(std::get<AreaLight>(light).polygon)) {
      shares.push_back(visible_area_share(facet, blockers, p));
    }
  }
  if (std::ranges::all_of(shares, [](const Rational& share) { return share == 1; })) return Region::lit;
  return std::ranges::all_of(shares, [](const Rational& share) { return sign(share) == 0; }) ? Region::umbra
                                                                                             : Region::penumbra;
}

}  // namespace gnomon::laws
