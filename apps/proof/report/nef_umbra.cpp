#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <vector>

#include "apps/proof/report/volume_peers.h"

namespace gnomon::report {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

constexpr double floor_z = -4;

Kernel::Point_3 exact_point(const Point3& p) {
  return {p.x, p.y, p.z};
}

Nef shadow_of_vertex(const Point3& light, const ConvexPolygon& blocker) {
  std::vector<Kernel::Point_3> points;
  for (const Point3& corner : blocker.points()) {
    const Kernel::Point_3 b = exact_point(corner), l = exact_point(light);
    points.push_back(b);
    points.push_back(b + (floor_z - b.z()) / (b.z() - l.z()) * (b - l));
  }
  Polyhedron shadow;
  CGAL::convex_hull_3(points.begin(), points.end(), shadow);
  return Nef(shadow);
}

double volume_of(const Polyhedron& polyhedron) {
  Kernel::FT sum = 0;
  const Kernel::Point_3 origin(0, 0, 0);
  for (auto facet = polyhedron.facets_begin(); facet != polyhedron.facets_end(); ++facet) {
    const auto first = facet->halfedge();
    for (auto edge = first->next(); edge->next() != first; edge = edge->next()) {
      sum += CGAL::volume(origin, first->vertex()->point(), edge->vertex()->point(), edge->next()->vertex()->point());
      CGAL::exact(sum);
    }
  }
  return CGAL::to_double(sum);
}

}  // namespace

double volume_of_nef_umbra(const PolygonPair& pair) {
  Nef umbra(Nef::COMPLETE);
  for (const Point3& l : pair.light_polygon().points()) umbra *= shadow_of_vertex(l, pair.blocker);
  Polyhedron boundary;
  umbra.convert_to_polyhedron(boundary);
  return volume_of(boundary);
}

}  // namespace gnomon::report
