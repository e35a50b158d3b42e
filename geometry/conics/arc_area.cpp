#include "geometry/conics/arc_area.h"

#include <algorithm>
#include <array>

namespace gnomon::conic {
namespace {

using Homogeneous = std::array<RationalInterval, 3>;

RationalInterval interval_of(const Coefficients& p, std::size_t k) {
  return RationalInterval(k < p.size() ? Rational(p[k]) : Rational(0));
}

/// The polar form of the curve's points: at (t, t) the point at t, at (s, t) the Bezier point between.
Homogeneous polar(const FlatCurve& curve, const RationalInterval& s, const RationalInterval& t, unsigned bits) {
  const RationalInterval half(Rational(1, 2));
  Homogeneous result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Coefficients& c = curve.point[k];
    result[k] = rounded(interval_of(c, 0) + interval_of(c, 1) * half * (s + t) + interval_of(c, 2) * s * t, bits + 32);
  }
  return result;
}

PointBox affine(const Homogeneous& p, unsigned bits) {
  return {rounded(p[1] / p[0], bits + 32), rounded(p[2] / p[0], bits + 32)};
}

RationalInterval cross(const PointBox& origin, const PointBox& a, const PointBox& b) {
  return (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
}

/// Requires: |x| <= 1/2.
RationalInterval kappa(const RationalInterval& x, unsigned bits) {
  RationalInterval sum, power(Rational(1)), c(Rational(1));
  const Rational least = Rational(1, Integer(1) << (bits + 8));
  for (unsigned m = 0;; ++m) {
    const RationalInterval term = c * power;
    const Rational size = std::max(Rational(abs(term.low)), Rational(abs(term.high)));
    if (size <= least) {
      // Each later term is at most half of the one before.
      sum = sum + RationalInterval(Rational(-2 * size), Rational(2 * size));
      break;
    }
    sum = rounded(sum + term, bits + 16);
    power = rounded(power * x, bits + 16);
    c = rounded(c * RationalInterval(Rational(2 * m + 4, 2 * m + 7)), bits + 16);
  }
  return RationalInterval(Rational(2, 3)) - RationalInterval(Rational(2, 15)) * x * sum;
}

RationalInterval span_of(const RealRoot& root) {
  return {root.low, root.high};
}

class Segment {
 public:
  Segment(const FlatCurve& curve, unsigned bits) : curve_(curve), bits_(bits) {}

  RationalInterval doubled(const RationalInterval& from, const RationalInterval& to) const {
    const Homogeneous h0 = polar(curve_, from, from, bits_), h1 = polar(curve_, from, to, bits_),
                      h2 = polar(curve_, to, to, bits_);
    const PointBox p0 = affine(h0, bits_), p2 = affine(h2, bits_);
    const int sign = h0[0].certain_sign();
    if (h1[0].certain_sign() == sign) {
      const RationalInterval u = rounded(h1[0] * h1[0] / (h0[0] * h2[0]), bits_ + 16);
      const RationalInterval x = RationalInterval(Rational(1)) - u;
      if (x.low >= Rational(-1, 2) && x.high <= Rational(1, 2)) {
        const PointBox p1 = affine(h1, bits_);
        return rounded(cross(p0, p1, p2) * kappa(x, bits_), bits_ + 16);
      }
    }
    const RationalInterval middle(short_number_between(from.high, to.low));
    const PointBox pm = affine(polar(curve_, middle, middle, bits_), bits_);
    return doubled(from, middle) + doubled(middle, to) + cross(p0, pm, p2);
  }

 private:
  const FlatCurve& curve_;
  unsigned bits_;
};

}  // namespace

PointBox point_box(const FlatCurve& curve, RealRoot& root, unsigned bits) {
  const Rational least = Rational(1, Integer(1) << bits);
  while (true) {
    const Homogeneous h = polar(curve, span_of(root), span_of(root), bits);
    if (h[0].certain_sign() != 0) {
      PointBox box = affine(h, bits);
      const Rational size = std::max(Rational(abs(box.x.high)), Rational(abs(box.y.high)));
      if (std::max(box.x.width(), box.y.width()) <= least * size) return box;
    }
    if (root.is_rational()) return affine(h, bits);
    refine(root);
  }
}

RationalInterval doubled_segment(const FlatCurve& curve, RealRoot& from, RealRoot& to, unsigned bits) {
  if (curve.is_straight) return RationalInterval(Rational(0));
  point_box(curve, from, bits);
  point_box(curve, to, bits);
  return Segment(curve, bits).doubled(span_of(from), span_of(to));
}

}  // namespace gnomon::conic
