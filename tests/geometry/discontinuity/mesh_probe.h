#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "geometry/discontinuity/receiver_mesh_data.h"
#include "gnomon/receiver_mesh.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// The face that holds a point in its inside; nothing on an edge and beyond the border. By the definition: the winding
/// number of the face's cycles, in rational arithmetic.
std::optional<std::uint32_t> face_at(const ReceiverMesh& mesh, const ExactVector& point);

/// The triangles of a mesh between its own vertices that do not border on an arc.
std::vector<ReceiverTriangle> straight_triangles(const ReceiverMesh& mesh);

/// Whether a point lies inside of a face.
bool is_in_face(const ReceiverMesh& mesh, std::uint32_t face, const ExactVector& point);

/// A polygon in the plane z = `z`: the rectangle from (x0, y0) to (x1, y1), seen from above or below counterclockwise.
enum class Facing { up, down };
ConvexPolygon rectangle(double x0, double y0, double x1, double y1, double z, Facing facing);

/// A box with edges parallel to the axes.
ConvexBlocker box(const Point3& low, const Point3& high);

/// A prism on a rectangle around (x, y), turned by the angle of the vector (c, s), whose length counts.
ConvexBlocker turned_box(double x, double y, double z0, double z1, double c, double s);

AreaLight lamp(ConvexPolygon polygon);

/// The convex parts of all blockers of a scene, and its receivers.
std::vector<ConvexBlocker> parts_of_blockers(const SpaceScene& scene);
std::vector<ConvexPolygon> receivers_of(const SpaceScene& scene);

/// Points of a horizontal receiver whose region is compared with exact_visibility.
struct ProbeResult {
  std::size_t compared = 0;
  std::size_t different = 0;
  std::size_t unresolved = 0;
};
ProbeResult compare_with_definition(const ReceiverMesh& mesh, const ConvexPolygon& receiver, const Light& light,
                                    const std::vector<ConvexBlocker>& blockers, std::size_t count, unsigned seed);

}  // namespace gnomon
