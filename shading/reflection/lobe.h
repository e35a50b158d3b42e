#pragma once

/// Lobes and how they are integrated along an arc. Private to the libraries.

#include "gnomon/reflection.h"
#include "shading/reflection/gauss.h"

namespace gnomon::shading {

/// The shape of a lobe, without its norm and colour.
struct Lobe {
  ReflectionModel model = ReflectionModel::phong;
  int exponent = 0;

  bool is_about_halfway() const { return model == ReflectionModel::blinn || model == ReflectionModel::blinn_classic; }
  bool has_cosine() const { return model == ReflectionModel::phong || model == ReflectionModel::blinn; }
};

/// x^n where x is positive, else 0: of an exponent of 0 too.
template <class Number>
Number positive_power(const Number& x, int n) {
  if (n > 0) return power(positive_part(x), n);
  const int sign = certain_sign(x);
  return sign == 2 ? widened(Number(0.5), 0.5) : Number(sign > 0 ? 1.0 : 0.0);
}

/// What the lobe gives for light from one direction, above the surface's horizon: (R . L)^n or (N . H)^n, times N . L
/// unless the model is a classic one.
template <class Number>
Number lobe_value(const Lobe& lobe, const Directions<Number>& view, const Vector3<Number>& light) {
  const Number cosine = dot(view.normal, light);
  Number base;
  if (lobe.is_about_halfway()) {
    const Number squared = Number(2.0) + Number(2.0) * dot(view.eye, light);
    base = (cosine + view.eye_height) / sqrt(squared);
  } else {
    base = dot(view.mirror, light);
  }
  const Number value = positive_power(base, lobe.exponent);
  return lobe.has_cosine() ? value * positive_part(cosine) : value;
}

/// At least |lobe_value| for complex places of an arc.
class LobeBound {
 public:
  template <class Number>
  LobeBound(const Lobe& lobe, const Directions<Number>& view, const CentredArc<Number>& arc)
      : lobe_(lobe),
        normal_(arc, view.normal),
        eye_(arc, view.eye),
        mirror_(arc, view.mirror),
        eye_height_(largest(view.eye_height)) {}

  double operator()(const Ellipse& e) const {
    const double base = lobe_.is_about_halfway() ? halfway(e) : mirror_.most(e);
    return 1.01 * std::pow(base, lobe_.exponent) * (lobe_.has_cosine() ? normal_.most(e) : 1);
  }

 private:
  /// N . H = (N . L + N . E) / sqrt(2 + 2 E . L), whose square has a positive real part or nothing is known.
  double halfway(const Ellipse& e) const {
    const double half_square = 1 + eye_.least_real(e);
    return half_square > 0 ? (normal_.most(e) + eye_height_) / std::sqrt(2 * half_square) : HUGE_VAL;
  }

  Lobe lobe_;
  InPlane normal_, eye_, mirror_;
  double eye_height_;
};

/// The number with the smaller error.
template <class Number>
Number narrower(const Number& a, const Number& b) {
  return bounded(a).error <= bounded(b).error ? a : b;
}

/// How much of an arc a lobe is as wide as, at most: what its integral comes to at its peak.
inline double lobe_peak(int exponent, double angle) {
  return std::fmin(angle, std::sqrt(2 * std::numbers::pi / std::fmax(exponent, 1)));
}

}  // namespace gnomon::shading
