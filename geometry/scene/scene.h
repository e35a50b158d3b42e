#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/point.h"
#include "geometry/spatial/convex_polygon.h"
#include "geometry/spatial/light.h"

namespace gnomon {

/// A light of space with its name. `strength` is radiance [W/(m² sr)], intensity per length [W/(sr m)], intensity
/// [W/sr] or irradiance [W/m²] for polygon, segment, point and direction.
struct SceneLight {
  std::string name;
  Light shape;
  double strength = 1;
};

/// The convex hull of points: at least 4, not coplanar.
struct Polytope {
  std::vector<Point3> vertices;
};

/// A polygon that is taken as several convex parts: one that is not convex, has holes, or is bent (see Flatness).
struct ConcavePolygon {
  std::vector<Point3> vertices;  ///< of all rings, one after the other
  /// Indices of vertices: the outer ring, then the holes. None: one ring of all vertices.
  std::vector<std::vector<std::uint32_t>> rings = {};
  std::string shape = "concave_polygon";  ///< as the scene file calls it
};

/// A triangle or polygon mesh read from a file beside the scene.
struct Mesh {
  std::string file;  ///< as written in the scene
  std::vector<Point3> vertices;
  std::vector<std::vector<std::uint32_t>> facets;  ///< rings, with seams where a facet has holes
  bool closed = false;                             ///< every edge in exactly two facets, in opposite directions
  /// Of each facet, its number in the file, from 0; none if every facet of the file is here.
  std::vector<std::uint32_t> facet_numbers = {};
  /// Closed and, but for dents no deeper than this, the surface of the hull of its vertices: see deviation_from_convex.
  std::optional<double> dents = {};
};

using BlockerShape = std::variant<ConvexPolygon, Polytope, ConcavePolygon, Mesh>;

struct SceneBlocker {
  std::string name;
  BlockerShape shape;
};

/// A flat convex piece of a receiver of the file; it receives from its front. See receiver_facets.
struct SceneReceiver {
  std::string name;  ///< of the piece: `floor`, `vase#12`, `vase/back#12`
  ConvexPolygon shape;
  std::string side = name;     ///< the receiver, or its side, that results are about: `vase`, `vase/back`
  std::string element = name;  ///< the receiver of the file: `vase`

  /// True if the piece, its side or the receiver of the file is called so.
  bool is_called(const std::string& asked) const { return asked == name || asked == side || asked == element; }
};

/// Lights, blockers and receivers of the plane (`dimension` 2).
struct PlanarLight {
  std::string name;
  std::vector<Point2> vertices;  ///< one: a point light; two: a linear light
  double strength = 1;
};

struct PlanarBlocker {
  std::string name;
  std::vector<Point2> vertices;  ///< two: a segment; more: a polyline of consecutive segments
};

/// The axis that points up in pictures; nothing else asks for it.
enum class UpAxis { z, y };

/// A checked scene file. In dimension 3 the spatial lists are filled, in dimension 2 the planar ones.
struct Scene {
  std::string source;  ///< the file as the user named it, or "default" for the embedded scene
  int dimension = 3;
  std::string length_unit = "m";  ///< the name of one of length_units
  std::vector<SceneLight> lights;
  std::vector<SceneBlocker> blockers;
  std::vector<SceneReceiver> receivers;
  std::vector<PlanarLight> planar_lights;
  std::vector<PlanarBlocker> planar_blockers;
  std::vector<PlanarBlocker> planar_receivers;
  std::vector<std::string> doubts;  ///< accepted, but worth a word: one sentence each, as `gnomon check` prints them
  UpAxis up = UpAxis::z;            ///< in pictures of space
};

/// The box by which unbounded volumes are cut unless the user gives one: the bounding box of everything in the scene,
/// receivers included, grown on every side by half its diagonal. Computed in doubles; exact from there on.
/// Nothing if a coordinate or the diagonal overflows or the box has no interior. In dimension 2, z runs from 0 to 0.
std::optional<Box3> default_clip_box(const Scene& scene);

}  // namespace gnomon
