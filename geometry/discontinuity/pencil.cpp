#include "geometry/discontinuity/pencil.h"

#include <algorithm>
#include <cmath>

// Notation. v: the apex; a, b: the ends of the edge; [p, q, r, s]: the bracket of event_point.h. A node is the point
// x v + y a + z b of the plane, x, y, z up to one positive factor. A function is linear in (x, y, z), given by its
// values at v, a and b; so its sign at a node is that of a sum of three products, by intervals or, where these do not
// tell, by exact numbers that are kept.
//
// Why it holds. Coordinates of a point p of the plane are the areas of (p, a, b), (v, p, b) and (v, a, p), by Cramer's
// rule, seen along an axis that the plane does not hold; axis_sign_ makes that of (v, a, b) positive. Where a segment
// crosses the plane, the mean of its ends is taken whose bracket with v, a, b vanishes (crossing_coordinates).
//   clip   polygons are convex: all of one lies inside if all nodes do, and nothing strictly inside if none does; else
//          the cuts replace what is outside, each a mean of two nodes with positive weights.
//   order  of two lines through v and nodes p and q, q comes after p, turning from a to b, if y_p z_q - z_p y_q > 0. A
//          node in the other cone stands for the point opposite, so the sign changes.
//   range  the polygon is convex and lies in one cone, so the lines that meet it are all those from the first to the
//          last of its nodes; v itself is on every line and names none. One line alone is no range: it has no width.

namespace gnomon::event {
namespace {

/// Twice the area of a triangle seen along an axis, up to the points' factors.
template <class Number>
Number flat_area(const EventPoint& p, const EventPoint& q, const EventPoint& r, std::uint32_t axis) {
  const std::uint32_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  using enum EventPoint::Kind;
  if (p.kind == input && q.kind == input && r.kind == input) {
    const std::array<double, 3> a{p.input.x, p.input.y, p.input.z}, b{q.input.x, q.input.y, q.input.z},
        c{r.input.x, r.input.y, r.input.z};
    return (Number(b[i]) - Number(a[i])) * (Number(c[j]) - Number(a[j])) -
           (Number(b[j]) - Number(a[j])) * (Number(c[i]) - Number(a[i]));
  }
  const Quadruple<Number> a = coordinates<Number>(p), b = coordinates<Number>(q), c = coordinates<Number>(r);
  return a[3] * (b[i] * c[j] - b[j] * c[i]) - b[3] * (a[i] * c[j] - a[j] * c[i]) + c[3] * (a[i] * b[j] - a[j] * b[i]);
}

}  // namespace

Pencil::Pencil(std::span<const EventPoint> points, PointId apex, PointId a, PointId b)
    : points_(points), ids_{apex, a, b} {
  nodes_.reserve(64);
  functions_.reserve(16);
  choose_axis();
  for (std::size_t k = 0; k < 3; ++k) {
    functions_.emplace_back();
    functions_.back().values[k] = 1;
  }
  Node end;
  end.first = a;
  end.y = 1;
  add(end);
  end.first = b;
  end.y = 0;
  end.z = 1;
  add(end);
}

void Pencil::choose_axis() {
  const EventPoint &v = points_[ids_[0]], &a = points_[ids_[1]], &b = points_[ids_[2]];
  double largest = -1;
  for (std::uint32_t k = 0; k < 3; ++k) {
    normal_[k] = flat_area<Interval>(v, a, b, k);
    const double size = std::fabs(normal_[k].inf() + normal_[k].sup());
    const auto known = certain_sign(normal_[k]);
    if (!known || *known == 0 || size <= largest) continue;
    largest = size;
    axis_ = k;
    axis_sign_ = *known;
  }
  for (std::uint32_t k = 0; k < 3 && axis_ == 3; ++k) {
    const int exact = static_cast<int>(CGAL::sign(flat_area<ExactReal>(v, a, b, k)));
    if (exact == 0) continue;
    axis_ = k;
    axis_sign_ = exact;
  }
}

int Pencil::side(PointId point) const {
  if (point == ids_[0] || point == ids_[1] || point == ids_[2]) return 0;
  const EventPoint &v = points_[ids_[0]], &a = points_[ids_[1]], &b = points_[ids_[2]], &p = points_[point];
  using enum EventPoint::Kind;
  if (p.kind != input || a.kind != input) return orientation(v, a, b, p);
  const Interval value = normal_[0] * (Interval(p.input.x) - Interval(a.input.x)) +
                         normal_[1] * (Interval(p.input.y) - Interval(a.input.y)) +
                         normal_[2] * (Interval(p.input.z) - Interval(a.input.z));
  if (const auto known = certain_sign(value)) return *known;
  return static_cast<int>(CGAL::sign(bracket<ExactReal>(v, a, b, p)));
}

FunctionId Pencil::add_plane(const std::array<PointId, 3>& plane, int sign) {
  Function function;
  function.plane = plane;
  function.sign = sign;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::find(plane.begin(), plane.end(), ids_[k]) != plane.end()) continue;
    function.values[k] =
        Interval(sign) * bracket<Interval>(points_[plane[0]], points_[plane[1]], points_[plane[2]], points_[ids_[k]]);
  }
  functions_.push_back(function);
  return static_cast<FunctionId>(functions_.size() - 1);
}

