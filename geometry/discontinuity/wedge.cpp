#include "geometry/discontinuity/wedge.h"

#include <algorithm>

#include "geometry/discontinuity/coplanar_pairs.h"

namespace gnomon::event {
namespace {

/// Finds the edges that may be in line with a vertex and the light.
class EdgeSearch {
 public:
  explicit EdgeSearch(const EventScene& scene) : scene_(scene) {}

  /// The edges between the vertex and the light, or those beyond the vertex.
  const std::vector<EdgeId>& edges(const BlockerVertex& vertex, int side, WedgeKind kind) {
    const Point3& v = scene_.points[vertex.point].input;
    half_spaces_.clear();
    const std::size_t n = scene_.light_edges.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Point3& c = scene_.points[scene_.light_edges[k].a].input;
      const Point3& d = scene_.points[scene_.light_edges[k].b].input;
      const Point3& inside = scene_.points[scene_.light_edges[(k + 1) % n].b].input;
      const RoughHalfSpace h = turned_to(rough_half_space(v, step(v, c), step(v, d)), inside);
      half_spaces_.push_back(kind == WedgeKind::edge_first ? h : reversed(h));
    }
    if (kind == WedgeKind::edge_first) half_spaces_.push_back(before_light(side));
    find_boxes(scene_.shape_boxes, half_spaces_, found_);
    collect(vertex);
    return edges_;
  }

 private:
  RoughHalfSpace before_light(int side) const {
    const Point3 &p = scene_.points[scene_.light_plane[0]].input, &q = scene_.points[scene_.light_plane[1]].input,
                 &r = scene_.points[scene_.light_plane[2]].input;
    const RoughHalfSpace h = rough_half_space(p, step(p, q), step(p, r));
    return side > 0 ? h : reversed(h);
  }

  bool may_meet(const BlockerEdge& edge) const {
    const Point3 &a = scene_.points[edge.a].input, &b = scene_.points[edge.b].input;
    return std::none_of(half_spaces_.begin(), half_spaces_.end(),
                        [&](const RoughHalfSpace& h) { return is_outside(h, a) && is_outside(h, b); });
  }

