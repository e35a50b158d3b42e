#pragma once

/// Places of receivers where irradiance may have many limits. Private to the libraries.

#include <span>
#include <vector>

#include "geometry/bodies/body.h"
#include "geometry/numbers/exact_vector.h"
#include "gnomon/convex_polygon.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon::illumination {

/// The bodies of all lights that are somewhere, and of all blockers.
std::vector<Body> touching_bodies(std::span<const Light> lights, std::span<const ConvexBlocker> blockers);

/// Places of a receiver that a vertex of a body lies on, or where an edge pierces it: irradiance may have many limits.
std::vector<ExactVector> touching_places(std::span<const Body> bodies, const ConvexPolygon& receiver);

/// Vertices of a divided receiver where lines along which irradiance jumps meet at an angle: there it has many limits.
std::vector<Point3> corners_of_jumps(const ReceiverMesh& mesh);

/// Each coordinate rounded to nearest, as vertices of meshes are.
Point3 nearest_point(const ExactVector& p);

}  // namespace gnomon::illumination
