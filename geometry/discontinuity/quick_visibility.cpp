#include "geometry/discontinuity/quick_visibility.h"

#include <algorithm>

// Notation. p: the point that looks, somewhere in a small box. before: the side of the light's plane on which p lies,
// +1 in front. L+: what of the light lies before the receiver's plane; the region speaks of this alone. l: a vertex of
// the light. v: a vertex of a blocker. Every sign below is certain for all points of the box, or it is not used.
//
// Why each answer holds. A vertex l is hidden if p lies strictly inside the shadow that l alone would throw, so with l
// a part of the light around it is hidden; it is seen if p lies strictly outside of all these shadows, so a part around
// it is open. Both parts reach into L+ where l lies strictly before the receiver's plane.
//   penumbra  one vertex of L+ is hidden and one is seen: a part of L+ is hidden, and a part is open.
//   lit       each shape that may hide something is parted from the light, as seen from p, by an edge of one of them:
//             no line from p to the light meets it.
//   penumbra  no vertex of L+ is hidden, so one is seen and a part is open; and a shape has a corner strictly inside
//             the pyramid between p and the light and before the receiver's plane: around it the shape hides a part.
//   umbra     one shape hides every vertex of the light. What a convex shape hides of the light, as seen from p, is
//             convex, so it is all. (Several shapes may do it together; that is left to the exact level.)
//   penumbra  a vertex v, strictly inside the pyramid, is on the outline of what the shapes hide: next to it, as seen
//             from p, the light is open in some directions and hidden in others.
// Lit and penumbra so found hold without regard to triple-edge events, which only open or close gaps that no vertex
// shows; umbra by one shape does not: elsewhere in the face the light may come past it.

