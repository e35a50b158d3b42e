#include "geometry/discontinuity/light_cuts.h"

#include <algorithm>

#include "geometry/discontinuity/receiver_plane.h"

namespace gnomon::event {
namespace {

class LightCuts {
 public:
  explicit LightCuts(const EventScene& scene) : scene_(scene) {}

  std::vector<LightCut> of_area_light() {
    const auto& l = scene_.light_plane;
    const ReceiverPlane plane(scene_.points[l[0]].input, scene_.points[l[1]].input, scene_.points[l[2]].input);
    std::vector<FlatPoint> silhouette;
    for (const LightVertex& v : scene_.light_vertices) silhouette.push_back(plane.flat(at(v.point)));
    for (const Shape& shape : scene_.shapes) {
      if (!shape.is_solid) add_segment(shape.corners, plane, silhouette);
      for (const auto& loop : shape.facets) add_segment(loop, plane, silhouette);
    }
    return std::move(cuts_);
  }

  std::vector<ExactVector> touches_of_area_light() {
    const auto& l = scene_.light_plane;
    const ReceiverPlane plane(scene_.points[l[0]].input, scene_.points[l[1]].input, scene_.points[l[2]].input);
    std::vector<FlatPoint> silhouette;
    for (const LightVertex& v : scene_.light_vertices) silhouette.push_back(plane.flat(at(v.point)));
    std::vector<ExactVector> touches;
    const auto add = [&](const std::vector<PointId>& loop) {
      for (const FlatPoint& p : ends_in_light_plane(loop, plane)) {
        if (is_in(p, silhouette)) touches.push_back(plane.spatial(p));
      }
    };
    for (const Shape& shape : scene_.shapes) {
      if (!shape.is_solid) add(shape.corners);
      for (const auto& loop : shape.facets) add(loop);
    }
    return touches;
  }

  std::vector<LightCut> of_linear_light() {
    const ExactVector a = at(scene_.light_edges[0].a), b = at(scene_.light_edges[0].b);
    for (const Shape& shape : scene_.shapes) {
      if (!shape.is_solid) add_point(shape.corners, a, b);
      for (const auto& loop : shape.facets) add_point(loop, a, b);
    }
    return std::move(cuts_);
  }

 private:
  ExactVector at(PointId id) const { return exact(scene_.points[id].input); }

  static bool is_in(const FlatPoint& p, const std::vector<FlatPoint>& silhouette) {
    Sides sides;
    for (std::size_t k = 0; k < silhouette.size(); ++k) {
      const FlatPoint &a = silhouette[k], &b = silhouette[(k + 1) % silhouette.size()];
      sides.add(Rational((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)).sign());
    }
    return !sides.cross();
  }

  /// Of a loop's polygon, the ends of what lies in the light's plane; nothing if all does.
  std::vector<FlatPoint> ends_in_light_plane(const std::vector<PointId>& loop, const ReceiverPlane& plane) const {
    const std::size_t n = loop.size();
    std::vector<int> sides(n);
    for (std::size_t k = 0; k < n; ++k) sides[k] = scene_.light_side(loop[k]);
    if (std::all_of(sides.begin(), sides.end(), [](int s) { return s == 0; })) return {};
    std::vector<FlatPoint> ends;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      if (sides[k] == 0) ends.push_back(plane.flat(at(loop[k])));
      if (sides[k] * sides[next] >= 0) continue;
      const ExactVector p = at(loop[k]), q = at(loop[next]);
      const Rational at_p = plane.plane().height(p), at_q = plane.plane().height(q);
      ends.push_back(plane.flat(p + Rational(at_p / (at_p - at_q)) * (q - p)));
    }
    return ends;
  }

