#pragma once

/// When an event is one: what has to be true of the elements in line, decided from their coordinates.

#include <vector>

#include "apps/proof/laws/event_cases.h"
#include "apps/proof/laws/visibility_along_path.h"
#include "gnomon/discontinuity.h"

namespace gnomon::laws {

/// A case in exact numbers.
struct EventScene {
  explicit EventScene(const EventCase& one);

  const EventCase& drawn;
  std::vector<Walls> blockers;
  ExactVector along;  ///< from the point to the light
  Path path;
  ExactPlane plane;  ///< of the segment and `across`

  /// The light shrunk toward its point on the line of sight by about 2^60: the same vertex or edge of it is met there,
  /// and of its measure only what is next to the line counts. Other events that happen at the same point of the path,
  /// elsewhere before the light, might add up with this one to another order.
  std::vector<ExactVector> near_light;
};

/// True if the closed segment from the point to the light meets the blockers in line, in one point each (a facet or
/// flat shape in a segment), and no other, and the point lies strictly in front of the light. One point of an edge's or
/// a vertex's means that it is part of the outline.
bool is_seen_alone(const EventScene& scene);

/// Premise of two elements, a vertex and an edge: the path crosses their plane, which holds no edge at the vertex, and
/// no two edges at the vertex are seen on one line.
bool is_simple_vertex_edge(const EventScene& scene);

/// Premise of two coplanar edges or a facet: the path crosses their plane, and no edge runs along the line of sight.
bool is_simple_plane(const EventScene& scene);

/// Premise of three edges: no two are seen on one line, and the path crosses the surface of points that see them in
/// one.
bool is_simple_triple(const EventScene& scene);

/// True if that surface has no cubic term along the path.
bool is_quadratic(const EventScene& scene);

/// True if a name is that of the vertex and the edge in line.
bool names_event(const EventName& name, const EventCase& drawn);

/// True if vertex and edge of a name, or its facet, lie in the plane.
bool lies_in_plane(const EventName& name, const EventCase& drawn, const ExactPlane& plane);

/// A box with the point and all shapes strictly inside.
Box3 box_around(const EventCase& drawn);

/// Each coordinate to the nearest double.
Point3 rounded(const ExactVector& p);

/// The points of a shape by which events name it: of a vertex, an edge or a facet.
std::vector<ExactVector> named_points(const EventElement& element, bool is_vertex, bool is_facet, const Light& light,
                                      const std::vector<ConvexBlocker>& blockers);

}  // namespace gnomon::laws
