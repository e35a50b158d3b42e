#pragma once

/// The exact level of linear lights. Private to this folder.

#include <array>
#include <cmath>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/rounding.h"
#include "gnomon/irradiance.h"
#include "shading/vector.h"

namespace gnomon::shading {

/// A part of a linear light above the horizon, its ends relative to the point.
struct StretchEnds {
  ExactVector from;
  ExactVector to;
};

/// What a stretch that is not seen end-on is measured by, each number correctly rounded: distances r of its ends, their
/// places s along its line from the foot of the perpendicular, and parts of the normal, whose length does not count.
struct ExactStretch {
  ExactVector along;
  Rational along_square, height_square;
  std::array<Rational, 2> place;  ///< s times the length of `along`
  std::array<Rational, 2> distance_square;
  ExactVector foot;

  explicit ExactStretch(const StretchEnds& stretch)
      : along(stretch.to - stretch.from),
        along_square(dot(along, along)),
        place{dot(stretch.from, along), dot(stretch.to, along)},
        distance_square{dot(stretch.from, stretch.from), dot(stretch.to, stretch.to)},
        foot(stretch.from - Rational(place[0] / along_square) * along) {
    height_square = dot(foot, foot);
  }

  double r(std::size_t end) const { return nearest_root(distance_square[end]); }
  double s(std::size_t end) const { return nearest_root(Rational(place[end] * place[end] / along_square)); }
  double s_over_r(std::size_t end) const {
    return nearest_root(Rational(place[end] * place[end] / (along_square * distance_square[end])));
  }
  /// (r s)², and its root.
  Rational product_square(std::size_t end) const {
    return Rational(place[end] * place[end] / along_square * distance_square[end]);
  }
  double product(std::size_t end) const { return nearest_root(product_square(end)); }
  bool goes_past_the_foot() const { return place[0].sign() * place[1].sign() < 0; }
};

/// The part of the normal across the line: the integral of h / r³, that is (s2 / r2 - s1 / r1) / h, times N . e, with e
/// the direction to the foot. Beyond the foot s / (h r) is 1 / h - h / (r (r + s)); without 1 / h, of which nothing is
/// left, the difference is that of q = r² + r s over both products, and r s is a root: nothing cancels, however short
/// the stretch. Bound. Roots and quotients are off by u each, at most 14 of them.
inline Irradiance across_part(const ExactStretch& stretch, const ExactVector& normal) {
  const Rational height = dot(normal, stretch.foot);
  if (stretch.goes_past_the_foot()) {
    const double slope = nearest_double(Rational(height / stretch.height_square));
    const double value = slope * (stretch.s_over_r(0) + stretch.s_over_r(1));
    return {value, 12 * unit * std::fabs(value)};
  }
  const bool comes_nearer = stretch.place[0] < 0 || stretch.place[1] < 0;
  const std::size_t near = comes_nearer ? 1 : 0, far = 1 - near;
  const double squares = nearest_double(Rational(stretch.distance_square[far] - stretch.distance_square[near]));
  const double root = nearest_root(Rational(stretch.product_square(far) - stretch.product_square(near)));
  const double products = root * (root / (stretch.product(far) + stretch.product(near)));
  const double q_near = stretch.r(near) * (stretch.r(near) + stretch.s(near));
  const double q_far = stretch.r(far) * (stretch.r(far) + stretch.s(far));
  const double value = nearest_double(height) * (squares + products) / q_near / q_far;
  return {value, 20 * unit * std::fabs(value)};
}

/// The part along the line: the integral of s / r³, that is 1 / r1 - 1 / r2, times N . d.
inline Irradiance along_part(const ExactStretch& stretch, const ExactVector& normal) {
  const Rational product = dot(normal, stretch.along);
  const double size = nearest_root(Rational(product * product / stretch.along_square));
  const double cosine = product < 0 ? -size : size;
  const double from = stretch.r(0), to = stretch.r(1);
  const double squares = nearest_double(Rational(stretch.distance_square[1] - stretch.distance_square[0]));
  const double value = cosine * (squares / (from + to) / from / to);
  return {value, 12 * unit * std::fabs(value)};
}

}  // namespace gnomon::shading