std::array<ExactReal, 3> Pencil::exact_values(FunctionId id) const {
  if (id < 3) return {ExactReal(id == 0 ? 1 : 0), ExactReal(id == 1 ? 1 : 0), ExactReal(id == 2 ? 1 : 0)};
  const Function& f = functions_[id];
  std::array<ExactReal, 3> values;
  for (std::size_t k = 0; k < 3; ++k) {
    values[k] = bracket<ExactReal>(points_[f.plane[0]], points_[f.plane[1]], points_[f.plane[2]], points_[ids_[k]]);
    if (f.sign < 0) values[k] = -values[k];
  }
  return values;
}

template <class Number>
std::array<Number, 3> Pencil::point_coordinates(PointId point) const {
  const EventPoint &v = points_[ids_[0]], &a = points_[ids_[1]], &b = points_[ids_[2]], &p = points_[point];
  const Number sense(axis_sign_);
  return {sense * flat_area<Number>(p, a, b, axis_), sense * flat_area<Number>(v, p, b, axis_),
          sense * flat_area<Number>(v, a, p, axis_)};
}

template <class Number>
std::array<Number, 3> Pencil::crossing_coordinates(PointId above, PointId below) const {
  // [v,a,b,c] d - [v,a,b,d] c = -[a,b,c,d] v + [v,b,c,d] a - [v,a,c,d] b
  const EventPoint &v = points_[ids_[0]], &a = points_[ids_[1]], &b = points_[ids_[2]];
  const EventPoint &c = points_[above], &d = points_[below];
  return {-bracket<Number>(a, b, c, d), bracket<Number>(v, b, c, d), -bracket<Number>(v, a, c, d)};
}

NodeId Pencil::add(const Node& node) {
  nodes_.push_back(node);
  return static_cast<NodeId>(nodes_.size() - 1);
}

NodeId Pencil::add_point(PointId point) {
  if (point == ids_[1]) return end_a;
  if (point == ids_[2]) return end_b;
  Node node;
  node.first = point;
  if (point == ids_[0]) {
    node.x = 1;
    return add(node);
  }
  const auto c = point_coordinates<Interval>(point);
  node.x = c[0];
  node.y = c[1];
  node.z = c[2];
  return add(node);
}

NodeId Pencil::add_crossing(PointId above, PointId below) {
  Node node;
  node.kind = Node::Kind::crossing;
  node.first = above;
  node.second = below;
  const auto c = crossing_coordinates<Interval>(above, below);
  node.x = c[0];
  node.y = c[1];
  node.z = c[2];
  return add(node);
}

const std::array<ExactReal, 3>& Pencil::exact_function(FunctionId id) const {
  const auto [found, is_new] = exact_functions_.try_emplace(id);
  if (is_new) found->second = exact_values(id);
  return found->second;
}

const std::array<ExactReal, 3>& Pencil::exact(NodeId id) const {
  const auto found = exact_nodes_.find(id);
  if (found != exact_nodes_.end()) return found->second;
  return exact_nodes_.emplace(id, exact_coordinates(nodes_[id])).first->second;
}

std::array<ExactReal, 3> Pencil::exact_coordinates(const Node& node) const {
  if (node.kind == Node::Kind::crossing) return crossing_coordinates<ExactReal>(node.first, node.second);
  if (node.kind == Node::Kind::point) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (node.first == ids_[k])
        return {ExactReal(k == 0 ? 1 : 0), ExactReal(k == 1 ? 1 : 0), ExactReal(k == 2 ? 1 : 0)};
    }
    return point_coordinates<ExactReal>(node.first);
  }
  const auto &f = exact_function(node.function), &p = exact(node.first), &q = exact(node.second);
  const ExactReal at_p = f[0] * p[0] + f[1] * p[1] + f[2] * p[2], at_q = f[0] * q[0] + f[1] * q[1] + f[2] * q[2];
  const bool falls = CGAL::sign(at_p) == CGAL::POSITIVE;
  const ExactReal up = falls ? at_p : -at_p, down = falls ? -at_q : at_q;
  return {up * q[0] + down * p[0], up * q[1] + down * p[1], up * q[2] + down * p[2]};
}

