#include "tests/benchmarks/cgal_baselines.h"

#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <vector>

#include "geometry/kernel.h"
#include "geometry/spatial/extremal_planes.h"

namespace gnomon::benchmarks {
namespace {

using Polyhedron = CGAL::Polyhedron_3<InputKernel>;
using Plane = InputKernel::Plane_3;
using CgalPoint = InputKernel::Point_3;

constexpr double floor_z = -4;

CgalPoint on_the_floor(const CgalPoint& light, const CgalPoint& blocker) {
  const double t = (floor_z - blocker.z()) / (blocker.z() - light.z());
  return blocker + t * (blocker - light);
}

/// The plane through p, q, r with `inside` on its negative side.
Plane turned_plane(const CgalPoint& p, const CgalPoint& q, const CgalPoint& r, const CgalPoint& inside) {
  const Plane plane(p, q, r);
  return plane.has_on_positive_side(inside) ? plane.opposite() : plane;
}

CgalPoint vertex(const ConvexPolygon& polygon, std::size_t k) {
  return to_cgal(polygon.points()[k % polygon.points().size()]);
}

}  // namespace

std::size_t facets_of_vertex_shadow_hull(const PolygonPair& pair) {
  std::vector<CgalPoint> points;
  for (const Point3& b : pair.blocker.points()) {
    points.push_back(to_cgal(b));
    for (const Point3& l : pair.light_polygon().points()) points.push_back(on_the_floor(to_cgal(l), to_cgal(b)));
  }
  Polyhedron hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return hull.size_of_facets();
}

std::size_t facets_of_halfspace_intersection(const PolygonPair& pair) {
  const ConvexPolygon& light = pair.light_polygon();
  const ConvexPolygon& blocker = pair.blocker;
  const CgalPoint inside(0, 0, 0);
  std::vector<Plane> planes = {Plane(0, 0, -1, floor_z),
                               turned_plane(vertex(blocker, 0), vertex(blocker, 1), vertex(blocker, 2), inside)};
  const ExtremalPlanes named = extremal_planes(pair.light, blocker);
  for (const BlockerPlane& plane : named.separating_blocker) {
    const std::size_t k = number(plane.edge);
    planes.push_back(
        turned_plane(vertex(blocker, k), vertex(blocker, k + 1), vertex(light, number(plane.vertex)), inside));
  }
  for (const LightPlane& plane : named.separating_light) {
    const std::size_t k = number(plane.edge);
    planes.push_back(
        turned_plane(vertex(light, k), vertex(light, k + 1), vertex(blocker, number(plane.vertex)), inside));
  }
  Polyhedron volume;
  CGAL::halfspace_intersection_3(planes.begin(), planes.end(), volume, inside);
  return volume.size_of_facets();
}

}  // namespace gnomon::benchmarks
