#include "geometry/discontinuity/coplanar_pairs.h"

#include <algorithm>

#include "geometry/discontinuity/shaft.h"

// Notation. near: a blocker's edge. far: an edge in one plane with it and nearer to the light: one of the light, one of
// another blocker, or what a facet's plane cuts out of the light. plane: theirs, by three of its points. apex: a place
// in the plane, the end of a set of lines of sight. beside: a vertex of the light off the plane; seen from there, turns
// in the plane have signs.
//
// Why the apexes are enough. From a point of the plane, near and far are seen in line with the light along lines of the
// plane, and at an end of such a set of points a line of sight is stopped. It passes an end of near or far: a wedge of
// a vertex and an edge, found elsewhere. Or it passes an end of what the plane has of the light (light_section_), or a
// third blocker that the plane cuts, at a corner in the plane or where it cuts an edge (find_apexes): a blocker that it
// does not cut has no inside in it and stops nothing. So every end lies on a line through such an apex that meets near
// and far, and these lines are what the wedges hold. Where near and far meet, all lines through that place
// do, and it may be the one end, while the other is seen along the receiver's plane. Of two edges the feet have corners
// in line there (horizon_traces). What a facet's plane cuts out of the light has none: a fin between a window and the
// floor. So in that plane such a place is an apex, too (take_meeting).

namespace gnomon::event {
namespace {

/// A plane by three of its points, in general position.
using PlaneIds = std::array<PointId, 3>;

bool share_shape(const BlockerEdge& p, const BlockerEdge& q) {
  return std::any_of(p.faces.begin(), p.faces.end(), [&](const FaceAtEdge& f) {
    return std::any_of(q.faces.begin(), q.faces.end(), [&](const FaceAtEdge& g) { return f.shape == g.shape; });
  });
}

class CoplanarPairs {
 public:
  CoplanarPairs(EventScene& scene, const std::function<void(const Wedge&)>& take) : scene_(scene), take_(take) {}

  void with_light_edges(EdgeId near) {
    for (const auto* list : {&scene_.light_edges, &scene_.cut_edges}) {
      for (const LightEdge& e : *list) take_pair(near, {e.a, e.b, true, e.name});
    }
  }

  void with_blocker_edges(EdgeId near) {
    const BlockerEdge& edge = scene_.edges[near];
    const std::array<Point3, 2> ends{scene_.points[edge.a].input, scene_.points[edge.b].input};
    find_boxes(scene_.shape_boxes, shaft(scene_, ends), found_);
    far_.clear();
    for (const std::uint32_t s : found_) {
      for (const ShapeEdge& e : scene_.shapes[s].edges) {
        if (scene_.edges[e.edge].may_be_seen && !share_shape(edge, scene_.edges[e.edge])) far_.push_back(e.edge);
      }
    }
    keep_once(far_);
    for (const EdgeId e : far_) {
      const BlockerEdge& far = scene_.edges[e];
      take_pair(near, {far.a, far.b, false, far.name}, e);
    }
  }

  void in_plane_of(std::uint32_t f) {
    const CuttingFacet& facet = scene_.cutting_facets[f];
    find_apexes({facet.loop[0], facet.loop[1], facet.loop[2]});
    light_section_.assign(facet.light_ends.begin(), facet.light_ends.end());
    for (const EdgeId e : facet.edges) {
      const FarEdge far{facet.light_ends[0], facet.light_ends[1], true, facet.name};
      take_wedges(e, far, f);
      take_meeting(e, far, f);
    }
    forget_apexes();
  }

 private:
  int side(const PlaneIds& plane, PointId p) const {
    if (std::find(plane.begin(), plane.end(), p) != plane.end()) return 0;
    return orientation(scene_.points[plane[0]], scene_.points[plane[1]], scene_.points[plane[2]], scene_.points[p]);
  }

  template <class Points, class IdOf>
  bool is_cut(const PlaneIds& plane, const Points& points, const IdOf& id_of) const {
    return sides(points, [&](const auto& p) { return side(plane, id_of(p)); }).cross();
  }

