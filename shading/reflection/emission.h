#pragma once

/// Which way a linear light shines. Private to the libraries.

#include "gnomon/light.h"
#include "shading/reflection/linear_forms.h"

namespace gnomon::shading {

/// True if a point lies in the half-planes into which the light shines; those at the ends count, and the light's line.
/// Exactness: exact.
bool is_shone_at(const LinearLight& light, const Point3& p);

/// What flaps leave of a stretch.
template <class Number>
struct BetweenFlaps {
  enum class Left { nothing, part, crumb } left = Left::part;
  Stretch<Number> stretch;
  double crumb = 0;  ///< at least the integral of 1 / r² over a stretch of which it is uncertain whether it is there
};

/// 0 or 1 where it is certain that x is no share in between.
template <class Number>
Number clamped_share(const Number& x) {
  const int below = certain_sign(x), above = certain_sign(x - Number(1.0));
  if (below == -1 || below == 0) return 0.0;
  return above == 1 || above == 0 ? Number(1.0) : x;
}

/// The tangent of an angle in degrees.
template <class Number>
Number tangent_of(double degrees) {
  const Number angle = Number(degrees) * pi(Number(0.0)) / Number(180.0);
  return sin(angle) / cos(angle);
}

/// Leaves what lies within the height of the light's line, times the flaps' tangent, of the foot of the perpendicular.
/// Nothing has to be decided: a cut that is off by some share is a stretch that is off by as much.
/// Requires: a stretch that is not seen end-on.
template <class Number>
BetweenFlaps<Number> between_flaps(const Stretch<Number>& s, const Number& tangent) {
  using Left = typename BetweenFlaps<Number>::Left;
  const Number length = norm(s.along);
  const Number place = dot(s.from, s.along) / length, height = norm(cross(s.from, s.along)) / length;
  const Number reach = height * tangent;
  const Number first = clamped_share((-reach - place) / length), last = clamped_share((reach - place) / length);
  const Number kept = last - first;
  const int sign = certain_sign(kept);
  if (sign == 0 || sign == -1) return {Left::nothing, s, 0};
  if (sign == 2) return {Left::crumb, s, 1.01 * largest(kept) * largest(length / (height * height))};
  const Vector3<Number> skipped = times(first, s.along);
  return {Left::part, {plus(s.from, skipped), times(kept, s.along)}, 0};
}

}  // namespace gnomon::shading
