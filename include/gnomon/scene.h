#pragma once

/// @file
/// Scene files: lights, blockers and receivers with names.
///
///     #include <gnomon/scene.h>
///     int main() {
///       const gnomon::Scene scene = gnomon::parse_scene(gnomon::default_scene_text(), "default", ".");
///       const auto& space = std::get<gnomon::SpaceScene>(scene);
///       const gnomon::SceneBodies bodies = gnomon::scene_bodies(space);
///       return space.lights.size() == 1 && bodies.names.size() == 1 && gnomon::default_clip_box(scene) ? 0 : 1;
///     }

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/convex_polygon.h"
#include "gnomon/flatland.h"
#include "gnomon/light.h"
#include "gnomon/point.h"
#include "gnomon/reflection.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// A light of space with its name, or a convex part of one: parts of one element of the file stand next to each other,
/// and what points receive of them is told of the element, see <gnomon/light_parts.h>. `strength` is radiance [W/(m²
/// sr)], intensity per length [W/(sr m)], intensity [W/sr] or irradiance [W/m²] for polygon, segment, point and
/// direction.
struct SceneLight {
  std::string name;
  Light shape;
  double strength = 1;
  Rgb color = {1, 1, 1};       ///< what the strength is multiplied by in reflected radiance
  std::string element = name;  ///< the light of the file: `lamp` of its part `lamp#2`
  std::string form = {};       ///< of a part: the light's shape there, in the file's word

  bool is_part() const { return element != name; }
};

/// A material with its name, that blockers and receivers refer to.
struct SceneMaterial {
  std::string name;
  Material material;
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

/// A triangle or polygon mesh, read from a file beside the scene or from the scene itself.
struct Mesh {
  std::string file;  ///< as written in the scene; empty if the mesh stands there
  std::vector<Point3> vertices;
  std::vector<std::vector<std::uint32_t>> facets;  ///< rings, with seams where a facet has holes
  bool closed = false;                             ///< every edge in exactly two facets, in opposite directions
  /// Of each facet, its number in the file, from 0; none if every facet of the file is here.
  std::vector<std::uint32_t> facet_numbers = {};
  /// Closed and, but for dents no deeper than this, the surface of the hull of its vertices: see deviation_from_convex.
  std::optional<double> dents = {};
  /// Of every corner of every facet, the file's normal, if it was asked for and the file has them all.
  std::vector<std::vector<Point3>> corner_normals = {};
};

using BlockerShape = std::variant<ConvexPolygon, Polytope, ConcavePolygon, Mesh>;

/// Where the normals at a mesh's vertices come from that pictures are shaded with: the facets' own, the mesh file's, or
/// means of the facets' that meet there, weighted by their angles, by their areas, or not at all.
enum class VertexNormals { flat, file, angle, area, equal };

/// How pictures take a surface for a smooth one.
struct Smoothness {
  VertexNormals normals = VertexNormals::flat;
  double crease = 180;  ///< degrees: facets whose normals differ by more are not averaged
};

struct SceneBlocker {
  std::string name;
  BlockerShape shape;
  std::string material = {};  ///< the name of one of the scene's; empty if the file names none
  Smoothness smoothness = {};
};

/// A flat convex piece of a receiver of the file; it receives from its front. See receiver_facets.
struct SceneReceiver {
  std::string name;  ///< of the piece: `floor`, `vase#12`, `vase/back#12`
  ConvexPolygon shape;
  std::string side = name;       ///< the receiver, or its side, that results are about: `vase`, `vase/back`
  std::string element = name;    ///< the receiver of the file: `vase`
  std::string form = "polygon";  ///< its shape there, in the file's word: polygon, polytope, concave_polygon, mesh
  std::string material = {};     ///< as of a blocker
  Smoothness smoothness = {};
  std::vector<Point3> file_normals = {};  ///< of the corners, as the mesh file has them; none if it has none

