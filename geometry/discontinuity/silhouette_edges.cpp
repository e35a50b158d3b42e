#include "geometry/discontinuity/silhouette_edges.h"

#include <algorithm>
#include <utility>

namespace gnomon::event {

Place::Place(ExactVector p) : exact(std::move(p)) {
  const Rational* c[] = {&exact.x, &exact.y, &exact.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = CGAL::to_interval(*c[k]);
    near[k] = Interval(low, high);
  }
}

NearPlane near_plane(const NearVector& a, const NearVector& b, const NearVector& c) {
  const NearVector normal = cross(b - a, c - a);
  return {normal, -dot(normal, a)};
}

NearLine near_line(const NearVector& a, const NearVector& b) {
  return {b - a, cross(a, b)};
}

bool belong_together(const SilhouetteEdge& p, const SilhouetteEdge& q) {
  if (p.is_of_light && q.is_of_light) return true;
  return std::any_of(p.shapes.begin(), p.shapes.end(),
                     [&](ShapeId s) { return std::find(q.shapes.begin(), q.shapes.end(), s) != q.shapes.end(); });
}

std::vector<SilhouetteEdge> silhouette_edges(const EventScene& scene, std::span<const ShapeId> shapes) {
  const auto place = [&](PointId id) {
    const EventPoint& p = scene.points[id];
    return Place(exact_place(p));
  };
  std::vector<SilhouetteEdge> found;
  const std::size_t n = scene.light_edges.size();
  for (std::size_t k = 0; k < n; ++k) {
    const LightEdge& e = scene.light_edges[k];
    SilhouetteEdge line{place(e.a), place(e.b), e.name, {e.a, e.b}, true, {}, {}, {}, {}};
    if (n > 2) {
      // What lies beyond the edge counts as hidden: the mirror image of what lies inside.
      const ExactVector inside = place(scene.light_edges[(k + 1) % n].b).exact;
      line.hidden.emplace_back(line.a.exact + line.b.exact - inside);
    }
    found.push_back(std::move(line));
  }
  for (const LightEdge& e : scene.cut_edges) {
    found.push_back({place(e.a), place(e.b), e.name, {e.a, e.b}, false, {}, {}, {}, {}});
  }
  std::vector<EdgeId> ids;
  for (const ShapeId s : shapes) {
    for (const ShapeEdge& e : scene.shapes[s].edges) {
      if (scene.edges[e.edge].may_be_seen) ids.push_back(e.edge);
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (const EdgeId id : ids) {
    const BlockerEdge& edge = scene.edges[id];
    SilhouetteEdge line{place(edge.a), place(edge.b), edge.name, {edge.a, edge.b}, false, {}, {}, {}, {}};
    for (const FaceAtEdge& f : edge.faces) {
      line.shapes.push_back(f.shape);
      line.hidden.push_back(place(f.third));
    }
    found.push_back(std::move(line));
  }
  for (SilhouetteEdge& o : found) {
    o.line = near_line(o.a.near, o.b.near);
    for (const Place& face : o.hidden) o.planes.push_back(near_plane(o.a.near, o.b.near, face.near));
  }
  return found;
}

NumberedSilhouettes::NumberedSilhouettes(std::vector<SilhouetteEdge> all) : edges(std::move(all)) {
  for (const SilhouetteEdge& e : edges) points.insert(points.end(), e.ends.begin(), e.ends.end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto number = [&](PointId p) {
    return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
  };
  for (const SilhouetteEdge& e : edges) ends.push_back({number(e.ends[0]), number(e.ends[1])});
}

}  // namespace gnomon::event
