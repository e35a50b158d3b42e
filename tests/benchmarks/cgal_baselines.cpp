#include "tests/benchmarks/cgal_baselines.h"

#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <CGAL/Polyhedron_3.h>

#include <vector>

#include "geometry/numbers/kernel.h"
#include "gnomon/pair.h"

namespace gnomon::benchmarks {
namespace {

using Polyhedron = CGAL::Polyhedron_3<InputKernel>;
using Plane = InputKernel::Plane_3;
using CgalPoint = InputKernel::Point_3;

constexpr double floor_z = -4;

/// The plane through p, q, r with `inside` on its negative side.
Plane turned_plane(const CgalPoint& p, const CgalPoint& q, const CgalPoint& r, const CgalPoint& inside) {
  const Plane plane(p, q, r);
  return plane.has_on_positive_side(inside) ? plane.opposite() : plane;
}

CgalPoint vertex(const ConvexPolygon& polygon, std::size_t k) {
  return to_cgal(polygon.points()[k % polygon.points().size()]);
}

}  // namespace

std::size_t facets_of_halfspace_intersection(const report::PolygonPair& pair) {
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
