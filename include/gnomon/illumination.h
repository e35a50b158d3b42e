#pragma once

/// @file
/// Meshes of receivers that tell the irradiance everywhere on them to within a tolerance.
///
///     #include <gnomon/illumination.h>
///     int main() {
///       using namespace gnomon;
///       const IlluminationLight bulb = {{PointLight{{0.5, 0.5, 1}}}, 2};  // 2 W/sr, 1 m above the middle
///       const ConvexPolygon floor = ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
///       const Illumination found = illuminate({&bulb, 1}, {}, {&floor, 1}, {.tolerance = 0.05});  // of the largest
///       const IlluminationMesh& mesh = found.meshes.front();
///       return found.largest > 1.99 && mesh.unmet_faces() == 0 && mesh.faces.size() > 2 ? 0 : 1;
///     }

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gnomon/convex_polygon.h"
#include "gnomon/irradiance.h"
#include "gnomon/light.h"
#include "gnomon/point.h"
#include "gnomon/processes.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// A light, as its parts, that shines with one strength: see LightIrradiance.
struct IlluminationLight {
  std::vector<Light> parts;
  double strength = 1;
};

/// Which discontinuities are edges of a mesh beside those of order 0 and 1, which always are.
enum class IlluminationSplit {
  need,  ///< those of order 2 on a receiver where that takes fewer faces
  all,   ///< all of them
  none,  ///< no others
};

struct IlluminationEffort {
  double tolerance = 0.01;  ///< how far off interpolated irradiance may be
  bool is_relative = true;  ///< `tolerance` is a share of the largest irradiance found, else in W/m²
  int order = 1;            ///< 1: linear faces; 2: quadratic ones
  IlluminationSplit split = IlluminationSplit::need;
  std::size_t most_faces = 1000000;  ///< of one receiver, about: those whose error times area is largest go first
  LengthUnit unit = {"m", 1, 1};     ///< of all coordinates
  unsigned threads = 1;
  Processes processes = {};  ///< that share the work
  /// Told how many receivers are done, of how many, and how many faces there are so far; called by one thread.
  std::function<void(std::size_t done, std::size_t of, std::size_t faces)> progress = {};
};

/// A triangle of a mesh, whose irradiance is interpolated between its points.
struct IlluminationFace {
  std::array<std::uint32_t, 3> corners{};  ///< counterclockwise seen from the front
  std::array<std::uint32_t, 3> middles{};  ///< with order 2: of the edges from each corner to the next; else nothing
  double error = 0;                        ///< an estimate of the largest error of interpolation in it [W/m²]
  bool is_met = true;                      ///< the error is within the tolerance
};

/// An edge of a mesh along a discontinuity.
struct IlluminationEdge {
  std::array<std::uint32_t, 2> ends{};  ///< points of one of its faces
  std::uint8_t order = 0;               ///< of the lowest derivative that may jump
};

/// A receiver in faces.
///
/// Points are shared by faces, but where irradiance may jump (discontinuities of order 0) or have many limits (where a
/// blocker touches the receiver): there each face has a point of its own, whose irradiance is that of a place 2^-20 of
/// the way into the face.
struct IlluminationMesh {
  int order = 1;  ///< 1: linear faces; 2: quadratic ones
  std::vector<Point3> points;
  std::vector<Irradiance> irradiance;              ///< of each point, of all lights together [W/m²]
  std::vector<std::vector<Irradiance>> of_lights;  ///< of each light, of each point
  std::vector<IlluminationFace> faces;
  std::vector<IlluminationEdge> edges;

  double largest_error() const;
  std::size_t unmet_faces() const;
  double unmet_area() const;
  double area() const;
  /// The integral of what is interpolated [W], lengths in metres as the coordinates are.
  double flux() const;
  /// The integral of the faces' errors: what the flux may be off by.
  double flux_error() const;
};

/// The irradiance that a mesh interpolates, as a function of the place.
///
/// Method: a grid over the mesh, of about as many cells as faces, knows which faces reach into each cell.
class IlluminationField {
 public:
  /// Takes what it needs of the mesh, which may be empty.
  explicit IlluminationField(const IlluminationMesh& mesh);

  /// Of all lights together [W/m²], with the error of the face that is asked; none outside the mesh. The place is
  /// taken along the axis that is nearest to the mesh's normal. What lies outside by rounding alone is in the face.
  /// Exactness: off from what the points' irradiance interpolates by less than 1e-12 of the largest of them;
  /// `error_bound`
  ///            is the face's error, an estimate.
  std::optional<Irradiance> at(const Point3& place) const;

 private:
  struct Faces;
  std::shared_ptr<const Faces> faces_;
};

struct Illumination {
  std::vector<IlluminationMesh> meshes;  ///< of each receiver
  double tolerance = 0;                  ///< [W/m²]
  double largest = 0;                    ///< the largest irradiance found that is finite [W/m²]
  std::size_t evaluations = 0;           ///< how often irradiance behind obstacles was asked for
};

/// The receivers in faces that are fine enough for the irradiance of all lights together.
///
/// Method:     each receiver is cut along the discontinuities of order 0 and 1 of every light, and those of order 2
///             where that pays. A face is halved while its interpolated irradiance is too far off at 25 places beside
///             its corners, or in a region of the exact division that it holds: the edge across from a point of many
///             limits where it is they that are too far apart, else the longest edge. No face's corner lies inside
///             another's edge, across coplanar receivers that share an edge, too.
/// Requires:   no refusal (range_refusal, division_refusal) of lights, receivers and blockers; a positive tolerance.
/// Exactness:  irradiance of points has a bound. Errors of faces are estimates: 1.2 (order 2: 1.4) times the largest
///             difference seen, and the bounds at the corners. Cuts are rounded to doubles. The result does not depend
///             on the number of threads and of processes.
/// Throws:     PreconditionError.
/// After:      [CF91] §3, §4.
Illumination illuminate(std::span<const IlluminationLight> lights, const Obstacles& obstacles,
                        std::span<const ConvexPolygon> receivers, const IlluminationEffort& effort);

}  // namespace gnomon
