#include "geometry/discontinuity/event_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/bodies/own_blockers.h"
#include "geometry/bodies/polygon_checks.h"
#include "geometry/discontinuity/light_cuts.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "gnomon/errors.h"

namespace gnomon::event {
namespace {

struct PointOrder {
  bool operator()(const Point3& a, const Point3& b) const { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }
};

/// The box of a point: of a constructed one with all that may be rounded to its coordinates.
Box3 box_around(const EventPoint& point) {
  const Point3& p = point.input;
  if (point.kind == EventPoint::Kind::input) return {p, p};
  const auto moved = [&](double to) {
    return Point3{std::nextafter(p.x, to), std::nextafter(p.y, to), std::nextafter(p.z, to)};
  };
  return {moved(-std::numeric_limits<double>::infinity()), moved(std::numeric_limits<double>::infinity())};
}

Box3 box_around(const Shape& shape, std::span<const EventPoint> points) {
  Box3 box = box_around(points[shape.corners[0]]);
  for (const PointId id : shape.corners) {
    const auto [low, high] = box_around(points[id]);
    box.min = {std::min(box.min.x, low.x), std::min(box.min.y, low.y), std::min(box.min.z, low.z)};
    box.max = {std::max(box.max.x, high.x), std::max(box.max.y, high.y), std::max(box.max.z, high.z)};
  }
  return box;
}

}  // namespace

class EventScene::Builder {
 public:
  explicit Builder(EventScene& scene) : scene_(scene) {}

  void add(const Light& light) {
    std::visit([this](const auto& l) { add_light(l); }, light);
  }

  void add(const ConvexBlocker& blocker) {
    const auto shape = static_cast<ShapeId>(scene_.shapes.size());
    if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
      add_polygon(*polygon, shape);
    } else {
      add_solid(std::get<ConvexSolid>(blocker), shape);
    }
    Shape& made = scene_.shapes.back();
    judge_against_light(made);
    boxes_.push_back(box_around(made, scene_.points));
  }

  void add_receiver(const ConvexPolygon& polygon) {
    Shape shape = polygon.is_flat() ? flat_receiver(polygon) : rounded_receiver(polygon);
    for (std::size_t k = 0; k < shape.corners.size(); ++k) {
      shape.edges.push_back({shape.corners[k], shape.corners[(k + 1) % shape.corners.size()], 0});
    }
    receiver_boxes_.push_back(box_around(shape, scene_.points));
    scene_.receivers.push_back(std::move(shape));
  }

  void finish() {
    for (BlockerEdge& edge : scene_.edges) {
      edge.may_be_seen = may_be_seen(edge);
      if (!edge.may_be_seen) continue;
      scene_.vertices[vertex_of_.at(edge.a)].may_be_seen = true;
      scene_.vertices[vertex_of_.at(edge.b)].may_be_seen = true;
    }
    for (EdgeId e = 0; e < scene_.edges.size(); ++e) {
      scene_.vertices[vertex_of_.at(scene_.edges[e].a)].edges.push_back(e);
      scene_.vertices[vertex_of_.at(scene_.edges[e].b)].edges.push_back(e);
    }
    add_cuts();
    add_cutting_facets();
    scene_.shape_boxes = BoxHierarchy(boxes_);
    scene_.receiver_boxes = BoxHierarchy(receiver_boxes_);
  }

 private:
  PointId point(const Point3& p) {
    // Zero has two signs in doubles, and one place in space.
    const Point3 q{p.x + 0.0, p.y + 0.0, p.z + 0.0};
    const auto [found, is_new] = ids_.try_emplace(q, static_cast<PointId>(scene_.points.size()));
    if (is_new) scene_.points.push_back({EventPoint::Kind::input, q, {}});
    return found->second;
  }

  Shape flat_receiver(const ConvexPolygon& polygon) {
    Shape shape;
    for (const std::uint32_t k : polygon.corners()) shape.corners.push_back(point(polygon.points()[k]));
    std::copy_n(shape.corners.begin(), 3, shape.plane.begin());
    return shape;
  }

