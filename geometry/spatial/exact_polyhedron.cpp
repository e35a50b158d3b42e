#include "geometry/spatial/exact_polyhedron.h"

#include <CGAL/determinant.h>

#include <algorithm>
#include <utility>

namespace gnomon {
namespace {

template <class Number>
Number value(const Quadruple<Number>& plane, const Quadruple<Number>& point) {
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3] * point[3];
}

/// The point on three planes, up to sign.
template <class Number>
Quadruple<Number> meet(const Quadruple<Number>& p, const Quadruple<Number>& q, const Quadruple<Number>& r) {
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) -> Number {
    return CGAL::determinant<Number>(p[i], p[j], p[k], q[i], q[j], q[k], r[i], r[j], r[k]);
  };
  return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

template <class Number>
Quadruple<Number> negated(const Quadruple<Number>& v) {
  return {-v[0], -v[1], -v[2], -v[3]};
}

template <class Number>
Quadruple<Number> input_coordinates(bool direction, const Point3& first, const Point3& second) {
  if (!direction) return {Number(first.x), Number(first.y), Number(first.z), Number(1)};
  return {Number(second.x) - Number(first.x), Number(second.y) - Number(first.y), Number(second.z) - Number(first.z),
          Number(0)};
}

Quadruple<Interval> enclosing(const Quadruple<Rational>& v) {
  Quadruple<Interval> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = Interval(CGAL::to_interval(v[i]));
  return result;
}

/// The sign of an interval, or nothing if it is not certain.
std::optional<int> certain_sign(const Interval& x) {
  if (x.inf() > 0) return 1;
  if (x.sup() < 0) return -1;
  if (x.inf() == 0 && x.sup() == 0) return 0;
  return std::nullopt;
}

}  // namespace

template <class Number>
Quadruple<Number> ExactSpace::coefficients(const Plane& plane) {
  Quadruple<Number> result{Number(0), Number(0), Number(0), Number(0)};
  if (plane.axis >= 0) {
    result[static_cast<std::size_t>(plane.axis)] = Number(plane.axis_sign);
    result[3] = Number(-plane.axis_sign) * Number(plane.bound);
  } else {
    const auto p = input_coordinates<Number>(false, plane.points[0], {});
    const auto q = input_coordinates<Number>(true, plane.points[0], plane.points[1]);
    const auto r = input_coordinates<Number>(true, plane.points[0], plane.points[2]);
    result[0] = q[1] * r[2] - q[2] * r[1];
    result[1] = q[2] * r[0] - q[0] * r[2];
    result[2] = q[0] * r[1] - q[1] * r[0];
    result[3] = -(result[0] * p[0] + result[1] * p[1] + result[2] * p[2]);
  }
  return plane.reverse_of ? negated(result) : result;
}

ExactSpace::ExactSpace(const HalfSpace& downward_half_space) {
  Plane infinity;
  infinity.name = {FacetKind::clip_box};
  infinity.exact = Quadruple<Rational>{Rational(0), Rational(0), Rational(0), Rational(1)};
  infinity.approximate = enclosing(*infinity.exact);
  planes_.push_back(infinity);
  add_plane(downward_half_space);
}

PlaneId ExactSpace::add(Plane plane) {
  plane.approximate = coefficients<Interval>(plane);
  planes_.push_back(std::move(plane));
  return static_cast<PlaneId>(planes_.size() - 1);
}

PlaneId ExactSpace::add_plane(const HalfSpace& half_space) {
  Plane plane;
  plane.name = half_space.name;
  plane.points = half_space.plane;
  return add(std::move(plane));
}

PlaneId ExactSpace::add_box_side(const Box3& box, int side) {
  const std::array<double, 6> bounds = {box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z};
  Plane plane;
  plane.name = {FacetKind::clip_box, side};
  plane.axis = side / 2;
  plane.axis_sign = side % 2 == 0 ? -1 : 1;
  plane.bound = bounds[static_cast<std::size_t>(side)];
  return add(std::move(plane));
}

PlaneId ExactSpace::add_reversed(PlaneId plane) {
  if (planes_[plane].reverse_of) return *planes_[plane].reverse_of;
  Plane reversed = planes_[plane];
  reversed.reverse_of = plane;
  reversed.exact.reset();
  return add(std::move(reversed));
}

const Quadruple<Rational>& ExactSpace::exact_plane(PlaneId plane) const {
  const Plane& p = planes_[plane];
  if (!p.exact) p.exact = coefficients<Rational>(p);
  return *p.exact;
}

