#include "geometry/discontinuity/vertex_shadows.h"

#include "geometry/numbers/exact_vector.h"

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
      const Sides corners = sides(shape.corners, [&](PointId p) {
        return p == e.a || p == e.b ? 0 : orientation(l, scene_.points[e.a], scene_.points[e.b], scene_.points[p]);
      });
      if (corners.positive != corners.negative) known = add_side({light, e.a, e.b}, shape.corners[0], shape);
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

}  // namespace gnomon::event