  /// Faces on both sides: no part of an outline, as seen in the plane.
  bool is_between_faces(const PlaneIds& plane, EdgeId e) const {
    return is_cut(plane, scene_.edges[e].faces, [](const FaceAtEdge& f) { return f.third; });
  }

  bool cuts_light(const PlaneIds& plane) const {
    return is_cut(plane, scene_.light_vertices, [](const LightVertex& v) { return v.point; });
  }

  bool meets_receivers(const PlaneIds& plane) const {
    return std::any_of(scene_.receivers.begin(), scene_.receivers.end(),
                       [&](const Shape& r) { return is_cut(plane, r.corners, [](PointId p) { return p; }); });
  }

  /// A pair of which one edge lies on the other's line has no plane of its own.
  std::optional<PlaneIds> common_plane(const BlockerEdge& near, const FarEdge& far) const {
    const auto& p = scene_.points;
    const auto is_shared = [&](PointId q) { return q == near.a || q == near.b; };
    const bool share_end = is_shared(far.a) || is_shared(far.b);
    if (!share_end && orientation(p[near.a], p[near.b], p[far.a], p[far.b]) != 0) return {};
    for (const PointId third : {far.a, far.b}) {
      if (is_shared(third)) continue;
      if (Pencil(p, third, near.a, near.b).is_plane()) return PlaneIds{near.a, near.b, third};
    }
    return {};
  }

  void take_pair(EdgeId near, const FarEdge& far, std::optional<EdgeId> far_edge = {}) {
    const std::optional<PlaneIds> plane = common_plane(scene_.edges[near], far);
    if (!plane || is_between_faces(*plane, near)) return;
    if (far_edge && (is_between_faces(*plane, *far_edge) || !cuts_light(*plane))) return;
    if (!meets_receivers(*plane)) return;
    if (far_edge && scene_.kind == LightKind::linear) return take_through_light_point(near, far, *plane);
    find_apexes(*plane);
    light_section_ = {far.a, far.b};
    if (far_edge) find_light_section(*plane);
    take_wedges(near, far, {});
    if (far_edge) take_wedges_from_light(near, far);
    forget_apexes();
  }

  /// The plane of two blockers' edges has one point of a linear light: all lines that matter come from there.
  void take_through_light_point(EdgeId near, const FarEdge& far, const PlaneIds& plane) {
    point_count_ = scene_.points.size();
    find_light_section(plane);
    take_wedges_from_light(near, far);
    forget_apexes();
  }

  /// Where the edge from `p` to `q` passes through the plane, between its sides.
  PointId add_crossing(const PlaneIds& plane, PointId p, PointId q) {
    const auto height = [&](PointId x) {
      return bracket<ExactReal>(scene_.points[plane[0]], scene_.points[plane[1]], scene_.points[plane[2]],
                                scene_.points[x]);
    };
    const ExactReal at_p = height(p), at_q = height(q);
    const bool falls = CGAL::sign(at_p) == CGAL::POSITIVE;
    const ExactReal up = falls ? at_p : -at_p, down = falls ? -at_q : at_q;
    const auto c = coordinates<ExactReal>(scene_.points[p]), d = coordinates<ExactReal>(scene_.points[q]);
    EventPoint point;
    point.kind = EventPoint::Kind::constructed;
    point.exact.emplace();
    for (std::size_t k = 0; k < 4; ++k) (*point.exact)[k] = down * c[k] + up * d[k];
    point.input = rounded(*point.exact);
    scene_.points.push_back(std::move(point));
    return static_cast<PointId>(scene_.points.size() - 1);
  }

  static Point3 rounded(const Quadruple<ExactReal>& p) {
    const auto middle = [&](std::size_t k) {
      const Interval x = enclosure(p[k]) / enclosure(p[3]);
      return x.inf() / 2 + x.sup() / 2;
    };
    return {middle(0), middle(1), middle(2)};
  }

  /// Shapes that the plane may cut.
  void search_along(const PlaneIds& plane) {
    std::vector<RoughHalfSpace> both_sides;
    const auto is_input = [&](PointId p) { return scene_.points[p].kind == EventPoint::Kind::input; };
    if (std::all_of(plane.begin(), plane.end(), is_input)) {
      const Point3 &p = scene_.points[plane[0]].input, &q = scene_.points[plane[1]].input,
                   &r = scene_.points[plane[2]].input;
      both_sides.push_back(rough_half_space(p, step(p, q), step(p, r)));
      both_sides.push_back(reversed(both_sides[0]));
    }
    find_boxes(scene_.shape_boxes, both_sides, found_);
  }