bool Pencil::is_known_zero(const Function& function, const Node& node) const {
  const auto holds = [&](PointId p) {
    const auto& [a, b, c] = function.plane;
    if (p == a || p == b || p == c) return true;
    return certain_sign(bracket<Interval>(points_[a], points_[b], points_[c], points_[p])) == 0;
  };
  return node.kind == Node::Kind::point ? holds(node.first)
                                        : node.kind == Node::Kind::crossing && holds(node.first) && holds(node.second);
}

int Pencil::sign(FunctionId id, NodeId node) const {
  const Node& n = nodes_[node];
  if (n.kind == Node::Kind::cut && n.function == id) return 0;
  const Function& f = functions_[id];
  const Interval value = id == x   ? n.x
                         : id == y ? n.y
                         : id == z ? n.z
                                   : f.values[0] * n.x + f.values[1] * n.y + f.values[2] * n.z;
  if (const auto known = certain_sign(value)) return *known;
  if (id > z && is_known_zero(f, n)) return 0;
  const auto& e = exact(node);
  if (id <= z) return static_cast<int>(CGAL::sign(e[id]));
  const auto& g = exact_function(id);
  return static_cast<int>(CGAL::sign(g[0] * e[0] + g[1] * e[1] + g[2] * e[2]));
}

bool Pencil::clip(std::vector<NodeId>& polygon, FunctionId function, int sense) {
  const std::size_t n = polygon.size();
  std::vector<int> signs(n);
  bool all = true, some = false;
  for (std::size_t i = 0; i < n; ++i) {
    signs[i] = sense * sign(function, polygon[i]);
    all = all && signs[i] >= 0;
    some = some || signs[i] > 0;
  }
  if (all || !some) return some;
  std::vector<NodeId> kept;
  kept.reserve(n + 2);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    if (signs[i] >= 0) kept.push_back(polygon[i]);
    if (signs[i] * signs[j] >= 0) continue;
    // A segment's two sides are the same.
    if (n == 2 && i == 1) continue;
    const Node p = nodes_[polygon[i]], q = nodes_[polygon[j]];
    const Function& f = functions_[function];
    // Both values as absolute ones: the cut is a mean with positive weights.
    const Interval sense_at_p(signs[i] * sense);
    const Interval at_p = sense_at_p * (f.values[0] * p.x + f.values[1] * p.y + f.values[2] * p.z);
    const Interval at_q = -sense_at_p * (f.values[0] * q.x + f.values[1] * q.y + f.values[2] * q.z);
    Node cut;
    cut.kind = Node::Kind::cut;
    cut.first = polygon[i];
    cut.second = polygon[j];
    cut.function = function;
    cut.x = at_p * q.x + at_q * p.x;
    cut.y = at_p * q.y + at_q * p.y;
    cut.z = at_p * q.z + at_q * p.z;
    // Known exactly, so that cuts on one line through the apex are known to lie on one line.
    if (function == x) cut.x = 0;
    if (function == y) cut.y = 0;
    if (function == z) cut.z = 0;
    kept.push_back(add(cut));
  }
  polygon.swap(kept);
  return true;
}

int Pencil::order(const Ray& first, const Ray& second) const {
  if (first.node == second.node) return 0;
  const Node &p = nodes_[first.node], &q = nodes_[second.node];
  const int sense = static_cast<int>(first.cone) * static_cast<int>(second.cone);
  if (const auto known = certain_sign(p.y * q.z - p.z * q.y)) return sense * *known;
  if (p.kind == q.kind && p.kind != Node::Kind::cut &&
      ((p.first == q.first && p.second == q.second) || (p.first == q.second && p.second == q.first))) {
    return 0;
  }
  const auto &e = exact(first.node), &g = exact(second.node);
  return sense * static_cast<int>(CGAL::sign(e[1] * g[2] - e[2] * g[1]));
}

std::optional<RayRange> Pencil::range(std::span<const NodeId> polygon, Cone cone) const {
  std::optional<RayRange> result;
  for (const NodeId node : polygon) {
    const Node& n = nodes_[node];
    if (!certain_sign(n.y).value_or(0) && !certain_sign(n.z).value_or(0) && is_apex(node)) continue;
    const Ray ray{node, cone};
    if (!result) {
      result = RayRange{ray, ray};
    } else if (order(ray, result->first) > 0) {
      result->first = ray;
    } else if (order(result->last, ray) > 0) {
      result->last = ray;
    }
  }
  if (!result || order(result->first, result->last) <= 0) return std::nullopt;
  return result;
}

}  // namespace gnomon::event
