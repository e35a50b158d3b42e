#include "geometry/spatial/exact_space.h"

#include <CGAL/determinant.h>

#include <algorithm>

#include "geometry/spatial/homogeneous.h"

namespace gnomon {
namespace {

using PlaneKind = PlaneDefinition::Kind;
constexpr std::uint32_t no_input = VertexDefinition::none;

template <class Number>
Quadruple<Number> negated(const Quadruple<Number>& v) {
  return {-v[0], -v[1], -v[2], -v[3]};
}

/// CGAL scales by a power of two that, rounded upward, is the smallest double where it should be nothing: what comes
/// out this small may be far too large, so only its sign is kept.
Interval enclosing(const ExactReal& number) {
  constexpr double tiny = 0x1p-960;
  const Interval interval(CGAL::to_interval(number));
  if (interval.sup() >= tiny || interval.inf() <= -tiny) return interval;
  const int sign = static_cast<int>(CGAL::sign(number));
  return {sign < 0 ? -tiny : 0, sign > 0 ? tiny : 0};
}

Quadruple<Interval> enclosing(const Quadruple<ExactReal>& v) {
  return {enclosing(v[0]), enclosing(v[1]), enclosing(v[2]), enclosing(v[3])};
}

/// The sign of an interval, or nothing if it is not certain.
std::optional<int> certain_sign(const Interval& x) {
  if (x.inf() > 0) return 1;
  if (x.sup() < 0) return -1;
  if (x.inf() == 0 && x.sup() == 0) return 0;
  return std::nullopt;
}

int exact_sign(const ExactReal& x) {
  return static_cast<int>(CGAL::sign(x));
}

/// Determinant of three homogeneous points projected along an axis, oriented so that the axis points to the viewer.
template <class Number>
Number projected_turn(std::size_t axis, const Quadruple<Number>& a, const Quadruple<Number>& b,
                      const Quadruple<Number>& c) {
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  return CGAL::determinant<Number>(a[i], a[j], a[3], b[i], b[j], b[3], c[i], c[j], c[3]);
}

Quadruple<ExactReal> middle_of(const Quadruple<ExactReal>& u, const Quadruple<ExactReal>& v) {
  return {u[0] * v[3] + v[0] * u[3], u[1] * v[3] + v[1] * u[3], u[2] * v[3] + v[2] * u[3], ExactReal(2) * u[3] * v[3]};
}

bool has_point(const PlaneDefinition& plane, const Point3& p) {
  const auto& [a, b, c] = plane.points;
  return p == a || p == b || (p == c && plane.kind == PlaneKind::points);
}

}  // namespace

ExactSpace::ExactSpace(const HalfSpace& downward_half_space) {
  planes_.reserve(64);
  vertices_.reserve(128);
  inputs_.reserve(64);
  add({.kind = PlaneKind::infinity, .name = {FacetKind::clip_box}});
  add_plane(downward_half_space);
}

PlaneId ExactSpace::add(const PlaneDefinition& definition) {
  Plane& plane = planes_.emplace_back();
  plane.definition = definition;
  plane.approximate = coefficients<Interval>(definition);
  return static_cast<PlaneId>(planes_.size() - 1);
}

PlaneId ExactSpace::add_plane(const HalfSpace& half_space) {
  const PlaneKind kind = half_space.third_is_direction ? PlaneKind::points_direction : PlaneKind::points;
  return add({.kind = kind, .name = half_space.name, .points = half_space.plane});
}

PlaneId ExactSpace::add_box_side(const Box3& box, int side) {
  const double bounds[] = {box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z};
  return add({.kind = PlaneKind::axis,
              .name = {FacetKind::clip_box, static_cast<std::uint32_t>(side)},
              .axis = static_cast<std::uint32_t>(side / 2),
              .sign = side % 2 == 0 ? -1.0 : 1.0,
              .bound = bounds[static_cast<std::size_t>(side)]});
}

PlaneId ExactSpace::add_apex_plane(const Point3& apex, std::uint32_t axis, double sign, double bound, int scale) {
  PlaneDefinition definition = planes_[downward].definition;
  definition.kind = PlaneKind::apex;
  definition.apex = apex;
  definition.axis = axis;
  definition.sign = sign;
  definition.bound = bound;
  definition.scale = scale;
  return add(definition);
}

PlaneId ExactSpace::add_reversed(PlaneId plane) {
  if (planes_[plane].reverse_of) return *planes_[plane].reverse_of;
  PlaneDefinition reversed = planes_[plane].definition;
  reversed.sign = -reversed.sign;
  const PlaneId id = add(reversed);
  planes_[id].reverse_of = plane;
  return id;
}

VertexId ExactSpace::add_input(const InputVertex& input) {
  Vertex& vertex = vertices_.emplace_back();
  vertex.definition.input = static_cast<std::uint32_t>(inputs_.size());
  vertex.definition.direction = input.kind != InputVertex::Kind::point;
  if (input.kind == InputVertex::Kind::difference) vertex.definition.line = vertex.definition.input;
  vertex.approximate = input_coordinates<Interval>(input);
  inputs_.push_back(input);
  return static_cast<VertexId>(vertices_.size() - 1);
}

VertexId ExactSpace::add_point(const Point3& point) {
  return add_input({InputVertex::Kind::point, point, {}});
}

VertexId ExactSpace::add_direction(const Point3& from, const Point3& to) {
  return add_input({InputVertex::Kind::difference, from, to});
}

VertexId ExactSpace::add_vector(const Point3& vector) {
  return add_input({InputVertex::Kind::vector, vector, {}});
}

VertexId ExactSpace::add_middle(VertexId u, VertexId v) {
  VertexDefinition definition;
  definition.middle = true;
  definition.planes = {u, v, 0};
  vertices_.push_back({definition, {}});
  const auto id = static_cast<VertexId>(vertices_.size() - 1);
  vertices_[id].approximate = enclosing(exact_vertex(id));
  return id;
}

VertexId ExactSpace::add_copy(VertexId vertex) {
  const Vertex copy = vertices_[vertex];
  vertices_.push_back(copy);
  return static_cast<VertexId>(vertices_.size() - 1);
}

bool ExactSpace::is_on_line(VertexId vertex, std::uint32_t line) const {
  const VertexDefinition& v = vertices_[vertex].definition;
  if (v.line == line) return true;
  if (v.input == no_input || inputs_[v.input].kind != InputVertex::Kind::point) return false;
  return inputs_[v.input].first == inputs_[line].second;
}

/// An input direction on whose line both vertices are known to lie, or none.
std::uint32_t ExactSpace::common_line(VertexId u, VertexId v) const {
  const std::uint32_t of_u = vertices_[u].definition.line;
  if (of_u != no_input && is_on_line(v, of_u)) return of_u;
  const std::uint32_t of_v = vertices_[v].definition.line;
  return of_v != no_input && is_on_line(u, of_v) ? of_v : no_input;
}

VertexId ExactSpace::add_cut(VertexId u, VertexId v, PlaneId a, PlaneId b, PlaneId plane) {
  const auto unreversed = [&](PlaneId p) { return planes_[p].reverse_of.value_or(p); };
  VertexDefinition definition;
  definition.planes = {unreversed(a), unreversed(b), unreversed(plane)};
  definition.direction = is_direction(u) && is_direction(v);
  definition.line = definition.direction ? no_input : common_line(u, v);
  return add_constructed(definition);
}

VertexId ExactSpace::add_meet(const std::array<PlaneId, 3>& planes, bool direction) {
  VertexDefinition definition;
  definition.planes = planes;
  definition.direction = direction;
  return add_constructed(definition);
}

/// Finds the coordinates, up to a positive factor.
VertexId ExactSpace::add_constructed(const VertexDefinition& definition) {
  const auto numbers = [&](PlaneId p) {
    return PlaneWithNumbers<Interval>{&planes_[p].definition, &planes_[p].approximate};
  };
  const auto& [a, b, c] = definition.planes;
  const Quadruple<Interval> found = definition.line != no_input
                                        ? line_meet<Interval>(inputs_[definition.line], numbers(c))
                                        : meet<Interval>(numbers(a), numbers(b), numbers(c));
  const std::optional<int> sign =
      certain_sign(definition.direction ? -value(planes_[downward].approximate, found) : found[3]);
  vertices_.push_back({definition, sign == -1 ? negated(found) : found});
  const auto id = static_cast<VertexId>(vertices_.size() - 1);
  if (!sign) vertices_[id].approximate = enclosing(exact_vertex(id));
  return id;
}

const Quadruple<ExactReal>& ExactSpace::exact_plane(PlaneId plane) const {
  const auto [entry, is_new] = exact_planes_.try_emplace(plane);
  if (is_new) entry->second = coefficients<ExactReal>(planes_[plane].definition);
  return entry->second;
}

Quadruple<ExactReal> ExactSpace::constructed(VertexId vertex) const {
  const VertexDefinition& v = vertices_[vertex].definition;
  if (v.input != no_input) return input_coordinates<ExactReal>(inputs_[v.input]);
  if (v.middle) return middle_of(exact_vertex(v.planes[0]), exact_vertex(v.planes[1]));
  const auto numbers = [&](PlaneId p) { return PlaneWithNumbers<ExactReal>{&planes_[p].definition, &exact_plane(p)}; };
  const auto& [a, b, c] = v.planes;
  const Quadruple<ExactReal> m = v.line != no_input ? line_meet<ExactReal>(inputs_[v.line], numbers(c))
                                                    : meet<ExactReal>(numbers(a), numbers(b), numbers(c));
  const ExactReal key = v.direction ? ExactReal(-value(exact_plane(downward), m)) : m[3];
  return exact_sign(key) < 0 ? negated(m) : m;
}

const Quadruple<ExactReal>& ExactSpace::exact_vertex(VertexId vertex) const {
  const auto entry = exact_vertices_.find(vertex);
  if (entry != exact_vertices_.end()) return entry->second;
  return exact_vertices_.emplace(vertex, constructed(vertex)).first->second;
}

/// True if the plane is known by name to go through the vertex.
bool ExactSpace::goes_through(PlaneId plane, VertexId vertex) const {
  const VertexDefinition& v = vertices_[vertex].definition;
  const PlaneDefinition& p = planes_[plane].definition;
  if (v.middle) return false;
  if (v.input == no_input && std::find(v.planes.begin(), v.planes.end(), plane) != v.planes.end()) return true;
  if (p.kind != PlaneKind::points && p.kind != PlaneKind::points_direction) return false;
  if (v.line != no_input) return has_point(p, inputs_[v.line].first) && has_point(p, inputs_[v.line].second);
  if (v.input == no_input) return false;
  const InputVertex& input = inputs_[v.input];
  if (input.kind == InputVertex::Kind::point) return has_point(p, input.first);
  return input.kind == InputVertex::Kind::vector && p.kind == PlaneKind::points_direction && p.points[2] == input.first;
}

Interval ExactSpace::height(PlaneId plane, const Point3& point, int scale) const {
  const InputVertex input{InputVertex::Kind::point, point, {}};
  ExactReal height = value(exact_plane(plane), input_coordinates<ExactReal>(input));
  for (int i = 0; i < scale; ++i) height = height * ExactReal(0x1p1000);
  for (int i = 0; i > scale; --i) height = height * ExactReal(0x1p-1000);
  return enclosing(height);
}

/// The value of a plane at a point.
Interval ExactSpace::approximate_height(const Plane& plane, const Quadruple<Interval>& point) {
  const PlaneDefinition& p = plane.definition;
  if (p.kind != PlaneKind::axis) return value(plane.approximate, point);
  const Interval beyond = point[p.axis] - p.bound * point[3];
  return p.sign > 0 ? beyond : -beyond;
}

int ExactSpace::side(PlaneId plane, VertexId vertex) const {
  const Plane& p = planes_[plane];
  if (p.reverse_of) return -side(*p.reverse_of, vertex);
  const Interval height = approximate_height(p, vertices_[vertex].approximate);
  if (const std::optional<int> sign = certain_sign(height)) return *sign;
  if (goes_through(plane, vertex)) return 0;
  const auto [entry, is_new] = exact_sides_.try_emplace(std::uint64_t{plane} << 32 | vertex, 0);
  if (is_new) entry->second = exact_sign(value(exact_plane(plane), exact_vertex(vertex)));
  return entry->second;
}

int ExactSpace::compare(VertexId a, VertexId b) const {
  if (a == b) return 0;
  const Vertex& p = vertices_[a];
  const Vertex& q = vertices_[b];
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval difference = p.approximate[i] * q.approximate[3] - q.approximate[i] * p.approximate[3];
    std::optional<int> sign = certain_sign(difference);
    if (!sign) {
      const Quadruple<ExactReal>& x = exact_vertex(a);
      const Quadruple<ExactReal>& y = exact_vertex(b);
      sign = exact_sign(x[i] * y[3] - y[i] * x[3]);
    }
    if (*sign != 0) return *sign;
  }
  return 0;
}

int ExactSpace::turn(PlaneId plane, VertexId a, VertexId b, VertexId c) const {
  const Quadruple<Interval>& normal = planes_[plane].approximate;
  const auto size = [&](std::size_t i) { return std::min(std::abs(normal[i].inf()), std::abs(normal[i].sup())); };
  std::size_t axis = size(0) >= size(1) ? 0 : 1;
  if (size(2) > size(axis)) axis = 2;
  std::optional<int> facing = certain_sign(normal[axis]);
  if (!facing || *facing == 0) {
    const Quadruple<ExactReal>& exact = exact_plane(plane);
    while (exact_sign(exact[axis]) == 0) axis = (axis + 1) % 3;
    facing = exact_sign(exact[axis]);
  }
  const std::optional<int> sign =
      certain_sign(projected_turn(axis, vertices_[a].approximate, vertices_[b].approximate, vertices_[c].approximate));
  if (sign) return *facing * *sign;
  return *facing * exact_sign(projected_turn(axis, exact_vertex(a), exact_vertex(b), exact_vertex(c)));
}

}  // namespace gnomon
