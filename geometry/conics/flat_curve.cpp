#include "geometry/conics/flat_curve.h"

#include <algorithm>
#include <utility>

namespace gnomon::conic {
namespace {

Integer common_denominator(std::span<const Rational> numbers) {
  Integer common = 1;
  for (const Rational& x : numbers) common = lcm(common, denominator(x));
  return common;
}

Integer times(const Rational& x, const Integer& factor) {
  return numerator(x) * (factor / denominator(x));
}

void make_primitive(std::span<Integer> numbers) {
  Integer common = 0;
  for (const Integer& x : numbers) common = gcd(common, x);
  if (common <= 1) return;
  for (Integer& x : numbers) x /= common;
}

Covector cross(const Covector& a, const Covector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Coefficients trimmed(Coefficients p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

/// Exact quotient of integer polynomials. Requires: `by` divides, and is primitive.
Coefficients divided(Coefficients rest, const Coefficients& by) {
  if (rest.size() < by.size()) return {};
  Coefficients result(rest.size() - by.size() + 1);
  for (std::size_t shift = result.size(); shift-- > 0;) {
    result[shift] = rest[shift + by.size() - 1] / by.back();
    for (std::size_t k = 0; k < by.size(); ++k) rest[k + shift] -= result[shift] * by[k];
  }
  return result;
}

/// Takes out what all three have in common.
void reduce(std::array<Coefficients, 3>& point) {
  Integer content = 0;
  Polynomial common;
  for (Coefficients& c : point) {
    c = trimmed(std::move(c));
    for (const Integer& x : c) content = gcd(content, x);
    if (c.empty()) continue;
    common = common.is_zero() ? Polynomial(c) : greatest_common_divisor(common, Polynomial(c));
  }
  if (common.is_zero()) return;
  for (Coefficients& c : point) {
    for (Integer& x : c) x /= content;
    if (common.degree() > 0) c = divided(std::move(c), common.coefficients());
  }
}

std::size_t degree_of(const std::array<Coefficients, 3>& point) {
  std::size_t size = 0;
  for (const Coefficients& c : point) size = std::max(size, c.size());
  return size == 0 ? 0 : size - 1;
}

Integer coefficient(const Coefficients& p, std::size_t k) {
  return k < p.size() ? p[k] : Integer(0);
}

std::array<Coefficients, 3> meeting_points(const LinePencil& j, const LinePencil& k) {
  const Covector start = cross(j.start, k.start), end = cross(j.end, k.end);
  const Covector a = cross(j.start, k.end), b = cross(j.end, k.start);
  std::array<Coefficients, 3> point;
  for (std::size_t c = 0; c < 3; ++c) {
    // (1-t)^2 start + t(1-t) (a + b) + t^2 end
    const Integer mixed = a[c] + b[c];
    point[c] = {start[c], mixed - 2 * start[c], start[c] - mixed + end[c]};
  }
  return point;
}

/// A start k end - k start j end, as a quadratic form.
std::array<Integer, 6> form_of(const LinePencil& j, const LinePencil& k) {
  std::array<Integer, 6> form{0, 0, 0, 0, 0, 0};
  const auto add = [&](const Covector& a, const Covector& b, int sign) {
    form[0] += sign * a[0] * b[0];
    form[1] += sign * (a[0] * b[1] + a[1] * b[0]);
    form[2] += sign * (a[0] * b[2] + a[2] * b[0]);
    form[3] += sign * a[1] * b[1];
    form[4] += sign * (a[1] * b[2] + a[2] * b[1]);
    form[5] += sign * a[2] * b[2];
  };
  add(j.start, k.end, 1);
  add(k.start, j.end, -1);
  make_primitive(form);
  return form;
}

/// A straight part between two values of t of points of degree 1, none of them at infinity.
void append_straight(const std::array<Coefficients, 3>& point, const Covector& line, const Rational& from,
                     const Rational& to, std::vector<FlatArc>& found) {
  FlatCurve curve = straight_curve(line);
  const bool by_x = curve.parameters.front().start[1] != 0;
  const auto place = [&](const Rational& t) {
    return Rational(homogeneous_value(point[by_x ? 1 : 2], t, 1), homogeneous_value(point[0], t, 1));
  };
  Rational a = place(from), b = place(to);
  if (a == b) return;
  if (a > b) std::swap(a, b);
  found.push_back({std::move(curve), std::move(a), std::move(b)});
}

/// From t towards a pole, to where the points lie outside of the square.
Rational far_out(const std::array<Coefficients, 3>& point, const Rational& t, const Rational& pole,
                 const Rational& half_width) {
  Rational at = t;
  const auto is_outside = [&] {
    const Integer w = homogeneous_value(point[0], at, 1);
    return std::any_of(point.begin() + 1, point.end(), [&](const Coefficients& c) {
      return abs(Rational(homogeneous_value(c, at, 1), w)) > half_width;
    });
  };
  while (!is_outside()) at = (at + pole) / 2;
  return at;
}

void append_straight(const std::array<Coefficients, 3>& point, const Range& range, const Rational& half_width,
                     std::vector<FlatArc>& found) {
  if (degree_of(point) == 0) return;
  const auto vector = [&](std::size_t k) {
    return Covector{coefficient(point[0], k), coefficient(point[1], k), coefficient(point[2], k)};
  };
  Covector line = cross(vector(0), vector(1));
  if (line[1] == 0 && line[2] == 0) return;  // at infinity
  make_primitive(line);
  const Integer w0 = coefficient(point[0], 0), w1 = coefficient(point[0], 1);
  const bool has_pole = w1 != 0 && Rational(-w0, w1) >= range.from && Rational(-w0, w1) <= range.to;
  if (!has_pole) {
    if (w0 != 0 || w1 != 0) append_straight(point, line, range.from, range.to, found);
    return;
  }
  const Rational pole(-w0, w1);
  if (range.from < pole) append_straight(point, line, range.from, far_out(point, range.from, pole, half_width), found);
  if (range.to > pole) append_straight(point, line, far_out(point, range.to, pole, half_width), range.to, found);
}

}  // namespace

LinePencil line_pencil(const std::array<Rational, 3>& start, const std::array<Rational, 3>& end) {
  std::array<Integer, 6> all;
  const Integer a = common_denominator(start), b = common_denominator(end);
  const Integer common = lcm(a, b);
  for (std::size_t k = 0; k < 3; ++k) {
    all[k] = times(start[k], common);
    all[k + 3] = times(end[k], common);
  }
  make_primitive(all);
  return {{all[0], all[1], all[2]}, {all[3], all[4], all[5]}};
}

Covector line_through(const FlatPoint& from, const FlatPoint& to) {
  const std::array<Rational, 3> line{Rational(from.x * to.y - from.y * to.x), Rational(from.y - to.y),
                                     Rational(to.x - from.x)};
  const Integer common = common_denominator(line);
  Covector result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = times(line[k], common);
  make_primitive(result);
  return result;
}

FlatCurve straight_curve(const Covector& line) {
  FlatCurve curve;
  curve.is_straight = true;
  curve.form = {line[0], line[1], line[2], 0, 0, 0};
  const bool by_x = abs(line[2]) >= abs(line[1]);
  const Integer w = abs(by_x ? line[2] : line[1]);
  const int sign = (by_x ? line[2] : line[1]) > 0 ? 1 : -1;
  const Coefficients along{Integer(0), w};
  const Coefficients other{Integer(-sign * line[0]), Integer(-sign * (by_x ? line[1] : line[2]))};
  curve.point = by_x ? std::array{Coefficients{w}, along, other} : std::array{Coefficients{w}, other, along};
  const Covector coordinate = by_x ? Covector{0, 1, 0} : Covector{0, 0, 1};
  curve.parameters = {{coordinate, {-1, coordinate[1], coordinate[2]}}};
  return curve;
}

FlatCurve with_pole(const FlatCurve& conic, const Rational& pole) {
  // The line at t is (1 - t) start + t end; with a multiple of the start in its place the ends keep their parameters.
  const Rational factor = 1 - 1 / pole;
  FlatCurve result = conic;
  for (LinePencil& pencil : result.parameters) {
    for (Integer& x : pencil.start) x *= numerator(factor);
    for (Integer& x : pencil.end) x *= denominator(factor);
  }
  result.point = meeting_points(result.parameters[0], result.parameters[1]);
  reduce(result.point);
  return result;
}

std::optional<FlatPoint> FlatCurve::at(const Rational& t) const {
  const Integer w = homogeneous_value(point[0], t, 2);
  if (w == 0) return std::nullopt;
  return FlatPoint{Rational(homogeneous_value(point[1], t, 2), w), Rational(homogeneous_value(point[2], t, 2), w)};
}

std::vector<FlatArc> arcs(const LinePencil& j, const LinePencil& k, const Range& range, const Rational& half_width) {
  std::vector<FlatArc> found;
  std::array<Coefficients, 3> point = meeting_points(j, k);
  reduce(point);
  if (degree_of(point) < 2) {
    append_straight(point, range, half_width, found);
    return found;
  }
  found.push_back({{false, std::move(point), form_of(j, k), {j, k}}, range.from, range.to});
  return found;
}

Coefficients along(const Covector& covector, const FlatCurve& curve) {
  return covector[0] * curve.point[0] + covector[1] * curve.point[1] + covector[2] * curve.point[2];
}

Polynomial form_along(const FlatCurve& curve, const FlatCurve& other) {
  const auto& [w, x, y] = other.point;
  const auto& f = curve.form;
  if (curve.is_straight) return Polynomial(f[0] * w + f[1] * x + f[2] * y);
  return Polynomial(w * (f[0] * w + f[1] * x + f[2] * y) + x * (f[3] * x + f[4] * y) + f[5] * (y * y));
}

namespace {

/// The form at a point with w = 1, and its slopes along x and y.
std::array<Rational, 3> value_and_slopes(const FlatCurve& curve, const FlatPoint& p) {
  std::array<Rational, 6> f;
  for (std::size_t k = 0; k < 6; ++k) f[k] = Rational(curve.form[k]);
  if (curve.is_straight) return {Rational(f[0] + f[1] * p.x + f[2] * p.y), f[1], f[2]};
  const Rational value = f[0] + f[1] * p.x + f[2] * p.y + f[3] * p.x * p.x + f[4] * p.x * p.y + f[5] * p.y * p.y;
  return {value, Rational(f[1] + 2 * f[3] * p.x + f[4] * p.y), Rational(f[2] + f[4] * p.x + 2 * f[5] * p.y)};
}

}  // namespace

ParameterAlong parameter_along(const LinePencil& parameter, const FlatCurve& other) {
  const Coefficients start = along(parameter.start, other);
  return {start, start - along(parameter.end, other)};
}

int side(const FlatCurve& curve, const FlatPoint& point) {
  return value_and_slopes(curve, point)[0].sign();
}

std::array<Rational, 3> form_on_line(const FlatCurve& curve, const FlatPoint& p, const FlatPoint& d) {
  const auto [value, along_x, along_y] = value_and_slopes(curve, p);
  Rational quadratic = 0;
  if (!curve.is_straight) {
    quadratic =
        Rational(curve.form[3]) * d.x * d.x + Rational(curve.form[4]) * d.x * d.y + Rational(curve.form[5]) * d.y * d.y;
  }
  return {value, Rational(along_x * d.x + along_y * d.y), quadratic};
}

FlatPoint direction(const FlatCurve& curve, const Rational& t) {
  std::array<Rational, 3> value, slope;
  for (std::size_t k = 0; k < 3; ++k) {
    const Coefficients& c = curve.point[k];
    const Rational c1(coefficient(c, 1)), c2(coefficient(c, 2));
    value[k] = Rational(coefficient(c, 0)) + t * (c1 + t * c2);
    slope[k] = c1 + 2 * t * c2;
  }
  return {Rational(slope[1] * value[0] - value[1] * slope[0]), Rational(slope[2] * value[0] - value[2] * slope[0])};
}

std::array<std::array<Rational, 3>, 3> bezier_points(const FlatCurve& curve, const Rational& from, const Rational& to) {
  std::array<std::array<Rational, 3>, 3> points;
  const Rational half_sum = (from + to) / 2, product = from * to;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational c0(coefficient(curve.point[k], 0)), c1(coefficient(curve.point[k], 1)),
        c2(coefficient(curve.point[k], 2));
    points[0][k] = c0 + from * (c1 + from * c2);
    points[1][k] = c0 + half_sum * c1 + product * c2;
    points[2][k] = c0 + to * (c1 + to * c2);
  }
  return points;
}

bool is_short(const FlatCurve& curve, const Rational& from, const Rational& to) {
  const auto points = bezier_points(curve, from, to);
  const Rational &w0 = points[0][0], &w1 = points[1][0], &w2 = points[2][0];
  return w1.sign() == w0.sign() && 16 * w1 * w1 >= w0 * w2;
}

int positive_side(const FlatCurve& curve, const Rational& t) {
  const FlatPoint way = direction(curve, t);
  const auto slopes = value_and_slopes(curve, *curve.at(t));
  return Rational(slopes[2] * way.x - slopes[1] * way.y).sign();
}

}  // namespace gnomon::conic
