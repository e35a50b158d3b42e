#pragma once

/// @file
/// Receivers divided exactly by what they receive of a light: lit, penumbra, umbra.
///
///     #include <gnomon/receiver_mesh.h>
///     int main() {
///       using namespace gnomon;
///       const Light lamp = AreaLight{ConvexPolygon::from_points({{0, 0, 4}, {0, 1, 4}, {1, 0, 4}})};
///       const ConvexBlocker board = ConvexPolygon::from_points({{-1, -1, 2}, {2, -1, 2}, {0, 2, 2}});
///       const ConvexPolygon floor = ConvexPolygon::from_points({{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}});
///       const ReceiverMesh mesh = receiver_division(lamp, {&board, 1}, {&floor, 1}).front();
///       return mesh.area().exact == "162" && mesh.regions().size() == 3 ? 0 : 1;
///     }

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/convex_polygon.h"
#include "gnomon/discontinuity.h"
#include "gnomon/light.h"
#include "gnomon/point.h"

namespace gnomon {

/// What a face of a receiver receives of a light. The numbers are those of the `region` arrays in output files.
enum class ReceiverRegion : std::uint8_t {
  lit = 0,
  penumbra = 1,
  umbra = 2,
  unlit = 3,
  unresolved_eee = 4,  ///< three edges in line may close the last gap in the face: penumbra and umbra could both occur
};

inline constexpr std::size_t receiver_region_count = 5;

constexpr std::string_view name(ReceiverRegion region) {
  constexpr std::string_view names[] = {"lit", "penumbra", "umbra", "unlit", "unresolved_eee"};
  return names[static_cast<int>(region)];
}

/// An edge as it is met when a face's boundary is walked along: 2 * edge forward, 2 * edge + 1 backward.
using MeshEdgeUse = std::uint32_t;

/// An open segment or arc between two faces, or inside of one.
struct MeshEdge {
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t source = 0;
  std::uint32_t target = 0;
  std::uint32_t left = nowhere;      ///< the face on the left, seen from the front; `nowhere` beyond the border
  std::uint32_t right = nowhere;     ///< the face on the right
  std::vector<std::uint32_t> names;  ///< the events that run along it: indices into ReceiverMesh::names()
  std::uint32_t arc = nowhere;       ///< index into ReceiverMesh::arcs(); `nowhere` of a segment
};

/// The arc of a conic, from an edge's source to its target, as a rational quadratic Bezier curve.
///
/// A point of it, at 0 <= t <= 1: (1-t)^2 p0 + 2 t (1-t) w p1 + t^2 p2 over (1-t)^2 + 2 t (1-t) w + t^2.
struct MeshArc {
  std::array<Point3, 3> points{};  ///< p0, p1, p2; the middle one is an estimate, of ends known to 2^-100
  double weight = 1;               ///< w > 0, such an estimate: below 1 of an ellipse, above 1 of a hyperbola
};

/// A face that no event crosses that could change its region.
struct MeshFace {
  ReceiverRegion region = ReceiverRegion::lit;
  std::vector<std::vector<MeshEdgeUse>> cycles;  ///< the face on the left; the outer cycle first, then holes
};

/// A part of a face.
struct ReceiverTriangle {
  std::array<std::uint32_t, 3> vertices{};
  std::uint32_t face = 0;
  bool is_at_arc = false;  ///< one of its sides stands for a piece of an arc
};

/// A mesh with chords for its arcs.
struct MeshDrawing {
  std::vector<Point3> points;                     ///< the mesh's vertices, then points on arcs; rounded to nearest
  std::vector<ReceiverTriangle> triangles;        ///< the faces, counterclockwise seen from the front
  std::vector<std::vector<std::uint32_t>> lines;  ///< of each edge, from its source to its target
  double chord_error = 0;                         ///< no point of an arc is farther from its chords
  bool chords_cross = false;                      ///< some do, or cross an edge: triangles beside them are not exact
};

/// Connected faces of one region.
struct RegionPolygon {
  ReceiverRegion region = ReceiverRegion::lit;
  std::vector<std::uint32_t> faces;
  std::vector<std::vector<MeshEdgeUse>> cycles;  ///< the region on the left; the outer cycle first, then holes
};

/// An area: rounded, and exactly where it is rational.
struct RegionArea {
  double nearest = 0;  ///< nearest double where `exact` is given, else off by at most an ulp
  std::optional<std::string> exact;
};

/// The sum of areas: exact and correctly rounded where all of them are, else the sum of the rounded ones.
RegionArea total_area(std::span<const RegionArea> areas);

/// A receiver, divided by all discontinuities of what it receives of one light.
///
/// Definition: the faces between the traces of all events of theory section 6, of the triple-edge ones (three edges in
///             line) those that bound an umbra, and the receiver's border. Of a point on the receiver the limit from
///             its front is meant, and of the light what lies strictly before the receiver's plane: unlit where nothing
///             does, or where the light shows its back or its edge; else lit, penumbra or umbra by how much of that is
///             hidden. See docs/receivers.md.
/// Exactness:  the structure and the labels are exact, and so are areas without arcs; coordinates are rounded once,
/// when
///             they leave.
/// After:      [P93] §4.4.3, complete EV discontinuity meshing as of Heckbert and of Lischinski et al.; triple edges
///             after Demouth, Devillers, Everett, Glisse, Lazard, Seidel (2009).
class ReceiverMesh {
 public:
  /// Rounded to nearest; of vertices with irrational coordinates, at ends of arcs, off by at most an ulp.
  std::vector<Point3> vertices() const;
  std::size_t vertex_count() const;
  const std::vector<MeshEdge>& edges() const;
  const std::vector<MeshFace>& faces() const;
  const std::vector<EventName>& names() const;

