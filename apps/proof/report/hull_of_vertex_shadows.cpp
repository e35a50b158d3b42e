#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <vector>

#include "apps/proof/report/vectors.h"
#include "apps/proof/report/volume_peers.h"
#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/kernel.h"
#include "geometry/numbers/rounding.h"

namespace gnomon::report {
namespace {

using Polyhedron = CGAL::Polyhedron_3<InputKernel>;

constexpr double floor_z = -4;

Point3 on_the_floor(const Point3& light, const Point3& blocker) {
  return sum(blocker, scaled((floor_z - blocker.z) / (blocker.z - light.z), difference(blocker, light)));
}

Polyhedron hull(const PolygonPair& pair) {
  std::vector<InputKernel::Point_3> points;
  for (const Point3& b : pair.blocker.points()) {
    points.push_back(to_cgal(b));
    for (const Point3& l : pair.light_polygon().points()) points.push_back(to_cgal(on_the_floor(l, b)));
  }
  Polyhedron result;
  CGAL::convex_hull_3(points.begin(), points.end(), result);
  return result;
}

ExactVector corner(Polyhedron::Halfedge_const_handle edge) {
  const auto& p = edge->vertex()->point();
  return exact({p.x(), p.y(), p.z()});
}

}  // namespace

std::size_t facets_of_vertex_shadow_hull(const PolygonPair& pair) {
  return hull(pair).size_of_facets();
}

double volume_of_vertex_shadow_hull(const PolygonPair& pair) {
  const Polyhedron polyhedron = hull(pair);
  Rational sum = 0;
  for (auto facet = polyhedron.facets_begin(); facet != polyhedron.facets_end(); ++facet) {
    const auto first = facet->halfedge();
    for (auto edge = first->next(); edge->next() != first; edge = edge->next()) {
      sum += dot(corner(first), cross(corner(edge), corner(edge->next())));
    }
  }
  return nearest_double(sum / 6);
}

}  // namespace gnomon::report
