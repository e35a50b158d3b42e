#pragma once

/// Blockers' vertices on the outline of what a point sees of the light, by intervals. Private to this folder.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/discontinuity/silhouette_edges.h"

namespace gnomon::event {

/// Shapes as they look from a point, turned about whatever vertex is asked for.
///
/// Requires:  the rounding mode is protected while any member runs.
/// Exactness: intervals; what they do not tell is answered with no.
class SilhouetteVertices {
 public:
  explicit SilhouetteVertices(const EventScene& scene) : scene_(scene) {}

  /// Looks from a point at shapes of which some point lies strictly before the receiver's plane; among them have to be
  /// all such that have a vertex that is asked for.
  void view(const PointEnclosure& from, std::span<const ShapeId> shapes);

  /// The vertices of the shapes, ascending, each once.
  std::span<const PointId> vertices() const { return vertices_; }

  /// Side of the plane through the point, a and b on which c lies; 0 if intervals do not tell.
  int side(PointId a, PointId b, PointId c) const;

  /// True if the vertex is certainly on the outline of what the shapes hide: next to it, as seen from the point, some
  /// directions are hidden and some are open. The rule, and why it holds, are in docs/receivers.md.
  bool is_on_silhouette(PointId vertex) const;

 private:
  /// An edge with all of its shape on one side, as seen from the point.
  struct Edge {
    PointId a = 0;
    PointId b = 0;
    NearVector normal;  ///< of the plane through the point, a and b
    int inside = 0;     ///< the side on which the shape lies
  };
  struct View {
    const Shape* shape = nullptr;
    std::uint32_t first = 0;  ///< of its edges
    std::uint32_t count = 0;  ///< none if it is not known which edges bound it
  };
  /// What a shape hides around one of its vertices: the directions from one ray counterclockwise to another, less than
  /// half a turn. Rays run from the vertex to a point, and are known by the normals of their planes.
  struct Arc {
    PointId start = 0;
    PointId end = 0;
    NearVector start_normal;
    NearVector end_normal;
  };

  NearVector to(PointId point) const;
  void view_shape(const Shape& shape);
  bool append_triangle(const Shape& shape);
  std::span<const Edge> edges(const View& view) const { return std::span(edges_).subspan(view.first, view.count); }
  bool leaves_open(const View& view, const NearVector& to_vertex) const;
  bool append_arc(const View& view, PointId vertex, std::vector<Arc>& arcs) const;
  bool ends_open(const Arc& arc, std::span<const Arc> arcs) const;

  const EventScene& scene_;
  PointEnclosure from_{Interval(0), Interval(0), Interval(0)};
  std::vector<View> views_;
  std::vector<Edge> edges_;
  std::vector<PointId> vertices_;
};

}  // namespace gnomon::event