  std::vector<MeshArc> arcs() const;

  /// The mesh as triangles and lines. Chords of arcs are at most 1/4096 of the receiver's width from them, closer where
  /// they would cross others, as far as a few trials go.
  MeshDrawing drawing() const;

  /// Connected components of equal region.
  std::vector<RegionPolygon> regions() const;

  /// The area of each region, in the order of ReceiverRegion, and of the whole receiver.
  std::array<RegionArea, receiver_region_count> areas() const;
  RegionArea area() const;

  /// True if the areas of all regions sum up to the receiver's exactly. (They do; it is for tests.)
  bool areas_add_up() const;

  struct Data;
  explicit ReceiverMesh(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// What stands against dividing receivers, in words for people that follow the name of the light, blocker or receiver;
/// empty if nothing does. With one coordinate out of range no receiver of the scene is divided.
std::string_view range_refusal(const Light& light);
std::string_view range_refusal(std::span<const Point3> points);

/// What stands against dividing receivers by this light; empty if nothing does.
std::string_view division_refusal(const Light& light, std::span<const ClosedSurface> enclosures = {});

/// Receivers, ready to be divided by what they receive of one light behind all blockers.
///
/// Events are found and traced for all receivers together; any number of threads may ask for meshes then. What is found
/// does not depend on the number of threads.
class ReceiverDivision {
 public:
  /// Enclosures are what closed meshes enclose whose facets are among the blockers: what lies strictly inside is umbra.
  /// Requires: no refusal by range or of the light or a receiver.
  /// Throws:   PreconditionError.
  /// Cost:     events are found by searching hierarchies, and traced where they reach a receiver, by that many threads.
  ReceiverDivision(const Light& light, std::span<const ConvexBlocker> blockers,
                   std::span<const ConvexPolygon> receivers, unsigned threads = 1,
                   std::span<const ClosedSurface> enclosures = {});

  std::size_t size() const;

  /// The receiver of that index, divided; its faces are labelled by that many threads.
  ReceiverMesh mesh(std::uint32_t receiver, unsigned threads = 1) const;

  /// The visible fraction at each vertex of its mesh, as visible_fraction(VisiblePart) rounds it: the measure of what
  /// is seen of the light before the receiver's plane, as a share of that of all of the light.
  /// Definition: of a vertex on a discontinuity of order 0 one of the limits is meant.
  std::vector<double> visible_fractions(std::uint32_t receiver, const ReceiverMesh& mesh, unsigned threads = 1) const;

  struct Data;

 private:
  std::shared_ptr<const Data> data_;
};

/// The meshes of all receivers at once, nothing kept.
std::vector<ReceiverMesh> receiver_division(const Light& light, std::span<const ConvexBlocker> blockers,
                                            std::span<const ConvexPolygon> receivers,
                                            std::span<const ClosedSurface> enclosures = {});

}  // namespace gnomon
