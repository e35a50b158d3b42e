#include "tests/geometry/visibility/splitting_oracle.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace gnomon::test_support {
namespace {

using laws::ExactPlane;
using laws::ExactVector;
using Polygon = std::vector<ExactVector>;

/// The part of the polygon on the plane's closed positive side.
Polygon clipped(const Polygon& polygon, const ExactPlane& plane) {
  Polygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ExactVector& a = polygon[k];
    const ExactVector& b = polygon[(k + 1) % polygon.size()];
    const Rational height_a = plane.height(a);
    const Rational height_b = plane.height(b);
    if (height_a >= 0) result.push_back(a);
    if (laws::sign(height_a) * laws::sign(height_b) < 0) {
      result.push_back(a + Rational(height_a / (height_a - height_b)) * (b - a));
    }
  }
  return result;
}

/// The absolute coordinates of twice the vector area added up: for polygons of one plane a multiple of the area.
Rational area(const Polygon& polygon) {
  ExactVector sum;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    sum = sum + laws::cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  }
  return abs(sum.x) + abs(sum.y) + abs(sum.z);
}

/// The half-spaces whose common part holds exactly the points of the light that a flat polygon hides.
std::vector<ExactPlane> hiding_half_spaces(const Polygon& polygon, const ExactVector& point) {
  const ExactPlane own = laws::plane_of(polygon);
  const int side = own.side(point);
  if (side == 0) return {};
  std::vector<ExactPlane> result = {side > 0 ? own.reversed() : own};
  const ExactVector inside = laws::middle(polygon);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ExactPlane plane = laws::plane_through(point, polygon[k], polygon[(k + 1) % polygon.size()]);
    result.push_back(plane.side(inside) < 0 ? plane.reversed() : plane);
  }
  return result;
}

std::vector<Polygon> flat_parts(const ConvexBlocker& blocker) {
  std::vector<Polygon> parts;
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
    parts.push_back(laws::exact(polygon->points()));
  } else {
    const auto& solid = std::get<ConvexSolid>(blocker);
    for (const ConvexSolid::Facet& facet : solid.facets()) {
      Polygon part;
      for (const std::uint32_t i : facet.loop) part.push_back(laws::exact(solid.points()[i]));
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

/// True if a half-space has no inner point of the polygon: nothing of the polygon is hidden then.
bool is_apart(const Polygon& polygon, const std::vector<ExactPlane>& half_spaces) {
  return std::any_of(half_spaces.begin(), half_spaces.end(), [&](const ExactPlane& half_space) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](const ExactVector& corner) { return half_space.side(corner) <= 0; });
  });
}

void take_away(std::vector<Polygon>& pieces, const std::vector<ExactPlane>& half_spaces) {
  std::vector<Polygon> left;
  for (Polygon& piece : pieces) {
    if (is_apart(piece, half_spaces)) {
      left.push_back(std::move(piece));
      continue;
    }
    for (const ExactPlane& half_space : half_spaces) {
      Polygon outside = clipped(piece, half_space.reversed());
      if (area(outside) > 0) left.push_back(std::move(outside));
      piece = clipped(piece, half_space);
      if (area(piece) == 0) break;
    }
    if (half_spaces.empty()) left.push_back(std::move(piece));
  }
  pieces = std::move(left);
}

/// The planes of the facets through the point, positive sides inside; nothing if the point lies outside the solid.
std::optional<std::vector<ExactPlane>> facets_around(const ConvexBlocker& blocker, const ExactVector& point) {
  if (!std::holds_alternative<ConvexSolid>(blocker)) return std::nullopt;
  std::vector<ExactPlane> around;
  for (const Polygon& facet : flat_parts(blocker)) {
    const ExactPlane inwards = laws::plane_of(facet).reversed();
    if (inwards.side(point) < 0) return std::nullopt;
    if (inwards.side(point) == 0) around.push_back(inwards);
  }
  return around;
}

/// From in or on a solid a segment meets it at once if it starts into its interior; what runs along a facet has no
/// area.
void take_away_blocker(std::vector<Polygon>& pieces, const ConvexBlocker& blocker, const ExactVector& point) {
  const auto around = facets_around(blocker, point);
  if (!around) {
    for (const Polygon& part : flat_parts(blocker)) take_away(pieces, hiding_half_spaces(part, point));
  } else if (around->empty()) {
    pieces.clear();
  } else {
    take_away(pieces, *around);
  }
}

}  // namespace

SplitView split_view(const AreaLight& light, std::span<const ConvexBlocker> blockers, const Point3& point) {
  const Polygon whole = laws::exact(light.polygon.points());
  const ExactVector p = laws::exact(point);
  const int front = laws::plane_of(whole).side(p);
  if (front == 0 || (front < 0 && !light.two_sided)) return {Region::unlit, 0, {}};
  std::vector<Polygon> pieces = {whole};
  for (const ConvexBlocker& blocker : blockers) take_away_blocker(pieces, blocker, p);
  Rational seen = 0;
  for (const Polygon& piece : pieces) seen += area(piece);
  const Rational fraction = seen / area(whole);
  return {fraction == 0 ? Region::umbra : fraction == 1 ? Region::lit : Region::penumbra, fraction, pieces};
}

}  // namespace gnomon::test_support
