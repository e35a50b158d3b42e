#include "geometry/spatial/pair_sides.h"

#include <array>

#include "gnomon/errors.h"

namespace gnomon {
namespace {

Sides sides_of(const OrientationFilter& orientation, const ConvexPolygon& polygon, std::span<const Point3> points) {
  const auto corner = [&](std::uint32_t k) { return polygon.points()[polygon.corners()[k]]; };
  const OrientationFilter::Plane plane = orientation.plane(corner(0), corner(1), corner(2));
  return sides(points, [&](const Point3& p) { return plane.side(p); });
}

void require_flat(const Light& light, const ConvexPolygon& blocker) {
  if (std::holds_alternative<DirectionalLight>(light)) throw PreconditionError("a directional light has no position");
  const auto* area = std::get_if<AreaLight>(&light);
  if (!blocker.is_flat() || (area && !area->polygon.is_flat())) {
    throw PreconditionError("the position of a pair is defined for flat polygons");
  }
}

PairSides loose_light_sides(std::span<const Point3> light, const ConvexPolygon& blocker) {
  PairSides result;
  result.orientation.include(light);
  result.orientation.include(blocker.points());
  result.orientation.close();
  result.light = sides_of(result.orientation, blocker, light);
  return result;
}

}  // namespace

PairSides pair_sides(const Light& light, const ConvexPolygon& blocker) {
  require_flat(light, blocker);
  if (const auto* point = std::get_if<PointLight>(&light)) {
    return loose_light_sides(std::array{point->position}, blocker);
  }
  if (const auto* line = std::get_if<LinearLight>(&light)) {
    if (line->start == line->end) throw PreconditionError("a linear light needs two different ends");
    return loose_light_sides(std::array{line->start, line->end}, blocker);
  }
  const ConvexPolygon& polygon = std::get<AreaLight>(light).polygon;
  PairSides result = loose_light_sides(polygon.points(), blocker);
  result.blocker = sides_of(result.orientation, polygon, blocker.points());
  return result;
}

Position pair_position(const Light& light, const PairSides& sides) {
  if (sides.light.all_zero()) return Position::coplanar;
  const auto* area = std::get_if<AreaLight>(&light);
  if (area && !area->two_sided && !sides.blocker.positive) return Position::behind_light;
  if (sides.light.cross() && sides.blocker.cross()) return Position::both_cross;
  if (sides.light.cross()) return Position::light_crosses_blocker_plane;
  if (sides.blocker.cross()) return Position::blocker_crosses_light_plane;
  return sides.light.zero || sides.blocker.zero ? Position::touching : Position::standard;
}

}  // namespace gnomon
