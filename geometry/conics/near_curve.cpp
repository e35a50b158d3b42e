#include "geometry/conics/near_curve.h"

#include <algorithm>
#include <span>

namespace gnomon::conic {

Interval enclosure(const Rational& x) {
  const auto [low, high] = CGAL::to_interval(x);
  return {low, high};
}

Interval enclosure(const Range& range) {
  return {CGAL::to_interval(range.from).first, CGAL::to_interval(range.to).second};
}

NearCurve::NearCurve(const FlatCurve& curve) {
  long most = 0, most_of_form = 0;
  for (const Coefficients& c : curve.point) {
    for (const Integer& x : c) most = std::max(most, exponent_of(x));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Coefficients& c = curve.point[k];
    for (std::size_t i = 0; i < 3; ++i) point[k][i] = i < c.size() ? scaled(c[i], most) : Interval(0);
  }
  for (const Integer& c : curve.form) most_of_form = std::max(most_of_form, exponent_of(c));
  if (curve.is_straight) {
    // As a quadratic form it is the line times w.
    form = {scaled(curve.form[0], most_of_form),
            scaled(curve.form[1], most_of_form),
            scaled(curve.form[2], most_of_form),
            Interval(0),
            Interval(0),
            Interval(0)};
    return;
  }
  for (std::size_t k = 0; k < 6; ++k) form[k] = scaled(curve.form[k], most_of_form);
}

namespace {

/// The Bezier points between two parameters.
std::array<std::array<Interval, 3>, 3> bezier_points(const NearCurve& curve, const Interval& from, const Interval& to) {
  std::array<std::array<Interval, 3>, 3> points;
  const Interval half_sum = (from + to) / Interval(2), product = from * to;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& c = curve.point[k];
    points[0][k] = c[0] + from * (c[1] + from * c[2]);
    points[1][k] = c[0] + half_sum * c[1] + product * c[2];
    points[2][k] = c[0] + to * (c[1] + to * c[2]);
  }
  return points;
}

/// The polar form of a quadratic form.
Interval polar(const std::array<Interval, 6>& f, const std::array<Interval, 3>& p, const std::array<Interval, 3>& q) {
  const Interval half(0.5);
  return f[0] * p[0] * q[0] + f[3] * p[1] * q[1] + f[5] * p[2] * q[2] +
         half * (f[1] * (p[0] * q[1] + p[1] * q[0]) + f[2] * (p[0] * q[2] + p[2] * q[0]) +
                 f[4] * (p[1] * q[2] + p[2] * q[1]));
}

}  // namespace

bool certainly_avoids(const NearCurve& curve, const NearCurve& other, const Interval& from, const Interval& to) {
  const auto h = bezier_points(other, from, to);
  const auto& f = curve.form;
  // Bernstein coefficients of degree 4.
  const Interval b[] = {polar(f, h[0], h[0]), polar(f, h[0], h[1]),
                        (polar(f, h[0], h[2]) + Interval(2) * polar(f, h[1], h[1])) / Interval(3), polar(f, h[1], h[2]),
                        polar(f, h[2], h[2])};
  return std::all_of(std::begin(b), std::end(b), [](const Interval& x) { return x.inf() > 0; }) ||
         std::all_of(std::begin(b), std::end(b), [](const Interval& x) { return x.sup() < 0; });
}

std::array<Interval, 3> form_on_line(const NearCurve& curve, const NearPoint& p, const NearPoint& d) {
  const auto& f = curve.form;
  const Interval along_x = f[1] + Interval(2) * f[3] * p.x + f[4] * p.y;
  const Interval along_y = f[2] + f[4] * p.x + Interval(2) * f[5] * p.y;
  return {f[0] + f[1] * p.x + f[2] * p.y + f[3] * p.x * p.x + f[4] * p.x * p.y + f[5] * p.y * p.y,
          along_x * d.x + along_y * d.y, f[3] * d.x * d.x + f[4] * d.x * d.y + f[5] * d.y * d.y};
}

}  // namespace gnomon::conic
