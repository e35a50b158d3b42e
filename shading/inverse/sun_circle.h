#pragma once

/// The sun's circle, in doubles that carry their error and in intervals of any precision.

#include <optional>

#include "gnomon/sunlight.h"
#include "shading/reflection/bounded.h"
#include "shading/reflection/precise.h"

namespace gnomon::inverse {

/// Vectors of the frame and functions of the angles, for one kind of numbers.
template <class Number>
struct SunCircle {
  std::array<Number, 3> east, north, up;  ///< of length 1
  Number sin_latitude, cos_latitude, sin_declination, cos_declination;

  explicit SunCircle(const SunDay& day);
};

/// When the sun lies in a plane through the eye, as hour angles from -π to π: it is on the positive side from `rise` to
/// `set`, through midnight if `set` comes first. Without moments: always or never.
template <class Number>
struct SunCrossing {
  enum class Kind {
    always,
    never,
    twice,
    along,     ///< it runs in the plane all day
    undecided  ///< not with these numbers
  };
  Kind kind = Kind::undecided;
  int mean_side = 2;  ///< on which side the sun is on average: certain_sign
  Number rise, set;
};

/// A vector across a plane, as whoever made it computed it.
template <class Number>
using SunNormal = std::array<Number, 3>;

template <class Number>
Number product(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
std::array<Number, 3> crossed(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
std::array<Number, 3> numbers_of(const Point3& p) {
  return {Number(p.x), Number(p.y), Number(p.z)};
}

template <class Number>
std::array<Number, 3> between(const Point3& from, const Point3& to) {
  return {Number(to.x) - Number(from.x), Number(to.y) - Number(from.y), Number(to.z) - Number(from.z)};
}

template <class Number>
std::array<Number, 3> of_length_one(const std::array<Number, 3>& v) {
  using shading::sqrt;
  const Number length = sqrt(product(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

template <class Number>
SunCircle<Number>::SunCircle(const SunDay& day) {
  using shading::cos, shading::sin, shading::pi;
  up = of_length_one(numbers_of<Number>(day.up));
  north = of_length_one(numbers_of<Number>(day.north));
  east = crossed(north, up);
  const Number degree = pi(Number(0.0)) / Number(180.0);
  const Number latitude = Number(day.latitude) * degree, declination = Number(day.declination) * degree;
  sin_latitude = sin(latitude);
  cos_latitude = cos(latitude);
  sin_declination = sin(declination);
  cos_declination = cos(declination);
}

/// atan2 that does not meet its cut close to where both are certain.
template <class Number>
Number angle_of(const Number& y, const Number& x) {
  using shading::atan2, shading::middle, shading::pi;
  if (middle(x) < 0 && std::fabs(middle(y)) < std::fabs(middle(x))) {
    const Number half = pi(Number(0.0));
    return middle(y) < 0 ? atan2(-y, -x) - half : atan2(-y, -x) + half;
  }
  return atan2(y, x);
}

/// The hour angle brought between -π and π by whole turns.
template <class Number>
Number within_a_day(const Number& angle) {
  using shading::middle, shading::pi;
  const Number turn = Number(2.0) * pi(Number(0.0));
  if (middle(angle) > middle(turn) / 2) return angle - turn;
  if (middle(angle) < -middle(turn) / 2) return angle + turn;
  return angle;
}

template <class Number>
SunCrossing<Number> sun_crossing(const SunCircle<Number>& sun, const SunNormal<Number>& normal) {
  using shading::certain_sign, shading::sqrt;
  const Number e = product(normal, sun.east), n = product(normal, sun.north), u = product(normal, sun.up);
  const Number a = sun.cos_declination * (u * sun.cos_latitude - n * sun.sin_latitude);
  const Number b = -(e * sun.cos_declination);
  const Number c = sun.sin_declination * (n * sun.cos_latitude + u * sun.sin_latitude);
  const Number rest = a * a + b * b - c * c;
  SunCrossing<Number> crossing;
  const int crosses = certain_sign(rest), side = certain_sign(c);
  crossing.mean_side = side;
  if (crosses > 1 || (crosses < 1 && side > 1)) return crossing;
  if (crosses < 1) {
    using Kind = typename SunCrossing<Number>::Kind;
    crossing.kind = side == 0 ? Kind::along : side > 0 ? Kind::always : Kind::never;
    return crossing;
  }
  const Number highest = angle_of(b, a), width = angle_of(sqrt(rest), Number(-c));
  crossing.kind = SunCrossing<Number>::Kind::twice;
  crossing.rise = within_a_day<Number>(highest - width);
  crossing.set = within_a_day<Number>(highest + width);
  return crossing;
}

}  // namespace gnomon::inverse
