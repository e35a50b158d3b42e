#include "geometry/discontinuity/ruled_lines.h"

#include <algorithm>

#include "geometry/conics/near_curve.h"

// p is (w, P), q is (v, Q). Where t is the share of the base, Q = (1 - t) a + t b, and p is where the traces of the
// planes through q and either other edge cross: their product, of degree 2. On a straight line p is of degree 1, and
// the values s and e at p of the traces of `parting` with a and with b tell the share s / (s - e), so that Q = s b - e
// a. The line through both has the direction w Q - v P and the moment P x Q, of degree 3.

namespace gnomon::event {
namespace {

NearPolynomial nothing() {
  return {Interval(0), Interval(0), Interval(0), Interval(0)};
}

/// Of a path and a fixed vector.
template <class Path>
NearPolynomial dots(const Path& path, const PointEnclosure& v) {
  return {dot(path[0], v), dot(path[1], v), dot(path[2], v), dot(path[3], v)};
}

NearPolynomial scaled(const NearPolynomial& f, const Interval& s) {
  return {f[0] * s, f[1] * s, f[2] * s, f[3] * s};
}

NearPolynomial sum(const NearPolynomial& f, const NearPolynomial& g) {
  return {f[0] + g[0], f[1] + g[1], f[2] + g[2], f[3] + g[3]};
}

/// The trace of the plane through a point and an edge, as a function of (w, x, y).
std::array<Interval, 3> near_trace(const PointEnclosure& l, const SilhouetteEdge& edge, const NearFrame& frame) {
  const PointEnclosure normal = cross(edge.a.near - l, edge.b.near - l);
  return {dot(normal, frame.origin - l), dot(normal, frame.along_x), dot(normal, frame.along_y)};
}

}  // namespace

int certain_sign(const NearPolynomial& f, const Interval& from, const Interval& to) {
  const Interval a = f[1] / Interval(3), b = f[2] / Interval(3);
  const Interval mixed = from * to, from2 = from * from, to2 = to * to;
  const std::array<Interval, 4> bernstein{
      f[0] + from * (f[1] + from * (f[2] + from * f[3])),
      f[0] + (from + from + to) * a + (from2 + mixed + mixed) * b + from2 * to * f[3],
      f[0] + (from + to + to) * a + (to2 + mixed + mixed) * b + from * to2 * f[3],
      f[0] + to * (f[1] + to * (f[2] + to * f[3])),
  };
  if (std::all_of(bernstein.begin(), bernstein.end(), [](const Interval& c) { return c.inf() > 0; })) return 1;
  if (std::all_of(bernstein.begin(), bernstein.end(), [](const Interval& c) { return c.sup() < 0; })) return -1;
  return 0;
}

NearPolynomial product(const NearPolynomial& f, const NearPolynomial& g) {
  NearPolynomial result = nothing();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; i + j < 4; ++j) result[i + j] += f[i] * g[j];
  }
  return result;
}

NearPolynomial difference(const NearPolynomial& f, const NearPolynomial& g) {
  return {f[0] - g[0], f[1] - g[1], f[2] - g[2], f[3] - g[3]};
}

NearFrame::NearFrame(const ReceiverPlane& plane) {
  const ExactVector o = plane.spatial(FlatPoint{0, 0});
  origin = Place(o).near;
  along_x = Place(plane.spatial(FlatPoint{1, 0}) - o).near;
  along_y = Place(plane.spatial(FlatPoint{0, 1}) - o).near;
}

