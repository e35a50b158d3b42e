#pragma once

/// A light, blockers and receivers as lists of points, edges and faces with names. Private to this folder.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bodies/sides.h"
#include "geometry/discontinuity/pencil.h"
#include "geometry/discontinuity/rough_half_space.h"
#include "gnomon/blocker.h"
#include "gnomon/discontinuity.h"
#include "gnomon/light.h"

namespace gnomon::event {

using EdgeId = std::uint32_t;
using ShapeId = std::uint32_t;

/// A face at an edge, by a vertex of it off the edge's line.
struct FaceAtEdge {
  ShapeId shape = 0;
  PointId third = 0;
};

/// An edge of one or more blockers, each with the same ends.
struct BlockerEdge {
  PointId a = 0;
  PointId b = 0;
  EventElement name;  ///< in the first of its blockers
  std::vector<FaceAtEdge> faces;
  bool may_be_seen = true;  ///< as part of an outline, against the light
};

/// An edge of a shape, and the two loops it belongs to.
struct ShapeEdge {
  PointId a = 0;
  PointId b = 0;
  EdgeId edge = 0;
};

/// A convex blocker, flat or solid, or a receiver's polygon.
struct Shape {
  bool is_solid = false;
  std::vector<PointId> corners;              ///< of a flat shape: in order
  std::vector<ShapeEdge> edges;              ///< of a flat shape: from each corner to the next
  std::vector<std::vector<PointId>> facets;  ///< of a solid: loops, counterclockwise seen from outside
  std::array<PointId, 3> plane{};            ///< of a receiver: points of the scene that span it, counterclockwise
  std::vector<ShapeId> own;                  ///< of a receiver: what it is a facet of, up to rounding; ascending
  bool is_in_front = true;                   ///< some corner lies strictly in front of the light's plane, ...
  bool is_behind = false;                    ///< ... some strictly behind
};

/// A blocker's vertex.
struct BlockerVertex {
  PointId point = 0;
  EventElement name;  ///< in the first of its blockers
  std::vector<ShapeId> shapes;
  std::vector<EdgeId> edges;
  bool may_be_seen = false;
};

/// An edge of the light.
struct LightEdge {
  PointId a = 0;
  PointId b = 0;
  EventElement name;
};

struct LightVertex {
  PointId point = 0;
  EventElement name;
};

enum class LightKind : std::uint8_t { point, direction, linear, area };

/// A flat blocker or a facet of a solid whose plane cuts the light: seen from its side it parts the light.
struct CuttingFacet {
  EventElement name;
  std::vector<PointId> loop;
  std::vector<EdgeId> edges;
  std::array<PointId, 2> light_ends{};  ///< where the plane cuts the light's outline; of a linear light twice the same
};

/// Thin solids between a receiver's own vertices, that stand for polygons whose vertices were rounded, hide nothing
/// from it.
/// Requires: the rounding mode is protected while it is made.
class EventScene {
 public:
  EventScene(const Light& light, std::span<const ConvexBlocker> blockers, std::span<const ConvexPolygon> receivers);

  LightKind kind = LightKind::point;
  bool is_two_sided = true;  ///< points, directions and segments count as such
  std::vector<EventPoint> points;
  std::vector<LightVertex> light_vertices;  ///< of an area light: in order
  std::vector<LightEdge> light_edges;
  /// Where blockers meet the light: places where they touch it and the ends of what they cut count as vertices of the
  /// light, what they cut counts as edges.
  std::vector<LightVertex> cut_vertices;
  std::vector<LightEdge> cut_edges;
  std::vector<CuttingFacet> cutting_facets;
  std::array<PointId, 3> light_plane{};  ///< of an area light, front positive
  std::vector<BlockerEdge> edges;
  std::vector<BlockerVertex> vertices;
  std::vector<Shape> shapes;  ///< blocker i is shape i
  std::vector<Shape> receivers;
  BoxHierarchy shape_boxes;
  BoxHierarchy receiver_boxes;

  /// Side of the light's plane; +1 for lights without.
  int light_side(PointId point) const;

  /// Whether a blocker is what a receiver is a facet of, up to rounding.
  static bool is_own(const Shape& receiver, ShapeId blocker);

 private:
  class Builder;
};

}  // namespace gnomon::event
