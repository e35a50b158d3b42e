#include "geometry/spatial/position.h"

#include <array>

#include "geometry/errors.h"
#include "geometry/spatial/orientation.h"

namespace gnomon {
namespace {

/// On which sides of a plane a set of points lies.
struct Sides {
  bool positive = false;
  bool zero = false;
  bool negative = false;

  void add(int sign) {
    positive = positive || sign > 0;
    zero = zero || sign == 0;
    negative = negative || sign < 0;
  }
  bool cross() const { return positive && negative; }
  bool all_zero() const { return !positive && !negative; }
};

Sides sides(const ConvexPolygon& plane, std::span<const Point3> points) {
  const auto corner = [&](std::uint32_t k) { return plane.points()[plane.corners()[k]]; };
  OrientationFilter orientation;
  for (std::uint32_t k = 0; k < 3; ++k) orientation.include(corner(k));
  orientation.include(points);
  orientation.close();
  Sides result;
  for (const Point3& p : points) result.add(orientation(corner(0), corner(1), corner(2), p));
  return result;
}

Sides light_sides(const ConvexPolygon& blocker, const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light)) return sides(blocker, std::array{point->position});
  if (const auto* line = std::get_if<LinearLight>(&light)) return sides(blocker, std::array{line->start, line->end});
  return sides(blocker, std::get<AreaLight>(light).polygon.points());
}

void require_flat(const Light& light, const ConvexPolygon& blocker) {
  if (std::holds_alternative<DirectionalLight>(light)) throw PreconditionError("a directional light has no position");
  const auto* area = std::get_if<AreaLight>(&light);
  if (!blocker.is_flat() || (area && !area->polygon.is_flat())) {
    throw PreconditionError("the position of a pair is defined for flat polygons");
  }
}

}  // namespace

std::string_view name(Position position) {
  constexpr std::string_view names[] = {
      "standard",    "light_crosses_blocker_plane", "blocker_crosses_light_plane", "both_cross", "touching", "coplanar",
      "behind_light"};
  return names[static_cast<int>(position)];
}

Position pair_position(const Light& light, const ConvexPolygon& blocker) {
  require_flat(light, blocker);
  const Sides of_light = light_sides(blocker, light);
  if (of_light.all_zero()) return Position::coplanar;
  Sides of_blocker;
  if (const auto* area = std::get_if<AreaLight>(&light)) {
    of_blocker = sides(area->polygon, blocker.points());
    if (!area->two_sided && !of_blocker.positive) return Position::behind_light;
  }
  if (of_light.cross() && of_blocker.cross()) return Position::both_cross;
  if (of_light.cross()) return Position::light_crosses_blocker_plane;
  if (of_blocker.cross()) return Position::blocker_crosses_light_plane;
  return of_light.zero || of_blocker.zero ? Position::touching : Position::standard;
}

}  // namespace gnomon
