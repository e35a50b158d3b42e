#include "geometry/discontinuity/event_point.h"

namespace gnomon::event {
namespace {

template <class Number>
using Triple = Vector3<Number>;

template <class Number>
Triple<Number> difference(const Point3& a, const Point3& b) {
  return {Number(a.x) - Number(b.x), Number(a.y) - Number(b.y), Number(a.z) - Number(b.z)};
}

template <class Number>
Triple<Number> vector(const Point3& a) {
  return {Number(a.x), Number(a.y), Number(a.z)};
}

template <class Number>
Number determinant(const Triple<Number>& a, const Triple<Number>& b, const Triple<Number>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

template <class Number>
Number minor(const Quadruple<Number>& a, const Quadruple<Number>& b, const Quadruple<Number>& c, std::size_t i,
             std::size_t j, std::size_t k) {
  return determinant<Number>({a[i], a[j], a[k]}, {b[i], b[j], b[k]}, {c[i], c[j], c[k]});
}

/// Minus the determinant of four rows: the same sign and, for points with w = 1, the same value as with differences.
template <class Number>
Number homogeneous_bracket(const Quadruple<Number>& v, const Quadruple<Number>& a, const Quadruple<Number>& b,
                           const Quadruple<Number>& c) {
  return v[3] * minor(a, b, c, 0, 1, 2) - a[3] * minor(v, b, c, 0, 1, 2) + b[3] * minor(v, a, c, 0, 1, 2) -
         c[3] * minor(v, a, b, 0, 1, 2);
}

}  // namespace

template <>
Quadruple<ExactReal> coordinates(const EventPoint& point) {
  if (point.exact) return *point.exact;
  const Point3& p = point.input;
  return {ExactReal(p.x), ExactReal(p.y), ExactReal(p.z), ExactReal(point.kind == EventPoint::Kind::direction ? 0 : 1)};
}

template <>
Quadruple<Interval> coordinates(const EventPoint& point) {
  if (point.exact) {
    const Quadruple<ExactReal>& e = *point.exact;
    return {enclosure(e[0]), enclosure(e[1]), enclosure(e[2]), enclosure(e[3])};
  }
  const Point3& p = point.input;
  return {Interval(p.x), Interval(p.y), Interval(p.z), Interval(point.kind == EventPoint::Kind::direction ? 0 : 1)};
}

template <class Number>
Number bracket(const EventPoint& v, const EventPoint& a, const EventPoint& b, const EventPoint& c) {
  using enum EventPoint::Kind;
  if (a.kind == input && b.kind == input) {
    if (v.kind == input && c.kind == input) {
      return determinant<Number>(difference<Number>(a.input, v.input), difference<Number>(b.input, v.input),
                                 difference<Number>(c.input, v.input));
    }
    if (v.kind == direction && c.kind == input) {
      return -determinant<Number>(vector<Number>(v.input), difference<Number>(b.input, a.input),
                                  difference<Number>(c.input, a.input));
    }
    if (v.kind == input && c.kind == direction) {
      return determinant<Number>(difference<Number>(a.input, v.input), difference<Number>(b.input, v.input),
                                 vector<Number>(c.input));
    }
  }
  return homogeneous_bracket<Number>(coordinates<Number>(v), coordinates<Number>(a), coordinates<Number>(b),
                                     coordinates<Number>(c));
}

template Interval bracket<Interval>(const EventPoint&, const EventPoint&, const EventPoint&, const EventPoint&);
template ExactReal bracket<ExactReal>(const EventPoint&, const EventPoint&, const EventPoint&, const EventPoint&);

int orientation(const EventPoint& v, const EventPoint& a, const EventPoint& b, const EventPoint& c) {
  if (const auto sign = certain_sign(bracket<Interval>(v, a, b, c))) return *sign;
  return static_cast<int>(CGAL::sign(bracket<ExactReal>(v, a, b, c)));
}

}  // namespace gnomon::event
