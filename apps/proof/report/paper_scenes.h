#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::report {

/// A scene of the papers' Tables II and III: a linear light, blockers, and points from which it is asked for.
struct PaperScene {
  std::string name;
  LinearLight light;
  std::vector<ConvexBlocker> blockers;
  std::vector<Point3> points;
};

/// A tetrahedron of 4^depth tetrahedra, each of four triangles; points on its floor and around it.
PaperScene tetrahedron_pyramid(int depth, std::size_t points);

/// A sphere with nine spheres of a third of its radius on it, six around and three above, and so on `levels` times, and
/// a square far larger below, on which the points are. Spheres are solids: see icosphere.
PaperScene sphereflake(int levels, std::size_t points);

/// A solid of 320 triangles with its 162 corners on a sphere.
ConvexSolid icosphere(const Point3& centre, double radius);

/// The largest distance of a point of the sphere from that solid, as a share of the radius: an estimate, in doubles.
double icosphere_deviation();

}  // namespace gnomon::report