  /// Its corners are moved into its plane along the axis along which it is seen to be convex.
  Shape rounded_receiver(const ConvexPolygon& polygon) {
    const PolygonPlane span = *polygon_plane(polygon.points());
    Shape shape;
    std::array<ExactVector, 3> places;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = polygon.points()[span.vertices[k]];
      shape.plane[k] = point(p);
      places[k] = exact(p);
    }
    const ExactPlane plane = plane_through(places[0], places[1], places[2]);
    const ExactVector axis{span.dropped_axis == 0, span.dropped_axis == 1, span.dropped_axis == 2};
    for (const std::uint32_t k : polygon.corners()) {
      const ExactVector corner = exact(polygon.points()[k]);
      const Rational height = plane.height(corner);
      if (height == 0) {
        shape.corners.push_back(point(polygon.points()[k]));
        continue;
      }
      shape.corners.push_back(static_cast<PointId>(scene_.points.size()));
      scene_.points.push_back(constructed_point(corner - Rational(height / plane.slope(axis)) * axis));
    }
    return shape;
  }

  void add_light_vertex(PointId id, std::uint32_t index) {
    scene_.light_vertices.push_back({id, {EventOf::light, {}, EventIndex{index}}});
  }

  void add_light(const PointLight& light) {
    scene_.kind = LightKind::point;
    add_light_vertex(point(light.position), 0);
  }

  void add_light(const DirectionalLight& light) {
    scene_.kind = LightKind::direction;
    const Point3& d = light.direction;
    scene_.points.push_back({EventPoint::Kind::direction, {-d.x, -d.y, -d.z}, {}});
    add_light_vertex(static_cast<PointId>(scene_.points.size() - 1), 0);
  }

  void add_light(const LinearLight& light) {
    scene_.kind = LightKind::linear;
    const PointId a = point(light.start), b = point(light.end);
    add_light_vertex(a, 0);
    add_light_vertex(b, 1);
    scene_.light_edges.push_back({a, b, {EventOf::light}});
  }

  void add_light(const AreaLight& light) {
    const ConvexPolygon& polygon = light.polygon;
    if (!polygon.is_flat()) throw PreconditionError("an area light's vertices must be exactly coplanar");
    scene_.kind = LightKind::area;
    scene_.is_two_sided = light.two_sided;
    std::vector<PointId> corners;
    for (const std::uint32_t k : polygon.corners()) {
      corners.push_back(point(polygon.points()[k]));
      add_light_vertex(corners.back(), k);
    }
    for (std::uint32_t k = 0; k < corners.size(); ++k) {
      scene_.light_edges.push_back(
          {corners[k], corners[(k + 1) % corners.size()], {EventOf::light, {}, EventIndex{polygon.side_edge(k)}}});
    }
    scene_.light_plane = {corners[0], corners[1], corners[2]};
  }

  /// The ends and edges of where blockers meet the light are numbered after the light's own.
  void add_cuts() {
    std::uint32_t index = 0;
    for (const LightVertex& v : scene_.light_vertices) index = std::max(index, number(v.name.index) + 1);
    const auto add_vertex = [&](const EventPoint& p) {
      scene_.points.push_back(p);
      const auto id = static_cast<PointId>(scene_.points.size() - 1);
      scene_.cut_vertices.push_back({id, {EventOf::light, {}, EventIndex{index}}});
      return id;
    };
    const std::vector<LightCut> cuts = light_cuts(scene_);
    for (const LightCut& cut : cuts) {
      const PointId a = add_vertex(cut.ends[0]);
      if (scene_.kind == LightKind::area) {
        ++index;
        scene_.cut_edges.push_back({a, add_vertex(cut.ends[1]), {EventOf::light, {}, EventIndex{index - 1}}});
      }
      ++index;
    }
    for (const EventPoint& touch : light_touches(scene_, cuts)) {
      add_vertex(touch);
      ++index;
    }
  }

  void add_cutting_facets() {
    if (scene_.kind != LightKind::area && scene_.kind != LightKind::linear) return;
    for (ShapeId s = 0; s < scene_.shapes.size(); ++s) {
      const Shape& shape = scene_.shapes[s];
      if (!shape.is_solid) add_cutting_facet(shape.corners, {EventOf::blocker, EventBody{s}});
      for (std::uint32_t f = 0; f < shape.facets.size(); ++f) {
        add_cutting_facet(shape.facets[f], {EventOf::blocker, EventBody{s}, EventIndex{f}});
      }
    }
  }

  void add_cutting_facet(const std::vector<PointId>& loop, const EventElement& name) {
    const std::optional<LightCut> cut = plane_cut(scene_, loop);
    if (!cut) return;
    CuttingFacet facet{name, loop, {}, {}};
    for (std::size_t k = 0; k < loop.size(); ++k) {
      facet.edges.push_back(edge_of_.at(std::minmax(loop[k], loop[(k + 1) % loop.size()])));
    }
    for (std::size_t k = 0; k < 2; ++k) {
      facet.light_ends[k] = static_cast<PointId>(scene_.points.size());
      if (k == 1 && scene_.kind == LightKind::linear) facet.light_ends[k] = facet.light_ends[0];
      if (k == 0 || scene_.kind == LightKind::area) scene_.points.push_back(cut->ends[k]);
    }
    scene_.cutting_facets.push_back(std::move(facet));
  }

  void add_vertex(PointId id, const EventElement& name, ShapeId shape) {
    const auto [found, is_new] = vertex_of_.try_emplace(id, static_cast<std::uint32_t>(scene_.vertices.size()));
    if (is_new) scene_.vertices.push_back({id, name, {}, {}, false});
    scene_.vertices[found->second].shapes.push_back(shape);
  }

  EdgeId edge(PointId a, PointId b, const EventElement& name) {
    const auto [found, is_new] = edge_of_.try_emplace(std::minmax(a, b), static_cast<EdgeId>(scene_.edges.size()));
    if (is_new) scene_.edges.push_back({a, b, name, {}, true});
    return found->second;
  }

  void add_polygon(const ConvexPolygon& polygon, ShapeId id) {
    Shape shape;
    for (const std::uint32_t k : polygon.corners()) {
      shape.corners.push_back(point(polygon.points()[k]));
      add_vertex(shape.corners.back(), {EventOf::blocker, EventBody{id}, EventIndex{k}}, id);
    }
    const auto n = static_cast<std::uint32_t>(shape.corners.size());
    for (std::uint32_t k = 0; k < n; ++k) {
      const PointId a = shape.corners[k], b = shape.corners[(k + 1) % n];
      const EdgeId e = edge(a, b, {EventOf::blocker, EventBody{id}, EventIndex{polygon.side_edge(k)}});
      scene_.edges[e].faces.push_back({id, shape.corners[(k + 2) % n]});
      shape.edges.push_back({a, b, e});
    }
    scene_.shapes.push_back(std::move(shape));
  }

  void add_solid(const ConvexSolid& solid, ShapeId id) {
    Shape shape;
    shape.is_solid = true;
    std::vector<PointId> of(solid.points().size());
    for (const std::uint32_t k : solid.corners()) {
      of[k] = point(solid.points()[k]);
      shape.corners.push_back(of[k]);
      add_vertex(of[k], {EventOf::blocker, EventBody{id}, EventIndex{k}}, id);
    }
    for (const ConvexSolid::Facet& facet : solid.facets()) {
      shape.facets.emplace_back();
      for (const std::uint32_t k : facet.loop) shape.facets.back().push_back(of[k]);
    }
    for (std::uint32_t k = 0; k < solid.edges().size(); ++k) {
      const ConvexSolid::Edge& e = solid.edges()[k];
      const PointId a = of[e.from], b = of[e.to];
      const EdgeId made = edge(a, b, {EventOf::blocker, EventBody{id}, EventIndex{k}});
      for (const std::uint32_t facet : {e.left, e.right}) {
        const auto& loop = shape.facets[facet];
        const auto third = std::find_if(loop.begin(), loop.end(), [&](PointId p) { return p != a && p != b; });
        scene_.edges[made].faces.push_back({id, *third});
      }
      shape.edges.push_back({a, b, made});
    }
    scene_.shapes.push_back(std::move(shape));
  }

  void judge_against_light(Shape& shape) const {
    shape.is_in_front = false;
    for (const PointId p : shape.corners) {
      const int side = scene_.light_side(p);
      shape.is_in_front = shape.is_in_front || side > 0;
      shape.is_behind = shape.is_behind || side < 0;
    }
  }

  /// An edge is no part of an outline if it has one face on either side of each plane through it and the light.
  bool may_be_seen(const BlockerEdge& edge) const {
    bool on_left = false, on_right = false, in_front = false;
    for (const FaceAtEdge& face : edge.faces) {
      const Shape& shape = scene_.shapes[face.shape];
      in_front = in_front || shape.is_in_front || (scene_.is_two_sided && shape.is_behind);
      bool left = true, right = true;
      for (const LightVertex& v : scene_.light_vertices) {
        const int side = orientation(scene_.points[v.point], scene_.points[edge.a], scene_.points[edge.b],
                                     scene_.points[face.third]);
        left = left && side > 0;
        right = right && side < 0;
      }
      on_left = on_left || left;
      on_right = on_right || right;
    }
    return in_front && !(on_left && on_right);
  }

  EventScene& scene_;
  std::map<Point3, PointId, PointOrder> ids_;
  std::map<PointId, std::uint32_t> vertex_of_;
  std::map<std::pair<PointId, PointId>, EdgeId> edge_of_;
  std::vector<Box3> boxes_;
  std::vector<Box3> receiver_boxes_;
};

EventScene::EventScene(const Light& light, std::span<const ConvexBlocker> blockers,
                       std::span<const ConvexPolygon> receiver_polygons) {
  Builder builder(*this);
  builder.add(light);
  for (const ConvexBlocker& blocker : blockers) builder.add(blocker);
  const OwnBlockers own(blockers);
  for (const ConvexPolygon& receiver : receiver_polygons) {
    builder.add_receiver(receiver);
    receivers.back().own = own.of(receiver);
  }
  builder.finish();
}

bool EventScene::is_own(const Shape& receiver, ShapeId blocker) {
  return std::binary_search(receiver.own.begin(), receiver.own.end(), blocker);
}

int EventScene::light_side(PointId point) const {
  if (kind != LightKind::area) return 1;
  const auto& [a, b, c] = light_plane;
  if (point == a || point == b || point == c) return 0;
  return orientation(points[a], points[b], points[c], points[point]);
}

}  // namespace gnomon::event
