#include "apps/proof/report/spheres.h"

#include <cmath>

namespace gnomon::report {
namespace {

/// Points on a sphere along a spiral; their hull has twice as many facets, less four.
std::vector<Point3> spiral(std::uint32_t count, double radius, const Point3& centre) {
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count;
    const double angle = 2.399963229728653 * i;
    const double r = std::sqrt(1 - z * z);
    points.push_back(
        {centre.x + radius * r * std::cos(angle), centre.y + radius * r * std::sin(angle), centre.z + radius * z});
  }
  return points;
}

}  // namespace

ConvexSolid sphere(std::uint32_t facets) {
  return ConvexSolid::hull_of(spiral(facets / 2 + 2, 1.3, {0.1, -0.2, 1.7}));
}

std::vector<ConvexBlocker> sphere_facets(std::uint32_t facets) {
  const ConvexSolid whole = sphere(facets);
  std::vector<ConvexBlocker> parts;
  for (const ConvexSolid::Facet& facet : whole.facets()) {
    std::vector<Point3> points;
    for (const std::uint32_t i : facet.loop) points.push_back(whole.points()[i]);
    parts.emplace_back(ConvexPolygon::from_points(points));
  }
  return parts;
}

Light lamp_above_sphere() {
  return AreaLight{ConvexPolygon::from_points({{-0.9, -1.1, 6}, {-1.2, 0.8, 6}, {1.1, 1.05, 6}, {0.95, -0.85, 6}})};
}

}  // namespace gnomon::report
