#include "geometry/discontinuity/receiver_plane.h"

#include <CGAL/Gmpz.h>

#include <utility>

#include "geometry/numbers/rounding.h"

namespace gnomon::event {
namespace {

/// CGAL 5.5 loses the sign of a negative integer on the way, and does not know zero.
ExactReal exact_real(const Integer& integer) {
  if (integer == 0) return ExactReal(0);
  const Integer size = abs(integer);
  const ExactReal result(CGAL::Gmpz(size.backend().data()));
  return integer.sign() < 0 ? -result : result;
}

}  // namespace

const Rational& coordinate(const ExactVector& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

ExactVector affine(const Quadruple<ExactReal>& point) {
  const Rational w = rational(point[3]);
  return {rational(point[0]) / w, rational(point[1]) / w, rational(point[2]) / w};
}

ExactVector exact_place(const EventPoint& point) {
  return point.exact ? affine(*point.exact) : exact(point.input);
}

EventPoint constructed_point(const ExactVector& p) {
  const auto [x, y, z, w] = whole_coordinates(p);
  EventPoint point;
  point.kind = EventPoint::Kind::constructed;
  point.input = {nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)};
  point.exact = {exact_real(x), exact_real(y), exact_real(z), exact_real(w)};
  return point;
}

ReceiverPlane::ReceiverPlane(const Point3& p, const Point3& q, const Point3& r)
    : plane_(plane_through(exact(p), exact(q), exact(r))) {
  const auto size = [&](std::size_t k) -> Rational { return abs(coordinate(plane_.normal, k)); };
  for (const std::size_t k : {0U, 1U}) {
    if (size(k) > size(dropped_)) dropped_ = k;
  }
  u_ = (dropped_ + 1) % 3;
  v_ = (dropped_ + 2) % 3;
  if (coordinate(plane_.normal, dropped_) < 0) std::swap(u_, v_);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [low, high] = CGAL::to_interval(k < 3 ? coordinate(plane_.normal, k) : plane_.offset);
    near_[k] = Interval(low, high);
  }
}

PointEnclosure ReceiverPlane::spatial(const FlatEnclosure& point) const {
  PointEnclosure result{Interval(0), Interval(0), Interval(0)};
  result[u_] = point.x;
  result[v_] = point.y;
  result[dropped_] = -(near_[u_] * point.x + near_[v_] * point.y + near_[3]) / near_[dropped_];
  return result;
}

bool ReceiverPlane::is_certainly_off(const PointEnclosure& point) const {
  const Interval height = near_[0] * point.x + near_[1] * point.y + near_[2] * point.z + near_[3];
  return height.inf() > 0 || height.sup() < 0;
}

FlatPoint ReceiverPlane::flat(const ExactVector& point) const {
  return {coordinate(point, u_), coordinate(point, v_)};
}

FlatPoint ReceiverPlane::flat(const Quadruple<ExactReal>& point) const {
  const Rational w = rational(point[3]);
  return {rational(point[u_]) / w, rational(point[v_]) / w};
}

ExactVector ReceiverPlane::spatial(const FlatPoint& point) const {
  std::array<Rational, 3> c;
  c[u_] = point.x;
  c[v_] = point.y;
  const ExactVector without{c[0], c[1], c[2]};
  c[dropped_] = -plane_.height(without) / coordinate(plane_.normal, dropped_);
  return {c[0], c[1], c[2]};
}

Rational ReceiverPlane::squared_stretch() const {
  const Rational& n = coordinate(plane_.normal, dropped_);
  return dot(plane_.normal, plane_.normal) / (n * n);
}

bool clip(FlatSegment& segment, std::span<const FlatPoint> polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const FlatPoint &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const auto height = [&](const FlatPoint& p) -> Rational {
      return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    const Rational at_start = height(segment.start), at_end = height(segment.end);
    if (at_start <= 0 && at_end <= 0 && (at_start < 0 || at_end < 0)) return false;
    if (at_start >= 0 && at_end >= 0) continue;
    const Rational share = at_start / (at_start - at_end);
    const FlatPoint cut{segment.start.x + share * (segment.end.x - segment.start.x),
                        segment.start.y + share * (segment.end.y - segment.start.y)};
    (at_start < 0 ? segment.start : segment.end) = cut;
  }
  return !(segment.start == segment.end);
}

}  // namespace gnomon::event