  /// Blockers share corners and edges.
  static void keep_once(std::vector<std::uint32_t>& ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }

  /// The corners in the plane of blockers that it cuts, and where it cuts those of their edges that may be seen.
  void find_apexes(const PlaneIds& plane) {
    point_count_ = scene_.points.size();
    beside_ = point_beside(plane);
    apexes_.clear();
    std::vector<EdgeId> edges;
    search_along(plane);
    for (const std::uint32_t s : found_) {
      const Shape& shape = scene_.shapes[s];
      if (!is_cut(plane, shape.corners, [](PointId p) { return p; })) continue;
      for (const PointId p : shape.corners) {
        if (side(plane, p) == 0) apexes_.push_back(p);
      }
      for (const ShapeEdge& e : shape.edges) edges.push_back(e.edge);
    }
    keep_once(apexes_);
    keep_once(edges);
    for (const EdgeId id : edges) {
      const BlockerEdge& e = scene_.edges[id];
      if (e.may_be_seen && side(plane, e.a) * side(plane, e.b) < 0) apexes_.push_back(add_crossing(plane, e.a, e.b));
    }
    std::erase_if(apexes_, [&](PointId p) {
      const int s = scene_.light_side(p);
      return s == 0 || (s < 0 && !scene_.is_two_sided);
    });
  }

  void forget_apexes() { scene_.points.resize(point_count_); }

  bool is_served(PointId p) const {
    const int s = scene_.light_side(p);
    return s > 0 || (s < 0 && scene_.is_two_sided);
  }

  /// The place as far beyond `middle` as `end` is before it.
  PointId add_beyond(PointId end, PointId middle) {
    const auto c = coordinates<ExactReal>(scene_.points[end]), m = coordinates<ExactReal>(scene_.points[middle]);
    EventPoint point;
    point.kind = EventPoint::Kind::constructed;
    point.exact.emplace();
    for (std::size_t k = 0; k < 3; ++k) (*point.exact)[k] = 2 * m[k] * c[3] - c[k] * m[3];
    (*point.exact)[3] = m[3] * c[3];
    point.input = rounded(*point.exact);
    scene_.points.push_back(std::move(point));
    return static_cast<PointId>(scene_.points.size() - 1);
  }

  /// Where an edge of a facet ends on what the facet's plane cuts out of the light. An end of each runs to the same
  /// side of the lines between the edge and what continues the light beyond the place: from there the edge is seen
  /// before light. Where the facet meets the light elsewhere all such lines pass another of its edges.
  void take_meeting(EdgeId near, const FarEdge& light, std::uint32_t facet) {
    const BlockerEdge& edge = scene_.edges[near];
    for (const auto& [place, n] : {std::pair(edge.a, edge.b), std::pair(edge.b, edge.a)}) {
      if (!lies_on(place, light.a, light.b) || !is_served(n)) continue;
      for (const PointId l : {light.a, light.b}) {
        const std::size_t before = scene_.points.size();
        take_({WedgeKind::from_light_place, place, n, add_beyond(l, place), 0, near, facet, light});
        scene_.points.resize(before);
      }
    }
  }

  /// True of a point of a segment between two points.
  bool lies_on(PointId p, PointId a, PointId b) const {
    if (Pencil(scene_.points, p, a, b).is_plane()) return false;
    const auto x = coordinates<ExactReal>(scene_.points[p]), c = coordinates<ExactReal>(scene_.points[a]),
               d = coordinates<ExactReal>(scene_.points[b]);
    for (std::size_t k = 0; k < 3; ++k) {
      const ExactReal from_a = x[k] * c[3] - x[3] * c[k], from_b = x[k] * d[3] - x[3] * d[k];
      if (CGAL::sign(from_a) * CGAL::sign(from_b) > 0) return false;
    }
    return true;
  }