VertexId ExactSpace::add_input(bool direction, const Point3& first, const Point3& second, std::vector<PlaneId> planes) {
  Vertex vertex;
  vertex.direction = direction;
  vertex.input = true;
  vertex.points = {first, second};
  vertex.planes = std::move(planes);
  vertex.approximate = input_coordinates<Interval>(direction, first, second);
  vertices_.push_back(std::move(vertex));
  return static_cast<VertexId>(vertices_.size() - 1);
}

VertexId ExactSpace::add_point(const Point3& point, std::vector<PlaneId> planes) {
  return add_input(false, point, {}, std::move(planes));
}

VertexId ExactSpace::add_direction(const Point3& from, const Point3& to, std::vector<PlaneId> planes) {
  return add_input(true, from, to, std::move(planes));
}

VertexId ExactSpace::add_copy(VertexId vertex) {
  vertices_.push_back(Vertex(vertices_[vertex]));
  return static_cast<VertexId>(vertices_.size() - 1);
}

VertexId ExactSpace::add_meet(bool direction, PlaneId a, PlaneId b, PlaneId c) {
  Vertex vertex;
  vertex.direction = direction;
  vertex.planes = {a, b, c};
  vertex.approximate = meet(planes_[a].approximate, planes_[b].approximate, planes_[c].approximate);
  vertices_.push_back(vertex);
  const auto id = static_cast<VertexId>(vertices_.size() - 1);
  const Interval key =
      vertex.direction ? -value(planes_[downward].approximate, vertex.approximate) : vertex.approximate[3];
  const std::optional<int> sign = certain_sign(key);
  if (!sign) {
    vertices_[id].approximate = enclosing(exact_vertex(id));
  } else if (*sign < 0) {
    vertices_[id].approximate = negated(vertex.approximate);
  }
  return id;
}

const Quadruple<Rational>& ExactSpace::exact_vertex(VertexId vertex) const {
  const Vertex& v = vertices_[vertex];
  if (v.exact) return *v.exact;
  if (v.input) {
    v.exact = input_coordinates<Rational>(v.direction, v.points[0], v.points[1]);
    return *v.exact;
  }
  const Quadruple<Rational> m = meet(exact_plane(v.planes[0]), exact_plane(v.planes[1]), exact_plane(v.planes[2]));
  const Rational key = v.direction ? Rational(-value(exact_plane(downward), m)) : m[3];
  v.exact = key < 0 ? negated(m) : m;
  return *v.exact;
}

int ExactSpace::side(PlaneId plane, VertexId vertex) const {
  if (planes_[plane].reverse_of) return -side(*planes_[plane].reverse_of, vertex);
  const Vertex& v = vertices_[vertex];
  if (std::find(v.planes.begin(), v.planes.end(), plane) != v.planes.end()) return 0;
  const std::optional<int> sign = certain_sign(value(planes_[plane].approximate, v.approximate));
  if (sign) return *sign;
  return CGAL::sign(value(exact_plane(plane), exact_vertex(vertex)));
}

int ExactSpace::compare(VertexId a, VertexId b) const {
  if (a == b) return 0;
  const Vertex& p = vertices_[a];
  const Vertex& q = vertices_[b];
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval difference = p.approximate[i] * q.approximate[3] - q.approximate[i] * p.approximate[3];
    std::optional<int> sign = certain_sign(difference);
    if (!sign) {
      const Quadruple<Rational>& x = exact_vertex(a);
      const Quadruple<Rational>& y = exact_vertex(b);
      sign = CGAL::sign(Rational(x[i] * y[3] - y[i] * x[3]));
    }
    if (*sign != 0) return *sign;
  }
  return 0;
}

namespace {

/// Determinant of three homogeneous points projected along an axis, oriented so that the axis points to the viewer.
template <class Number>
Number projected_turn(std::size_t axis, const Quadruple<Number>& a, const Quadruple<Number>& b,
                      const Quadruple<Number>& c) {
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  return CGAL::determinant<Number>(a[i], a[j], a[3], b[i], b[j], b[3], c[i], c[j], c[3]);
}

}  // namespace

int ExactSpace::turn(PlaneId plane, VertexId a, VertexId b, VertexId c) const {
  const Quadruple<Interval>& normal = planes_[plane].approximate;
  const auto size = [&](std::size_t i) { return std::min(std::abs(normal[i].inf()), std::abs(normal[i].sup())); };
  std::size_t axis = size(0) >= size(1) ? 0 : 1;
  if (size(2) > size(axis)) axis = 2;
  std::optional<int> facing = certain_sign(normal[axis]);
  if (!facing || *facing == 0) {
    const Quadruple<Rational>& exact = exact_plane(plane);
    while (exact[axis] == 0) axis = (axis + 1) % 3;
    facing = CGAL::sign(exact[axis]);
  }
  const std::optional<int> sign =
      certain_sign(projected_turn(axis, vertices_[a].approximate, vertices_[b].approximate, vertices_[c].approximate));
  if (sign) return *facing * *sign;
  return *facing * CGAL::sign(projected_turn(axis, exact_vertex(a), exact_vertex(b), exact_vertex(c)));
}

