#pragma once

/// @file
/// The plane divided exactly by what is seen of one light behind many segments.
///
///     #include <gnomon/flatland_partition.h>
///     int main() {
///       using namespace gnomon::planar;
///       const gnomon::Point2 light[] = {{-2, 4}, {2, 4}};
///       const BlockerSegment wall = {{{-1, 2}, {1, 2}}};
///       const Partition parts = partition(LightVisibility(Flatland::from_points(light, {&wall, 1})));
///       const PartitionLocation location(parts);  // made ready for many points
///       return parts.count(gnomon::Region::umbra) == 1 && location.region({0, 1}) == gnomon::Region::umbra ? 0 : 1;
///     }

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "gnomon/flatland.h"
#include "gnomon/names.h"
#include "gnomon/point.h"

namespace gnomon::planar {

/// What a boundary lies on.
enum class BoundaryKind : std::uint8_t {
  blocker,     ///< blocker `element`
  light_line,  ///< the light's line
  event,       ///< the line through the points `near` and `far`
  clip_box,    ///< side `element` of the box: 0 to 3 for x min, x max, y min, y max
};

/// The name of a boundary by input elements.
struct BoundaryName {
  BoundaryKind kind = BoundaryKind::event;
  std::uint32_t element = 0;
  EventPoint near;                        ///< of an event: the point nearer to the light, or on it
  EventPoint far;                         ///< of an event: a blocker's end
  Contact contact = Contact::separating;  ///< of an event: what `near` and `far` belong to lies on opposite sides of it
};

/// "No vertex" of an edge that comes from or goes to infinity, "no face" outside the box.
inline constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// An open piece of a line that bounds faces, or lies inside one and differs from it.
struct PartitionEdge {
  std::uint32_t source = nowhere;
  std::uint32_t target = nowhere;
  std::uint32_t left = nowhere;   ///< the face on the left of the edge as it runs from source to target
  std::uint32_t right = nowhere;  ///< the face on its right
  std::uint32_t name = 0;         ///< index into Partition::names
};

/// An edge as it is met when a face's boundary is walked along.
struct EdgeUse {
  enum class Way : std::uint8_t { forward, backward };
  std::uint32_t edge = 0;
  Way way = Way::forward;
};

/// A face: a connected open set of points with one label.
/// Orientation: the face lies on the left of every boundary cycle; a cycle of an unbounded face may pass through
///              infinity, between an edge without a target and one without a source.
struct PartitionFace {
  Region region = Region::lit;
  bool bounded = true;
  std::vector<std::vector<EdgeUse>> boundary;
  std::vector<std::uint32_t> points;     ///< vertices inside the face whose own region is another one
  std::vector<VisibleInterval> visible;  ///< of a finer partition: what is seen, as seen from one point of the face
};

/// How fine the faces are.
enum class Fineness {
  regions,    ///< faces that share an edge differ in region
  structure,  ///< or in what is visible, as a list of named intervals: the visible fraction is one formula in each face
};

/// The plane, or a box of it, divided by what is seen of one light behind many blockers.
///
/// Definition: the points with f = 1, 0 < f < 1 and f = 0 outside the edges and vertices; each face is a component of
///             the interior of one of these sets. An edge lies between faces of different labels, or inside a face
///             where its own points have another region (a light on a blocker's line throws such shadows).
/// Exactness:  all labels and the whole structure are exact; vertices are constructed exactly, and rounded once when
///             they leave.
class Partition {
 public:
  /// Coordinates rounded to nearest.
  const std::vector<Point2>& vertices() const;
  const std::vector<PartitionEdge>& edges() const;
  const std::vector<PartitionFace>& faces() const;
  const std::vector<BoundaryName>& names() const;
  const LightVisibility& visibility() const;
  const std::optional<Box2>& box() const;

  /// The number of faces of a region: its components.
  std::size_t count(Region region) const;

  struct Data;
  explicit Partition(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

struct PartitionOptions {
  Fineness fineness = Fineness::regions;
  std::optional<Box2> box;  ///< nothing: the whole plane, unbounded faces as such
};

/// Divides the plane.
///
/// Requires: a box, if any, with finite coordinates and an interior.
/// Throws:   PreconditionError.
/// Cost:     grows with the arrangement of the event rays, which are cut where no light reaches them.
/// After:    [P93] §4.2.2.2.
Partition partition(const LightVisibility& visibility, const PartitionOptions& options = {});

/// A triangle of a face. Orientation: counterclockwise; corners index PartitionInBox::points.
struct FaceTriangle {
  std::array<std::uint32_t, 3> corners{};
  std::uint32_t face = 0;
};

/// A face's area, and what rounding does not touch of it.
struct FaceInBox {
  Region region = Region::lit;
  ExactNumber area;
};

/// A partition of a box as it is drawn and written.
struct PartitionInBox {
  std::vector<Point2> points;           ///< the partition's vertices, each coordinate rounded once, to nearest
  std::vector<FaceTriangle> triangles;  ///< share whole sides with each other and with the edges; tile the box
  std::vector<FaceInBox> faces;
  std::array<ExactNumber, 3> areas;  ///< of lit, penumbra and umbra

  const ExactNumber& area(Region region) const { return areas[static_cast<std::size_t>(region)]; }
};

/// Triangulates the faces.
///
/// Requires:   partition.box(): a partition of a box.
/// Degenerate: two points may round to one; the triangles keep their corners.
/// Exactness:  triangulated and measured exactly; rounded at the end.
/// Throws:     PreconditionError.
PartitionInBox partition_in_box(const Partition& partition);

/// A partition prepared for questions about many points.
///
/// Definition: the plane is cut into slabs by the upright lines through the vertices; the edges that cross a slab have
///             one order in all of it.
/// Degenerate: a point on an edge or a vertex lies in no face, and what holds there is asked of the point itself.
/// Exactness:  all answers are those of LightVisibility for every finite point.
/// Cost:       to prepare O(v (log v + e)) for v vertices and at most e edges across a slab, in time and in memory. A
///             point in a face O(log v); one on an edge or a vertex, or outside the box, what it costs LightVisibility.
class PartitionLocation {
 public:
  explicit PartitionLocation(const Partition& partition);

  /// Where the point lies: index into Partition::faces, or `nowhere` on an edge or a vertex and outside the box.
  std::uint32_t face(const Point2& point) const;

  /// The region of the point.
  Region region(const Point2& point) const;

  /// What the point sees of the light. In a penumbra face of a partition without the structure, what it costs
  /// LightVisibility.
  ///
  /// Degenerate: where two ends hide one another as seen from the point, an interval may bear the name of either.
  VisibleLight visible_light(const Point2& point) const;

 private:
  class Slabs;

  Partition partition_;
  std::shared_ptr<const Slabs> slabs_;
};

}  // namespace gnomon::planar
