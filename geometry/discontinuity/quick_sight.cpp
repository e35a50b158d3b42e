#include "geometry/discontinuity/quick_sight.h"

#include <algorithm>

namespace gnomon::event {
namespace {

/// Twice the signed area of the triangle that the sightlines to two points span, as a normal.
std::array<Interval, 3> normal_of(const EventPoint& v, const EventPoint& a, const EventPoint& b) {
  const auto sub = [](const Point3& p, const Point3& q) {
    return std::array<Interval, 3>{Interval(p.x) - Interval(q.x), Interval(p.y) - Interval(q.y),
                                   Interval(p.z) - Interval(q.z)};
  };
  const std::array<Interval, 3> u =
      v.kind == EventPoint::Kind::direction
          ? std::array<Interval, 3>{Interval(-v.input.x), Interval(-v.input.y), Interval(-v.input.z)}
          : sub(a.input, v.input);
  const auto w = sub(b.input, a.input);
  return {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
}

}  // namespace

VertexShadows::VertexShadows(const EventScene& scene) : scene_(scene) {
  for (const LightVertex& v : scene.light_vertices) {
    for (const Shape& shape : scene.shapes) add(v.point, shape);
  }
}

bool VertexShadows::add_side(const std::array<PointId, 3>& points, PointId inside, const Shape& shape) {
  Side side;
  side.points = points;
  side.origin = scene_.points[points[1]].input;
  side.normal = normal_of(scene_.points[points[0]], scene_.points[points[1]], scene_.points[points[2]]);
  const auto sign_at = [&](PointId p) {
    return orientation(scene_.points[points[0]], scene_.points[points[1]], scene_.points[points[2]], scene_.points[p]);
  };
  side.sign = sign_at(inside);
  for (std::size_t k = 0; side.sign == 0 && k < shape.corners.size(); ++k) side.sign = sign_at(shape.corners[k]);
  if (side.sign == 0) return false;
  if (side.sign < 0) {
    for (Interval& n : side.normal) n = -n;
  }
  sides_.push_back(side);
  return true;
}

void VertexShadows::add(PointId light, const Shape& shape) {
  Range range{static_cast<std::uint32_t>(sides_.size()), 0};
  const EventPoint& l = scene_.points[light];
  // Sides of the light vertex: of a facet, or of a flat shape's plane.
  bool known = true;
  const auto face_side = [&](const std::vector<PointId>& loop) {
    return orientation(scene_.points[loop[0]], scene_.points[loop[1]], scene_.points[loop[2]], l);
  };
  const auto add_front = [&](const std::vector<PointId>& loop, int side_of_light) {
    Side side;
    side.points = {loop[0], loop[1], loop[2]};
    side.origin = scene_.points[loop[1]].input;
    side.normal = normal_of(scene_.points[loop[0]], scene_.points[loop[1]], scene_.points[loop[2]]);
    side.sign = -side_of_light;
    if (side.sign < 0) {
      for (Interval& n : side.normal) n = -n;
    }
    sides_.push_back(side);
  };
  if (!shape.is_solid) {
    const int s = face_side(shape.corners);
    known = s != 0;
    if (known) add_front(shape.corners, s);
    for (std::size_t k = 0; known && k < shape.edges.size(); ++k) {
      const ShapeEdge& e = shape.edges[k];
      known = add_side({light, e.a, e.b}, shape.corners[(k + 2) % shape.corners.size()], shape);
    }
  } else {
    for (const auto& loop : shape.facets) {
      const int s = face_side(loop);
      known = known && s != 0;
      if (s > 0) add_front(loop, s);
    }
    for (const ShapeEdge& e : shape.edges) {
      if (!known) break;
      bool above = false, below = false;
      for (const PointId p : shape.corners) {
        if (p == e.a || p == e.b) continue;
        const int s = orientation(l, scene_.points[e.a], scene_.points[e.b], scene_.points[p]);
        above = above || s > 0;
        below = below || s < 0;
      }
      if (above != below) known = add_side({light, e.a, e.b}, shape.corners[0], shape);
    }
  }
  if (known) {
    range.count = static_cast<std::uint32_t>(sides_.size()) - range.first;
  } else {
    sides_.resize(range.first);
  }
  ranges_.push_back(range);
}

Interval VertexShadows::value(const Side& side, const PointEnclosure& p) const {
  return side.normal[0] * (p[0] - Interval(side.origin.x)) + side.normal[1] * (p[1] - Interval(side.origin.y)) +
         side.normal[2] * (p[2] - Interval(side.origin.z));
}

VertexShadows::Answer VertexShadows::ask(std::uint32_t light_vertex, ShapeId shape, const PointEnclosure& p) const {
  const auto [first, count] = range(light_vertex, shape);
  if (count == 0) return Answer::unknown;
  bool inside = true;
  for (std::uint32_t k = first; k < first + count; ++k) {
    const Interval at = value(sides_[k], p);
    if (at.sup() < 0) return Answer::seen;
    inside = inside && at.inf() > 0;
  }
  return inside ? Answer::hidden : Answer::unknown;
}

bool VertexShadows::holds(std::uint32_t light_vertex, ShapeId shape, const PointEnclosure& near,
                          const std::function<ExactVector()>& exact_point) const {
  const auto [first, count] = range(light_vertex, shape);
  for (std::uint32_t k = first; k < first + count; ++k) {
    const Side& side = sides_[k];
    const Interval at = value(side, near);
    if (at.sup() < 0) return false;
    if (at.inf() >= 0) continue;
    const auto point = [&](std::size_t i) { return exact(scene_.points[side.points[i]].input); };
    const ExactVector a = point(1);
    const bool infinite = scene_.points[side.points[0]].kind == EventPoint::Kind::direction;
    const ExactVector u = infinite ? Rational(-1) * point(0) : a - point(0);
    const Rational exactly = Rational(side.sign) * dot(cross(u, point(2) - a), exact_point() - a);
    if (exactly < 0) return false;
  }
  return count > 0;
}

bool QuickSight::is_before_plane(PointId p) const {
  const auto& c = receiver_.corners;
  if (p == c[0] || p == c[1] || p == c[2]) return false;
  return orientation(scene_.points[c[0]], scene_.points[c[1]], scene_.points[c[2]], scene_.points[p]) > 0;
}

/// True if nothing of the shape lies before the receiver's plane.
bool QuickSight::hides_nothing(ShapeId s) {
  if (known_[s] == 0) {
    const auto& corners = scene_.shapes[s].corners;
    const bool may_hide = std::any_of(corners.begin(), corners.end(), [&](PointId p) { return is_before_plane(p); });
    known_[s] = may_hide ? 1 : 2;
  }
  return known_[s] == 2;
}

int QuickSight::side(const PointEnclosure& p, PointId a, PointId b, PointId c) const {
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
bool QuickSight::is_beside_light(const Shape& shape, const PointEnclosure& p) const {
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
bool QuickSight::is_in_light(PointId v, const PointEnclosure& p, int before) const {
  // Seen from p the light's edges run around what lies in its direction one way, and around what lies in the opposite
  // direction the other way.
  return scene_.light_side(v) == before &&
         std::all_of(scene_.light_edges.begin(), scene_.light_edges.end(),
                     [&](const LightEdge& e) { return side(p, e.a, e.b, v) == -before; });
}

namespace {

/// The side of the plane through p and an edge on which all other corners of its shape lie; 0 if there is none.
template <class Side>
int side_of_shape(const Shape& shape, const ShapeEdge& e, const Side& side) {
  int inside = 0;
  for (const PointId q : shape.corners) {
    if (q == e.a || q == e.b) continue;
    const int s = side(e, q);
    if (s == 0 || s == -inside) return 0;
    inside = s;
  }
  return inside;
}

}  // namespace

/// The line from p through v passes beside the shape.
bool QuickSight::leaves_open(const Shape& shape, const PointEnclosure& p, PointId v) const {
  const auto side_at = [&](const ShapeEdge& e, PointId q) { return side(p, e.a, e.b, q); };
  return std::any_of(shape.edges.begin(), shape.edges.end(), [&](const ShapeEdge& e) {
    const int at_v = side_at(e, v);
    return at_v != 0 && side_of_shape(shape, e, side_at) == -at_v;
  });
}

/// The shape lies on one side of an edge at its corner v, as seen from p.
bool QuickSight::is_on_outline(const Shape& shape, const PointEnclosure& p, PointId v) const {
  const auto side_at = [&](const ShapeEdge& e, PointId q) { return side(p, e.a, e.b, q); };
  return std::any_of(shape.edges.begin(), shape.edges.end(), [&](const ShapeEdge& e) {
    return (e.a == v || e.b == v) && side_of_shape(shape, e, side_at) != 0;
  });
}

/// A blocker's vertex is seen before the light, hidden and open parts of the light around it.
bool QuickSight::shows_vertex(const PointEnclosure& p, std::span<const ShapeId> near, int before) {
  for (const ShapeId s : near) {
    if (hides_nothing(s)) continue;
    const Shape& shape = scene_.shapes[s];
    for (const PointId v : shape.corners) {
      if (!is_in_light(v, p, before) || !is_before_plane(v) || !is_on_outline(shape, p, v)) continue;
      if (std::all_of(near.begin(), near.end(), [&](ShapeId other) {
            return other == s || hides_nothing(other) || leaves_open(scene_.shapes[other], p, v);
          })) {
        return true;
      }
    }
  }
  return false;
}

std::optional<QuickAnswer> QuickSight::region(const PointEnclosure& p, std::span<const ShapeId> near) {
  if (scene_.kind != LightKind::area && scene_.kind != LightKind::linear) return std::nullopt;
  int before = 0;
  if (scene_.kind == LightKind::area) {
    before = -side(p, scene_.light_plane[0], scene_.light_plane[1], scene_.light_plane[2]);
    if (before == 0) return std::nullopt;
    if (before < 0 && !scene_.is_two_sided) return QuickAnswer{Region::unlit, true};
  }
  const std::size_t n = scene_.light_vertices.size();
  std::vector<ShapeId> cover;
  std::optional<std::uint32_t> any_hidden, any_seen;
  bool all_known = true;
  for (std::uint32_t l = 0; l < n; ++l) {
    bool hidden = false, seen = true;
    for (const ShapeId s : near) {
      if (hides_nothing(s)) continue;
      const VertexShadows::Answer answer = shadows_.ask(l, s, p);
      if (answer == VertexShadows::Answer::hidden) {
        hidden = true;
        cover.push_back(s);
        break;
      }
      seen = seen && answer == VertexShadows::Answer::seen;
    }
    // What lies in or behind the plane is not received, whether hidden or not.
    if (hidden && light_.sides[l] > 0) any_hidden = l;
    if (!hidden && seen && light_.sides[l] > 0) any_seen = l;
    all_known = all_known && (hidden || seen);
  }
  if (any_hidden && any_seen) return QuickAnswer{Region::penumbra, true, {}, {{*any_seen, *any_hidden}}};
  const auto penumbra_or_unknown = [&]() -> std::optional<QuickAnswer> {
    if (before == 0 || !shows_vertex(p, near, before)) return std::nullopt;
    return QuickAnswer{Region::penumbra, true};
  };
  if (!all_known) return penumbra_or_unknown();
  if (any_hidden) {
    for (const ShapeId s : cover) {
      bool hides_all = true;
      for (std::uint32_t l = 0; hides_all && l < n; ++l) {
        hides_all = shadows_.ask(l, s, p) == VertexShadows::Answer::hidden;
      }
      if (hides_all) return QuickAnswer{Region::umbra, false, s};
    }
    return penumbra_or_unknown();
  }
  bool all_beside = true;
  for (const ShapeId s : near) {
    if (hides_nothing(s) || is_beside_light(scene_.shapes[s], p)) continue;
    all_beside = false;
    const std::vector<PointId>& corners = scene_.shapes[s].corners;
    if (before != 0 && std::any_of(corners.begin(), corners.end(),
                                   [&](PointId v) { return is_in_light(v, p, before) && is_before_plane(v); })) {
      return QuickAnswer{Region::penumbra, true};
    }
  }
  if (all_beside) return QuickAnswer{Region::lit, true};
  return std::nullopt;
}

}  // namespace gnomon::event