  /// True if the piece, its side or the receiver of the file is called so.
  bool is_called(const std::string& asked) const { return asked == name || asked == side || asked == element; }
};

/// A light of the plane with its name.
struct PlanarLight {
  std::string name;
  std::vector<Point2> vertices;  ///< one: a point light; two: a linear light
  double strength = 1;
};

/// A blocker or a receiver of the plane with its name.
struct PlanarBlocker {
  std::string name;
  std::vector<Point2> vertices;  ///< two: a segment; more: a polyline of consecutive segments
};

/// The axis that points up in pictures; nothing else asks for it.
enum class UpAxis { z, y };

/// Who looks at the scene in `gnomon image`, through a pinhole.
struct SceneCamera {
  Point3 eye;
  Point3 look_at;
  Point3 up{0, 0, 1};
  double fov = 40;  ///< the angle from the picture's lower to its upper border, in degrees
  std::uint32_t width = 640;
  std::uint32_t height = 480;
};

/// What is told of every checked scene file.
struct SceneFacts {
  std::string source;                    ///< the file as the user named it, or "default" for the embedded scene
  std::string length_unit = "m";         ///< the name of one of length_units
  std::vector<std::string> doubts = {};  ///< accepted, but worth a word: a sentence each, as `gnomon check` prints them
  std::size_t lighting_doubts = 0;       ///< so many of them, the last, are of lights and materials alone
};

/// A checked scene file of "dimension" 3.
struct SpaceScene : SceneFacts {
  std::vector<SceneLight> lights;
  std::vector<SceneBlocker> blockers;
  std::vector<SceneReceiver> receivers;
  UpAxis up = UpAxis::z;
  std::vector<SceneMaterial> materials;
  Rgb ambient_radiance = {0, 0, 0};  ///< that comes from everywhere [W/(m² sr)]
  std::optional<SceneCamera> camera = {};
};

/// A checked scene file of "dimension" 2.
struct PlaneScene : SceneFacts {
  std::vector<PlanarLight> lights;
  std::vector<PlanarBlocker> blockers;
  std::vector<PlanarBlocker> receivers;
};

using Scene = std::variant<SpaceScene, PlaneScene>;

const SceneFacts& facts(const Scene& scene);

/// 2 or 3.
int dimension(const Scene& scene);

/// The box by which unbounded volumes are cut unless the user gives one: the bounding box of everything in the scene,
/// receivers included, grown on every side by half its diagonal. Computed in doubles; exact from there on.
/// Nothing if a coordinate or the diagonal overflows or the box has no interior. In the plane, z runs from 0 to 0.
std::optional<Box3> default_clip_box(const Scene& scene);

/// A scene file that cannot be read. what() is the whole message for the user: file, JSON pointer (or line and
/// column where the text is no JSON), element name if it has one, what was found, what was expected.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A scene file that makes sense, but asks for what this version cannot do.
class UnsupportedSceneError : public SceneError {
 public:
  using SceneError::SceneError;
};

/// Reads and checks a scene file.
///
/// Throws: SceneError for everything that is wrong with the file; nothing else.
Scene read_scene(const std::filesystem::path& file);

/// Reads and checks a scene from text. `source` names it in messages; mesh files are looked up in `folder`.
///
/// Throws: SceneError.
Scene parse_scene(std::string_view text, const std::string& source, const std::filesystem::path& folder);

/// The scene that is built into the program: [P93] Figure 4.22, a triangular light above a rectangular blocker, with
/// a floor.
std::string_view default_scene_text();

/// What parts are made for. A convex mesh with dents, as rounding makes them, is the hull of its vertices for volumes;
/// for points it is what it is, so that points on its facets do not come to lie inside of it.
enum class PartsFor { points, volumes };

/// A convex piece of a blocker.
struct ConvexPart {
  std::string name;
  ConvexBlocker shape;
  std::vector<std::uint32_t> vertices;  ///< of each point of `shape`, its index among the blocker's vertices
};

/// The convex pieces whose union is the blocker.
///
/// Definition: a polygon is itself, or, rounded, the solid between its vertices; a polytope is its hull. A concave
///             polygon `board`, one with holes or a bent one is cut along diagonals between its own vertices into
///             `board#0`, `board#1`, ...: see convex_partition. Facet 12 of a mesh `vase` is `vase#12`, and if it is no
///             convex polygon `vase#12#0`, `vase#12#1`, ... Rounded pieces are solids. A convex closed mesh is one
///             solid, `vase`, one with dents for volumes only. Another closed mesh consists of its facets here; what it
///             encloses, enclosed_space tells.
/// Returns:    at least one part; in the order of the names.
/// Requires:   a blocker as scene files hold it: see BlockerShape.
/// Exactness:  no vertex is constructed; convexity is decided by exact signs.
/// Cost:       O(n log n) for most, O(n²) for the worst concave polygons.
std::vector<ConvexPart> convex_parts(const SceneBlocker& blocker, PartsFor use = PartsFor::points);

/// The surface that a closed mesh is which is no solid, in triangles between its own vertices; nothing for other
/// blockers.
std::optional<ClosedSurface> enclosed_space(const SceneBlocker& blocker);

/// The blockers of a scene of space as points, receivers and events take them: made once for all of these.
struct SceneBodies {
  Obstacles obstacles;                     ///< the convex parts of all blockers, in their order, and enclosed spaces
  std::vector<std::string> names;          ///< of each part
  std::vector<std::uint32_t> blocker_ids;  ///< of each part, the index of its blocker in the scene
};

SceneBodies scene_bodies(const SpaceScene& scene);

/// What points of a scene of the plane see of one of its lights.
planar::LightVisibility planar_visibility(const PlaneScene& scene, const PlanarLight& light);

}  // namespace gnomon
