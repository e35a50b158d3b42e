#include "geometry/discontinuity/silhouette_vertices.h"

#include <algorithm>

namespace gnomon::event {
namespace {

bool has_corner(const Shape& shape, PointId vertex) {
  return std::find(shape.corners.begin(), shape.corners.end(), vertex) != shape.corners.end();
}

/// 0 also where the sign is not known.
int sign_of(const Interval& x) {
  return x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0;
}

NearVector opposite(const NearVector& v) {
  return {-v[0], -v[1], -v[2]};
}

}  // namespace

NearVector SilhouetteVertices::to(PointId point) const {
  const Point3& q = scene_.points[point].input;
  return NearVector{Interval(q.x), Interval(q.y), Interval(q.z)} - from_;
}

int SilhouetteVertices::side(PointId a, PointId b, PointId c) const {
  return sign_of(dot(cross(to(a), to(b)), to(c)));
}

void SilhouetteVertices::view(const PointEnclosure& from, std::span<const ShapeId> shapes) {
  from_ = from;
  views_.clear();
  edges_.clear();
  vertices_.clear();
  for (const ShapeId s : shapes) {
    const Shape& shape = scene_.shapes[s];
    view_shape(shape);
    vertices_.insert(vertices_.end(), shape.corners.begin(), shape.corners.end());
  }
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
}

/// One determinant tells all sides of a triangle.
bool SilhouetteVertices::append_triangle(const Shape& shape) {
  if (shape.is_solid || shape.corners.size() != 3) return false;
  const NearVector way[] = {to(shape.corners[0]), to(shape.corners[1]), to(shape.corners[2])};
  const NearVector first = cross(way[0], way[1]);
  if (const int inside = sign_of(dot(first, way[2])); inside != 0) {
    edges_.push_back({shape.corners[0], shape.corners[1], first, inside});
    edges_.push_back({shape.corners[1], shape.corners[2], cross(way[1], way[2]), inside});
    edges_.push_back({shape.corners[2], shape.corners[0], cross(way[2], way[0]), inside});
  }
  return true;
}

void SilhouetteVertices::view_shape(const Shape& shape) {
  const auto first = static_cast<std::uint32_t>(edges_.size());
  if (!append_triangle(shape)) {
    for (const ShapeEdge& e : shape.edges) {
      const NearVector normal = cross(to(e.a), to(e.b));
      int inside = 0;
      const bool is_one_sided = std::all_of(shape.corners.begin(), shape.corners.end(), [&](PointId q) {
        if (q == e.a || q == e.b) return true;
        const int s = sign_of(dot(normal, to(q)));
        if (s == 0 || s == -inside) return false;
        inside = s;
        return true;
      });
      if (is_one_sided && inside != 0) edges_.push_back({e.a, e.b, normal, inside});
    }
  }
  views_.push_back({&shape, first, static_cast<std::uint32_t>(edges_.size()) - first});
}

/// The line to the vertex passes beside the shape.
bool SilhouetteVertices::leaves_open(const View& view, const NearVector& to_vertex) const {
  const auto parts = [&](const Edge& e) { return sign_of(dot(e.normal, to_vertex)) == -e.inside; };
  const std::span<const Edge> all = edges(view);
  return std::any_of(all.begin(), all.end(), parts);
}

/// Returns: false if it is not known that the shape has two edges at the vertex that bound it.
bool SilhouetteVertices::append_arc(const View& view, PointId vertex, std::vector<Arc>& arcs) const {
  Arc arc;
  bool has_start = false, has_end = false;
  for (const Edge& e : edges(view)) {
    if (e.a != vertex && e.b != vertex) continue;
    const bool leaves = e.a == vertex;
    const bool starts = (e.inside > 0) == leaves;
    (starts ? has_start : has_end) = true;
    (starts ? arc.start : arc.end) = leaves ? e.b : e.a;
    (starts ? arc.start_normal : arc.end_normal) = leaves ? e.normal : opposite(e.normal);
  }
  arcs.push_back(arc);
  return has_start && has_end;
}

/// No arc holds the directions right after the end of one of them.
bool SilhouetteVertices::ends_open(const Arc& arc, std::span<const Arc> arcs) const {
  const NearVector to_end = to(arc.end);
  return std::all_of(arcs.begin(), arcs.end(), [&](const Arc& other) {
    if (other.end == arc.end) return true;
    if (other.start == arc.end) return false;
    return sign_of(dot(other.start_normal, to_end)) < 0 || sign_of(dot(other.end_normal, to_end)) > 0;
  });
}

bool SilhouetteVertices::is_on_silhouette(PointId vertex) const {
  const NearVector to_vertex = to(vertex);
  std::vector<Arc> arcs;
  for (const View& view : views_) {
    if (has_corner(*view.shape, vertex) ? !append_arc(view, vertex, arcs) : !leaves_open(view, to_vertex)) return false;
  }
  return std::any_of(arcs.begin(), arcs.end(), [&](const Arc& arc) { return ends_open(arc, arcs); });
}

}  // namespace gnomon::event