  void collect(const BlockerVertex& vertex) {
    edges_.clear();
    for (const std::uint32_t s : found_) {
      // A vertex and an edge of one convex set are in line only in a plane that is an event of its own.
      if (std::find(vertex.shapes.begin(), vertex.shapes.end(), s) != vertex.shapes.end()) continue;
      for (const ShapeEdge& e : scene_.shapes[s].edges) {
        const BlockerEdge& edge = scene_.edges[e.edge];
        if (edge.may_be_seen && may_meet(edge) && !shares_shape(vertex, edge)) edges_.push_back(e.edge);
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  static bool shares_shape(const BlockerVertex& vertex, const BlockerEdge& edge) {
    return std::any_of(edge.faces.begin(), edge.faces.end(), [&](const FaceAtEdge& face) {
      return std::find(vertex.shapes.begin(), vertex.shapes.end(), face.shape) != vertex.shapes.end();
    });
  }

  const EventScene& scene_;
  std::vector<RoughHalfSpace> half_spaces_;
  std::vector<std::uint32_t> found_;
  std::vector<EdgeId> edges_;
};

bool is_served(const EventScene& scene, int side) {
  return side > 0 || (side < 0 && scene.is_two_sided);
}

void wedges_from_light_vertices(const EventScene& scene, EdgeId e, const std::function<void(const Wedge&)>& take) {
  const BlockerEdge& edge = scene.edges[e];
  if (!edge.may_be_seen) return;
  if (!is_served(scene, scene.light_side(edge.a)) && !is_served(scene, scene.light_side(edge.b))) return;
  const auto n = static_cast<std::uint32_t>(scene.light_vertices.size());
  for (std::uint32_t l = 0; l < n; ++l) {
    take({WedgeKind::from_light_vertex, scene.light_vertices[l].point, edge.a, edge.b, l, e, {}});
  }
  for (std::uint32_t l = 0; l < scene.cut_vertices.size(); ++l) {
    take({WedgeKind::from_light_vertex, scene.cut_vertices[l].point, edge.a, edge.b, n + l, e, {}});
  }
}

void wedges_at_vertex(const EventScene& scene, std::uint32_t v, const std::function<void(const Wedge&)>& take) {
  const BlockerVertex& vertex = scene.vertices[v];
  const int side = scene.light_side(vertex.point);
  if (!vertex.may_be_seen || !is_served(scene, side)) return;
  const auto n = static_cast<std::uint32_t>(scene.light_edges.size());
  for (std::uint32_t e = 0; e < n; ++e) {
    const LightEdge& edge = scene.light_edges[e];
    take({WedgeKind::from_light_edge, vertex.point, edge.a, edge.b, v, e, {}});
  }
  for (std::uint32_t e = 0; e < scene.cut_edges.size(); ++e) {
    const LightEdge& edge = scene.cut_edges[e];
    take({WedgeKind::from_light_edge, vertex.point, edge.a, edge.b, v, n + e, {}});
  }
  if (scene.kind != LightKind::area) return;
  EdgeSearch search(scene);
  for (const WedgeKind kind : {WedgeKind::edge_first, WedgeKind::apex_first}) {
    for (const EdgeId e : search.edges(vertex, side, kind)) {
      const BlockerEdge& edge = scene.edges[e];
      take({kind, vertex.point, edge.a, edge.b, v, e, {}});
    }
  }
}

/// In the plane of a facet that cuts the light a point sees part of the facet in front of part of the light exactly
/// where it sees an end of one in line with the other.
void wedges_in_facet_plane(const EventScene& scene, std::uint32_t f, const std::function<void(const Wedge&)>& take) {
  const CuttingFacet& facet = scene.cutting_facets[f];
  const auto [p, q] = facet.light_ends;
  for (const EdgeId e : facet.edges) {
    const BlockerEdge& edge = scene.edges[e];
    take({WedgeKind::from_light_vertex, p, edge.a, edge.b, 0, e, f});
    if (p != q) take({WedgeKind::from_light_vertex, q, edge.a, edge.b, 0, e, f});
  }
  for (const PointId v : facet.loop) {
    if (p != q && is_served(scene, scene.light_side(v))) take({WedgeKind::from_light_edge, v, p, q, 0, 0, f});
  }
}

/// Side of the wedge's plane.
int side_of(const EventScene& scene, const Wedge& wedge, PointId p) {
  if (p == wedge.apex || p == wedge.a || p == wedge.b) return 0;
  return orientation(scene.points[wedge.apex], scene.points[wedge.a], scene.points[wedge.b], scene.points[p]);
}

Extremal extremal(const EventScene& scene, const Wedge& wedge, const Shape& shape) {
  const auto side = [&](PointId p) { return side_of(scene, wedge, p); };
  const Sides light = sides(scene.light_vertices, [&](const LightVertex& v) { return side(v.point); });
  const Sides blocker = sides(shape.corners, side);
  if (light.cross() || blocker.cross()) return Extremal::none;
  const bool same = (light.positive && blocker.positive) || (light.negative && blocker.negative);
  if (!same) return Extremal::occlusion;
  return wedge.far || wedge.kind == WedgeKind::from_light_vertex ? Extremal::umbra : Extremal::none;
}

bool is_on_plane(const EventScene& scene, const Wedge& wedge, PointId p) {
  return side_of(scene, wedge, p) == 0;
}

/// True if an edge at the vertex lies in the plane of vertex and edge, or the edge's face does where the plane cuts the
/// light.
bool is_coplanar(const EventScene& scene, const Wedge& wedge) {
  if (wedge.kind == WedgeKind::from_light_vertex) {
    for (const LightEdge& e : scene.light_edges) {
      if (e.a != wedge.apex && e.b != wedge.apex) continue;
      if (is_on_plane(scene, wedge, e.a == wedge.apex ? e.b : e.a)) return true;
    }
    const Sides light =
        sides(scene.light_vertices, [&](const LightVertex& v) { return side_of(scene, wedge, v.point); });
    const auto& faces = scene.edges[wedge.edge].faces;
    return light.cross() && std::any_of(faces.begin(), faces.end(),
                                        [&](const FaceAtEdge& f) { return is_on_plane(scene, wedge, f.third); });
  }
  for (const EdgeId e : scene.vertices[wedge.vertex].edges) {
    const BlockerEdge& edge = scene.edges[e];
    const PointId other = edge.a == wedge.apex ? edge.b : edge.a;
    if (!is_on_plane(scene, wedge, other)) continue;
    // Between two faces on either side the edge is no part of an outline.
    const Sides faces = sides(edge.faces, [&](const FaceAtEdge& f) { return side_of(scene, wedge, f.third); });
    if (!faces.cross()) return true;
  }
  return false;
}

/// The element of that number, own ones first.
template <class Element>
const Element& element(const std::vector<Element>& own, const std::vector<Element>& cuts, std::uint32_t i) {
  return i < own.size() ? own[i] : cuts[i - own.size()];
}

EventName pair_name(const EventScene& scene, const Wedge& wedge) {
  EventName name{EventKind::coplanar_edges, wedge.far->name, scene.edges[wedge.edge].name, 1, Extremal::none};
  if (!wedge.far->is_on_light) return name;
  if (scene.kind == LightKind::linear) name.order = 0;
  for (const FaceAtEdge& face : scene.edges[wedge.edge].faces) {
    if (name.extremal == Extremal::none) name.extremal = extremal(scene, wedge, scene.shapes[face.shape]);
  }
  return name;
}

}  // namespace

std::size_t wedge_source_count(const EventScene& scene) {
  if (scene.kind == LightKind::point || scene.kind == LightKind::direction) return scene.edges.size();
  return scene.edges.size() + scene.cutting_facets.size() + scene.vertices.size() + coplanar_source_count(scene);
}

void for_each_wedge(EventScene& scene, std::size_t source, const std::function<void(const Wedge&)>& take) {
  const auto number = [&] { return static_cast<std::uint32_t>(source); };
  if (source < scene.edges.size()) return wedges_from_light_vertices(scene, number(), take);
  source -= scene.edges.size();
  if (source < scene.cutting_facets.size()) return wedges_in_facet_plane(scene, number(), take);
  source -= scene.cutting_facets.size();
  if (source < scene.vertices.size()) return wedges_at_vertex(scene, number(), take);
  for_each_coplanar_wedge(scene, source - scene.vertices.size(), take);
}

void for_each_wedge(EventScene& scene, const std::function<void(const Wedge&)>& take) {
  const std::size_t n = wedge_source_count(scene);
  for (std::size_t source = 0; source < n; ++source) for_each_wedge(scene, source, take);
}

EventName event_name(const EventScene& scene, const Wedge& wedge) {
  if (wedge.facet) {
    const EventElement& facet = scene.cutting_facets[*wedge.facet].name;
    return {EventKind::coplanar_plane, facet, facet, 1, Extremal::none};
  }
  if (wedge.far) return pair_name(scene, wedge);
  EventName name;
  const bool from_vertex = wedge.kind == WedgeKind::from_light_vertex;
  const bool from_edge = wedge.kind == WedgeKind::from_light_edge;
  name.vertex = from_vertex ? element(scene.light_vertices, scene.cut_vertices, wedge.vertex).name
                            : scene.vertices[wedge.vertex].name;
  name.edge = from_edge ? element(scene.light_edges, scene.cut_edges, wedge.edge).name : scene.edges[wedge.edge].name;
  const int generic = scene.kind == LightKind::area ? 2 : scene.kind == LightKind::linear ? 1 : 0;
  name.order = static_cast<std::uint8_t>(generic > 0 && is_coplanar(scene, wedge) ? generic - 1 : generic);
  // Of several blockers that share the element, one is enough.
  std::vector<ShapeId> shapes;
  if (from_edge) shapes = scene.vertices[wedge.vertex].shapes;
  if (from_vertex) {
    for (const FaceAtEdge& face : scene.edges[wedge.edge].faces) shapes.push_back(face.shape);
  }
  for (const ShapeId shape : shapes) {
    const Extremal found = extremal(scene, wedge, scene.shapes[shape]);
    if (name.extremal == Extremal::none) name.extremal = found;
  }
  return name;
}

}  // namespace gnomon::event