  void take_wedges(EdgeId near, const FarEdge& far, std::optional<std::uint32_t> facet) {
    const PointId a = scene_.edges[near].a, b = scene_.edges[near].b;
    for (const PointId apex : apexes_) {
      if (are_apart(apex, {a, b}, std::array{far.a, far.b}) || are_apart(apex, {a, b}, light_section_)) continue;
      if (lies_on(apex, a, b)) {
        // A blocker that touches the near edge: all lines through the apex meet that one.
        take_({far.is_on_light ? WedgeKind::from_light_edge : WedgeKind::edge_first, apex, far.a, far.b, 0, near, facet,
               far});
        continue;
      }
      for (const WedgeKind kind : {WedgeKind::edge_first, WedgeKind::apex_first}) {
        take_({kind, apex, a, b, 0, near, facet, far});
      }
    }
  }

  void take_wedges_from_light(EdgeId near, const FarEdge& far) {
    for (const PointId apex : light_section_) {
      if (apex < point_count_) continue;  // a vertex: its events are found elsewhere
      take_({WedgeKind::from_light_vertex, apex, scene_.edges[near].a, scene_.edges[near].b, 0, near, {}, far});
    }
  }

  /// Where the plane cuts the edges of the light and of what meets the light.
  void find_light_section(const PlaneIds& plane) {
    light_section_.clear();
    for (const auto* list : {&scene_.light_edges, &scene_.cut_edges}) {
      for (const LightEdge& e : *list) {
        const int at_a = side(plane, e.a), at_b = side(plane, e.b);
        if (at_a == 0) light_section_.push_back(e.a);
        if (at_b == 0) light_section_.push_back(e.b);
        if (at_a * at_b < 0) light_section_.push_back(add_crossing(plane, e.a, e.b));
      }
    }
  }

  /// A vertex of the light off the plane: seen from there, turns in the plane have signs.
  PointId point_beside(const PlaneIds& plane) const {
    for (const LightVertex& v : scene_.light_vertices) {
      if (side(plane, v.point) != 0) return v.point;
    }
    return plane[0];
  }

  /// True if certainly not more than one line through the apex meets both segments: all ends of one turn alike from
  /// those of the other. One line is what is left where they share an end, and that leaves no trace.
  bool are_apart(PointId apex, const std::array<PointId, 2>& p, std::span<const PointId> q) const {
    unsigned signs = 0;
    for (const PointId a : p) {
      for (const PointId b : q) {
        if (a == b) continue;
        const auto sign = certain_sign(
            bracket<Interval>(scene_.points[apex], scene_.points[a], scene_.points[b], scene_.points[beside_]));
        if (!sign || *sign == 0) return false;
        signs |= *sign > 0 ? 1U : 2U;
      }
    }
    return signs != 3U;
  }

  EventScene& scene_;
  const std::function<void(const Wedge&)>& take_;
  std::vector<std::uint32_t> found_;
  std::vector<EdgeId> far_;
  std::vector<PointId> apexes_;
  std::vector<PointId> light_section_;  ///< ends of what the plane has of the light, and of blockers that cut it
  PointId beside_ = 0;
  std::size_t point_count_ = 0;
};

}  // namespace

std::size_t coplanar_source_count(const EventScene& scene) {
  if (scene.kind != LightKind::area && scene.kind != LightKind::linear) return 0;
  return scene.edges.size() + (scene.kind == LightKind::area ? scene.cutting_facets.size() : 0);
}

void for_each_coplanar_wedge(EventScene& scene, std::size_t source, const std::function<void(const Wedge&)>& take) {
  CoplanarPairs pairs(scene, take);
  if (source >= scene.edges.size()) return pairs.in_plane_of(static_cast<std::uint32_t>(source - scene.edges.size()));
  const auto e = static_cast<EdgeId>(source);
  const BlockerEdge& edge = scene.edges[e];
  const auto is_served = [&](PointId p) { return scene.is_two_sided || scene.light_side(p) > 0; };
  if (!edge.may_be_seen || (!is_served(edge.a) && !is_served(edge.b))) return;
  pairs.with_light_edges(e);
  pairs.with_blocker_edges(e);
}

}  // namespace gnomon::event