namespace gnomon::event {

const QuickVisibility::Place& QuickVisibility::place(PointId p) {
  Place& known = places_[p];
  if (known.is_known) return known;
  const auto& c = receiver_.plane;
  const bool is_corner = p == c[0] || p == c[1] || p == c[2];
  known.is_before_plane =
      !is_corner && orientation(scene_.points[c[0]], scene_.points[c[1]], scene_.points[c[2]], scene_.points[p]) > 0;
  known.light_side = static_cast<std::int8_t>(scene_.light_side(p));
  known.is_known = true;
  return known;
}

/// True if nothing of the shape lies before the receiver's plane.
bool QuickVisibility::hides_nothing(ShapeId s) {
  if (known_[s] == 0) {
    const auto& corners = scene_.shapes[s].corners;
    const bool may_hide =
        std::any_of(corners.begin(), corners.end(), [&](PointId p) { return place(p).is_before_plane; });
    known_[s] = may_hide && !EventScene::is_own(receiver_, s) ? 1 : 2;
  }
  return known_[s] == 2;
}

void QuickVisibility::collect_hiding(std::span<const ShapeId> near) {
  hiding_.clear();
  std::copy_if(near.begin(), near.end(), std::back_inserter(hiding_), [&](ShapeId s) { return !hides_nothing(s); });
}

int QuickVisibility::side(const PointEnclosure& p, PointId a, PointId b, PointId c) const {
  const auto from = [&](PointId id) {
    const Point3& q = scene_.points[id].input;
    return std::array<Interval, 3>{Interval(q.x) - p[0], Interval(q.y) - p[1], Interval(q.z) - p[2]};
  };
  const auto u = from(a), v = from(b), w = from(c);
  const Interval det =
      u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  return det.inf() > 0 ? 1 : det.sup() < 0 ? -1 : 0;
}

/// An edge of one of the two parts them as seen from the point.
bool QuickVisibility::is_beside_light(const Shape& shape, const PointEnclosure& p) const {
  const auto parts = [&](PointId a, PointId b, const auto& own, const auto& others) {
    int inside = 0;
    for (const PointId q : own) {
      if (q == a || q == b) continue;
      const int s = side(p, a, b, q);
      if (s == 0 || s == -inside) return false;
      inside = s;
    }
    return inside != 0 &&
           std::all_of(others.begin(), others.end(), [&](PointId q) { return side(p, a, b, q) == -inside; });
  };
  std::vector<PointId> light;
  for (const LightVertex& v : scene_.light_vertices) light.push_back(v.point);
  for (const LightEdge& e : scene_.light_edges) {
    if (light.size() > 2 && parts(e.a, e.b, light, shape.corners)) return true;
  }
  return std::any_of(shape.edges.begin(), shape.edges.end(),
                     [&](const ShapeEdge& e) { return parts(e.a, e.b, shape.corners, light); });
}

/// A point lies strictly inside the pyramid between p and the light, on whose side `before` p lies.
bool QuickVisibility::is_in_light(PointId v, const PointEnclosure& p, int before) {
  // Seen from p the light's edges run around what lies in its direction one way, and around what lies in the opposite
  // direction the other way.
  return place(v).light_side == before &&
         std::all_of(scene_.light_edges.begin(), scene_.light_edges.end(),
                     [&](const LightEdge& e) { return side(p, e.a, e.b, v) == -before; });
}

/// A blocker's vertex is seen before the light, hidden and open parts of the light around it.
bool QuickVisibility::shows_vertex(const PointEnclosure& p, int before) {
  seen_.view(p, hiding_);
  const auto vertices = seen_.vertices();
  return std::any_of(vertices.begin(), vertices.end(), [&](PointId v) {
    return place(v).is_before_plane && is_in_light(v, p, before) && seen_.is_on_silhouette(v);
  });
}

/// True if one shape hides the light vertex; else tells whether it is known that none does.
bool QuickVisibility::is_hidden(std::uint32_t light_vertex, const PointEnclosure& p, bool& is_seen) {
  is_seen = true;
  for (const ShapeId s : hiding_) {
    const VertexShadows::Answer answer = shadows_.ask(light_vertex, s, p);
    is_seen = is_seen && answer == VertexShadows::Answer::seen;
    if (answer != VertexShadows::Answer::hidden) continue;
    cover_.push_back(s);
    return true;
  }
  return false;
}

/// A shape that hides all of the light, of those that hide a vertex of it.
std::optional<ShapeId> QuickVisibility::cover_of_all(const PointEnclosure& p) const {
  const auto n = static_cast<std::uint32_t>(scene_.light_vertices.size());
  for (const ShapeId s : cover_) {
    bool hides_all = true;
    for (std::uint32_t l = 0; hides_all && l < n; ++l) {
      hides_all = shadows_.ask(l, s, p) == VertexShadows::Answer::hidden;
    }
    if (hides_all) return s;
  }
  return std::nullopt;
}

/// No vertex of the light is hidden.
std::optional<QuickAnswer> QuickVisibility::region_of_visible_vertices(const PointEnclosure& p, int before) {
  bool all_beside = true;
  for (const ShapeId s : hiding_) {
    if (is_beside_light(scene_.shapes[s], p)) continue;
    all_beside = false;
    const std::vector<PointId>& corners = scene_.shapes[s].corners;
    if (before != 0 && std::any_of(corners.begin(), corners.end(),
                                   [&](PointId v) { return is_in_light(v, p, before) && place(v).is_before_plane; })) {
      return QuickAnswer{Region::penumbra, true};
    }
  }
  if (all_beside) return QuickAnswer{Region::lit, true};
  return std::nullopt;
}

std::optional<QuickAnswer> QuickVisibility::region(const PointEnclosure& p, std::span<const ShapeId> near) {
  if (scene_.kind != LightKind::area && scene_.kind != LightKind::linear) return std::nullopt;
  int before = 0;
  if (scene_.kind == LightKind::area) {
    before = -side(p, scene_.light_plane[0], scene_.light_plane[1], scene_.light_plane[2]);
    if (before == 0) return std::nullopt;
    if (before < 0 && !scene_.is_two_sided) return QuickAnswer{Region::unlit, true};
  }
  collect_hiding(near);
  cover_.clear();
  std::optional<std::uint32_t> any_hidden, any_seen;
  bool all_known = true;
  for (std::uint32_t l = 0; l < scene_.light_vertices.size(); ++l) {
    bool seen = false;
    const bool hidden = is_hidden(l, p, seen);
    // What lies in or behind the plane is not received, whether hidden or not.
    if (hidden && light_.sides[l] > 0) any_hidden = l;
    if (!hidden && seen && light_.sides[l] > 0) any_seen = l;
    all_known = all_known && (hidden || seen);
  }
  if (any_hidden && any_seen) return QuickAnswer{Region::penumbra, true, {}, {{*any_seen, *any_hidden}}};
  if (all_known && !any_hidden) return region_of_visible_vertices(p, before);
  if (all_known) {
    if (const auto cover = cover_of_all(p)) return QuickAnswer{Region::umbra, false, cover};
  }
  if (before != 0 && shows_vertex(p, before)) return QuickAnswer{Region::penumbra, true};
  return std::nullopt;
}

}  // namespace gnomon::event
