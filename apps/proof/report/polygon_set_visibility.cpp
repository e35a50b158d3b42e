#include "apps/proof/report/polygon_set_visibility.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <cmath>
#include <vector>

#include "apps/proof/report/vectors.h"

namespace gnomon::report {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;
using Number = Kernel::FT;

Polygon counterclockwise(Polygon polygon) {
  if (polygon.is_clockwise_oriented()) polygon.reverse_orientation();
  return polygon;
}

Polygon flat(const ConvexPolygon& light) {
  Polygon polygon;
  for (const std::uint32_t i : light.corners()) polygon.push_back({light.points()[i].x, light.points()[i].y});
  return counterclockwise(polygon);
}

/// The shadow of a blocker on the light's plane, seen from p.
Polygon shadow(const ConvexPolygon& blocker, const Point3& p, double z) {
  Polygon polygon;
  for (const std::uint32_t i : blocker.corners()) {
    const Point3& b = blocker.points()[i];
    const Number t = (Number(z) - p.z) / (Number(b.z) - p.z);
    polygon.push_back({p.x + t * (Number(b.x) - p.x), p.y + t * (Number(b.y) - p.y)});
  }
  return counterclockwise(polygon);
}

/// Arcs of a boundary that has the visible part on its left.
double arcs(const Polygon& boundary, const Point3& p, const Point3& normal, double z) {
  double sum = 0;
  for (auto edge = boundary.edges_begin(); edge != boundary.edges_end(); ++edge) {
    const auto view = [&](const Kernel::Point_2& q) {
      return Point3{CGAL::to_double(q.x()) - p.x, CGAL::to_double(q.y()) - p.y, z - p.z};
    };
    const Point3 from = view(edge->source()), to = view(edge->target());
    const Point3 axis = cross(from, to);
    const double sine = length(axis);
    if (sine > 0) sum += std::atan2(sine, dot(from, to)) * dot(axis, normal) / sine;
  }
  return sum;
}

}  // namespace

VisibilityAnswer polygon_set_visibility(const AreaLight& light, std::span<const ConvexBlocker> blockers,
                                        const Point3& p, const Point3& normal) {
  const double z = light.polygon.points()[0].z;
  std::vector<Polygon> shadows;
  for (const ConvexBlocker& blocker : blockers) {
    Polygon polygon = shadow(std::get<ConvexPolygon>(blocker), p, z);
    if (polygon.area() != 0) shadows.push_back(std::move(polygon));
  }
  const Polygon whole = flat(light.polygon);
  PolygonSet hidden;
  hidden.join(shadows.begin(), shadows.end());
  PolygonSet visible(whole);
  visible.difference(hidden);
  std::vector<PolygonWithHoles> parts;
  visible.polygons_with_holes(std::back_inserter(parts));
  Number area = 0;
  double sum = 0;
  for (const PolygonWithHoles& part : parts) {
    area += part.outer_boundary().area();
    sum += arcs(part.outer_boundary(), p, normal, z);
    for (const Polygon& hole : part.holes()) {
      area += hole.area();
      sum += arcs(hole, p, normal, z);
    }
  }
  const Number share = area / whole.area();
  CGAL::exact(share);
  const Region region = area == 0 ? Region::umbra : share == 1 ? Region::lit : Region::penumbra;
  return {region, CGAL::to_double(share), std::fabs(sum) / (2 * length(normal))};
}

}  // namespace gnomon::report
