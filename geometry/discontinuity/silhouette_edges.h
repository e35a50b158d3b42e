#pragma once

/// Edges that may bound what is seen of the light. Private to this folder.

#include <array>
#include <span>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/numbers/exact_vector.h"

namespace gnomon::event {

/// A vector, somewhere in a box.
using NearVector = PointEnclosure;

/// A point, exactly and nearby. Requires: the rounding mode is protected.
struct Place {
  ExactVector exact;
  PointEnclosure near{Interval(0), Interval(0), Interval(0)};

  Place() = default;
  explicit Place(ExactVector p);
};

/// A plane's normal and offset: positive in front.
struct NearPlane {
  NearVector normal{Interval(0), Interval(0), Interval(0)};
  Interval offset = 0;
};

NearPlane near_plane(const NearVector& a, const NearVector& b, const NearVector& c);

/// The line through two points: its direction and its moment about the origin, which are Pluecker's coordinates.
struct NearLine {
  NearVector direction{Interval(0), Interval(0), Interval(0)};
  NearVector moment{Interval(0), Interval(0), Interval(0)};
};

NearLine near_line(const NearVector& a, const NearVector& b);

/// An edge that may bound what is seen.
struct SilhouetteEdge {
  Place a;
  Place b;
  EventElement name;
  std::array<PointId, 2> ends{};  ///< a and b in the scene
  bool is_of_light = false;       ///< an edge of the light's own outline
  std::vector<ShapeId> shapes;    ///< whose edge it is
  std::vector<Place> hidden;      ///< a point of each face at the edge; of an area light a point beyond its edge
  NearLine line;
  std::vector<NearPlane> planes;  ///< through the edge and each of the points in `hidden`
};

/// True of two edges of the light, or of one blocker: what they leave open never shrinks to where they cross.
bool belong_together(const SilhouetteEdge& p, const SilhouetteEdge& q);

/// The edges of the light, its own ones first, and those of some shapes.
std::vector<SilhouetteEdge> silhouette_edges(const EventScene& scene, std::span<const ShapeId> shapes);

/// Edges, and their ends numbered, each point once.
struct NumberedSilhouettes {
  explicit NumberedSilhouettes(std::vector<SilhouetteEdge> all);

  std::vector<SilhouetteEdge> edges;
  std::vector<PointId> points;                     ///< all ends, ascending
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< of each edge, as places in `points`
};

}  // namespace gnomon::event