RuledLines::RuledLines(const std::array<const SilhouetteEdge*, 3>& edges, const NearFrame& frame)
    : edges_(edges), is_share_of_base_(true) {
  const Interval zero(0), one(1);
  const PointEnclosure &a = edges[0]->a.near, &b = edges[0]->b.near;
  const auto j0 = near_trace(a, *edges[1], frame), j1 = near_trace(b, *edges[1], frame);
  const auto k0 = near_trace(a, *edges[2], frame), k1 = near_trace(b, *edges[2], frame);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
    const auto cross_of = [&](const auto& f, const auto& g) { return f[d] * g[e] - f[e] * g[d]; };
    // By Bernstein coefficients, the middle one twice.
    const Interval start = cross_of(j0, k0), end = cross_of(j1, k1), middle = cross_of(j0, k1) + cross_of(j1, k0);
    flat_[c] = {start, middle - start - start, start - middle + end, zero};
  }
  base_ends_ = {NearPolynomial{zero, one, zero, zero}, NearPolynomial{-one, one, zero, zero}};
  find_lines(frame);
}

RuledLines::RuledLines(const std::array<const SilhouetteEdge*, 3>& edges, const SilhouetteEdge& parting,
                       const conic::FlatCurve& line, const NearFrame& frame)
    : edges_(edges), is_share_of_base_(false) {
  const conic::NearCurve near(line);
  for (std::size_t c = 0; c < 3; ++c) flat_[c] = {near.point[c][0], near.point[c][1], Interval(0), Interval(0)};
  const PointEnclosure* ends[] = {&edges[0]->a.near, &edges[0]->b.near};
  for (std::size_t end = 0; end < 2; ++end) {
    const auto line_of_end = near_trace(*ends[end], parting, frame);
    base_ends_[end] = nothing();
    for (std::size_t c = 0; c < 3; ++c) base_ends_[end] = sum(base_ends_[end], scaled(flat_[c], line_of_end[c]));
  }
  find_lines(frame);
}

void RuledLines::find_lines(const NearFrame& frame) {
  base_weight_ = difference(base_ends_[0], base_ends_[1]);
  const PointEnclosure &a = edges_[0]->a.near, &b = edges_[0]->b.near;
  const PointEnclosure null{Interval(0), Interval(0), Interval(0)};
  for (std::size_t i = 0; i < 4; ++i) {
    point_[i] = flat_[0][i] * frame.origin + flat_[1][i] * frame.along_x + flat_[2][i] * frame.along_y;
    base_[i] = base_ends_[0][i] * b - base_ends_[1][i] * a;
    direction_[i] = moment_[i] = null;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      direction_[i + j] = direction_[i + j] + flat_[0][i] * base_[j] - base_weight_[j] * point_[i];
      moment_[i + j] = moment_[i + j] + cross(point_[i], base_[j]);
    }
  }
}

std::optional<FlatEnclosure> RuledLines::points(const Interval& t) const {
  // Around the middle, where powers of what is left are small.
  const Interval m((t.inf() + t.sup()) / 2), s = t - m;
  std::array<Interval, 3> h;
  for (std::size_t k = 0; k < 3; ++k) {
    const NearPolynomial& c = flat_[k];
    h[k] = c[0] + m * (c[1] + m * c[2]) + s * (c[1] + Interval(2) * m * c[2]) + s * s * c[2];
  }
  if (h[0].inf() <= 0 && h[0].sup() >= 0) return std::nullopt;
  return FlatEnclosure{h[1] / h[0], h[2] / h[0]};
}

NearPolynomial RuledLines::side(const NearLine& line) const {
  return sum(dots(direction_, line.moment), dots(moment_, line.direction));
}

NearPolynomial RuledLines::height_of_point(const NearPlane& plane) const {
  return sum(dots(point_, plane.normal), scaled(flat_[0], plane.offset));
}

NearPolynomial RuledLines::height_of_base(const NearPlane& plane) const {
  return sum(dots(base_, plane.normal), scaled(base_weight_, plane.offset));
}

/// With n = a x b - p x (b - a), the normal of the plane through p and the edge, that is n (b' - a').
NearPolynomial RuledLines::crossing(const NearLine& edge, const NearLine& other) const {
  return difference(scaled(flat_[0], dot(edge.moment, other.direction)),
                    dots(point_, cross(edge.direction, other.direction)));
}

}  // namespace gnomon::event