namespace {

/// An edge that a plane cuts: the face from which it was met first, and the vertex of the cut.
struct CutEdge {
  PlaneId first_plane;
  VertexId vertex = 0;
};

std::uint64_t edge_key(VertexId a, VertexId b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// The loop of the cut: the polyhedron's remaining faces border it along their edges in the plane, the other way round.
std::vector<VertexId> cap_loop(const std::unordered_map<VertexId, VertexId>& successor) {
  std::vector<VertexId> loop;
  const VertexId start = successor.begin()->first;
  for (VertexId v = start; loop.empty() || v != start; v = successor.at(v)) loop.push_back(v);
  return loop;
}

}  // namespace

ConvexPolyhedron ExactSpace::clipped(const ConvexPolyhedron& polyhedron, PlaneId plane) {
  std::unordered_map<VertexId, int> sides;
  bool any_inside = false;
  bool any_outside = false;
  for (const auto& face : polyhedron.faces) {
    for (const VertexId v : face.loop) {
      const auto [entry, is_new] = sides.try_emplace(v, 0);
      if (is_new) entry->second = side(plane, v);
      any_inside = any_inside || entry->second < 0;
      any_outside = any_outside || entry->second > 0;
    }
  }
  if (!any_outside) return polyhedron;
  if (!any_inside) return {};
  return cut(polyhedron, plane, sides);
}

ConvexPolyhedron ExactSpace::cut(const ConvexPolyhedron& polyhedron, PlaneId plane,
                                 std::unordered_map<VertexId, int>& sides) {
  std::unordered_map<std::uint64_t, CutEdge> cut_edges;
  for (const auto& face : polyhedron.faces) {
    VertexId u = face.loop.back();
    for (const VertexId v : face.loop) {
      if (sides[u] * sides[v] < 0) {
        const auto [entry, is_new] = cut_edges.try_emplace(edge_key(u, v), CutEdge{face.plane});
        if (!is_new) {
          const bool is_at_infinity = is_direction(u) && is_direction(v);
          entry->second.vertex = add_meet(is_at_infinity, entry->second.first_plane, face.plane, plane);
        }
      }
      u = v;
    }
  }
  for (const auto& [key, edge] : cut_edges) sides[edge.vertex] = 0;
  for (const auto& [vertex, side] : sides) {
    if (side == 0) remember(vertex, plane);
  }
  ConvexPolyhedron result;
  std::unordered_map<VertexId, VertexId> cap_successor;
  for (const auto& face : polyhedron.faces) {
    ConvexPolyhedron::Face kept{face.plane, {}};
    bool has_inside = false;
    VertexId u = face.loop.back();
    for (const VertexId v : face.loop) {
      if (sides[u] * sides[v] < 0) kept.loop.push_back(cut_edges.at(edge_key(u, v)).vertex);
      if (sides[v] <= 0) kept.loop.push_back(v);
      has_inside = has_inside || sides[v] < 0;
      u = v;
    }
    if (!has_inside) continue;
    u = kept.loop.back();
    for (const VertexId v : kept.loop) {
      if (sides[u] == 0 && sides[v] == 0) cap_successor[v] = u;
      u = v;
    }
    result.faces.push_back(std::move(kept));
  }
  result.faces.push_back({plane, cap_loop(cap_successor)});
  return result;
}

void ExactSpace::remember(VertexId vertex, PlaneId plane) {
  plane = planes_[plane].reverse_of.value_or(plane);
  auto& planes = vertices_[vertex].planes;
  if (std::find(planes.begin(), planes.end(), plane) == planes.end()) planes.push_back(plane);
}

ConvexPolyhedron ExactSpace::box(const Box3& box, const std::array<PlaneId, 6>& sides) {
  std::array<VertexId, 8> corner;
  for (unsigned c = 0; c < 8; ++c) {
    const Point3 p{c & 1 ? box.max.x : box.min.x, c & 2 ? box.max.y : box.min.y, c & 4 ? box.max.z : box.min.z};
    corner[c] = add_point(p, {sides[c & 1], sides[2 + (c >> 1 & 1)], sides[4 + (c >> 2 & 1)]});
  }
  constexpr unsigned loops[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  ConvexPolyhedron result;
  for (std::size_t side = 0; side < 6; ++side) {
    ConvexPolyhedron::Face face{sides[side], {}};
    for (const unsigned c : loops[side]) face.loop.push_back(corner[c]);
    result.faces.push_back(std::move(face));
  }
  return result;
}

}  // namespace gnomon