  /// The part of a loop's polygon in the light's plane, inside the light.
  void add_segment(const std::vector<PointId>& loop, const ReceiverPlane& plane,
                   const std::vector<FlatPoint>& silhouette) {
    const std::vector<FlatPoint> ends = ends_in_light_plane(loop, plane);
    if (ends.size() != 2) return;
    FlatSegment segment{ends[0], ends[1], 0};
    if (!clip(segment, silhouette)) return;
    cuts_.push_back({{constructed_point(plane.spatial(segment.start)), constructed_point(plane.spatial(segment.end))}});
  }

  /// The point in which the segment from a to b passes through a loop's polygon.
  void add_point(const std::vector<PointId>& loop, const ExactVector& a, const ExactVector& b) {
    const ReceiverPlane plane(scene_.points[loop[0]].input, scene_.points[loop[1]].input, scene_.points[loop[2]].input);
    const Rational at_a = plane.plane().height(a), at_b = plane.plane().height(b);
    if (at_a.sign() * at_b.sign() >= 0) return;
    const ExactVector p = a + Rational(at_a / (at_a - at_b)) * (b - a);
    const FlatPoint q = plane.flat(p);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const FlatPoint c = plane.flat(at(loop[k])), d = plane.flat(at(loop[(k + 1) % loop.size()]));
      if ((d.x - c.x) * (q.y - c.y) - (d.y - c.y) * (q.x - c.x) < 0) return;
    }
    cuts_.push_back({{constructed_point(p), constructed_point(p)}});
  }

  const EventScene& scene_;
  std::vector<LightCut> cuts_;
};

}  // namespace

std::vector<LightCut> light_cuts(const EventScene& scene) {
  LightCuts cuts(scene);
  if (scene.kind == LightKind::area) return cuts.of_area_light();
  if (scene.kind == LightKind::linear) return cuts.of_linear_light();
  return {};
}

std::vector<EventPoint> light_touches(const EventScene& scene, const std::vector<LightCut>& cuts) {
  if (scene.kind != LightKind::area) return {};
  std::vector<ExactVector> touches = LightCuts(scene).touches_of_area_light();
  std::vector<ExactVector> known;
  for (const LightVertex& v : scene.light_vertices) known.push_back(exact_place(scene.points[v.point]));
  for (const LightCut& cut : cuts) {
    for (const EventPoint& end : cut.ends) known.push_back(exact_place(end));
  }
  std::sort(touches.begin(), touches.end());
  touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
  std::erase_if(touches, [&](const ExactVector& p) { return std::find(known.begin(), known.end(), p) != known.end(); });
  std::vector<EventPoint> points;
  for (const ExactVector& p : touches) points.push_back(constructed_point(p));
  return points;
}

std::optional<LightCut> plane_cut(const EventScene& scene, const std::vector<PointId>& loop) {
  const std::size_t n = scene.light_vertices.size();
  std::vector<int> sides;
  for (const LightVertex& v : scene.light_vertices) {
    sides.push_back(
        orientation(scene.points[loop[0]], scene.points[loop[1]], scene.points[loop[2]], scene.points[v.point]));
  }
  if (*std::min_element(sides.begin(), sides.end()) >= 0 || *std::max_element(sides.begin(), sides.end()) <= 0)
    return {};
  const auto at = [&](PointId id) { return exact(scene.points[id].input); };
  const ExactPlane plane = plane_through(at(loop[0]), at(loop[1]), at(loop[2]));
  std::vector<ExactVector> ends;
  for (std::size_t k = 0; k < n; ++k) {
    const ExactVector p = at(scene.light_vertices[k].point), q = at(scene.light_vertices[(k + 1) % n].point);
    if (sides[k] == 0) ends.push_back(p);
    if (sides[k] * sides[(k + 1) % n] >= 0 || (n == 2 && k == 1)) continue;
    const Rational at_p = plane.height(p), at_q = plane.height(q);
    ends.push_back(p + Rational(at_p / (at_p - at_q)) * (q - p));
  }
  return LightCut{{constructed_point(ends.front()), constructed_point(ends.back())}};
}

}  // namespace gnomon::event
