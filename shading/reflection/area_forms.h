#pragma once

/// What a visible part of an area light gives, for numbers of either level. Private to the libraries.

#include "shading/reflection/lobe.h"
#include "shading/reflection/paired_moments.h"

namespace gnomon::shading {

/// The boundary of what is visible of an area light.
/// Orientation: the visible part lies to the left, seen from outside of the sphere of directions.
template <class Number>
struct VisibleBoundary {
  std::vector<Arc<Number>> above_horizon;  ///< of what lies above the surface's horizon, closed along that
  std::vector<Arc<Number>> before_mirror;  ///< of what of that also has R . u >= 0, open along R's plane
  Number closing = 0.0;                    ///< the angle about R of the arcs that close that
};

/// Irradiance of radiance 1. After: Lambert; [P93] §3.2.
template <class Number>
Number area_diffuse(const VisibleBoundary<Number>& seen, const Vector3<Number>& normal) {
  Number sum = 0.0;
  for (const Arc<Number>& arc : seen.above_horizon) sum = sum + dot(normal, arc.axis) * arc.angle;
  return Number(0.5) * sum;
}

/// The solid angle of the triangle between a direction and an arc, negative if it runs clockwise about that.
template <class Number>
Number triangle_angle(const Vector3<Number>& w, const Arc<Number>& arc) {
  const Number across = dot(w, arc.axis) * sin(arc.angle);
  const Number along = Number(1.0) + dot(w, arc.start) + dot(w, arc.end) + cos(arc.angle);
  return Number(2.0) * atan2(across, along);
}

/// The moments tau^k of a visible part about R, and the arcs' moments of the order after.
///
/// Definition: tau^k is the integral of (R . u)^k over the solid angle. (k+1) tau^k = (k-1) tau^(k-2) + the sum over
/// arcs
///             of (R . m) D_(k-1); tau^0 is the sum of triangles about R.
/// After:      [Arvo95] §4.
template <class Number>
class AreaMoments {
 public:
  AreaMoments(const VisibleBoundary<Number>& seen, const Vector3<Number>& w, int order)
      : arcs_(seen.before_mirror), along_(arc_sums(arcs_, w, order)) {
    const bool is_even = order % 2 == 0;
    if (is_even) {
      value_ = seen.closing;
      for (const Arc<Number>& arc : arcs_) value_ = value_ + triangle_angle(w, arc);
    }
    int k = is_even ? 2 : 1;
    for (const Number& sum : along_.sums) {
      // On the arcs that close, m is R or its opposite, and D_0 is all that there is of D.
      value_ = folded(k - 1.0, Number(1.0), value_, k == 1 ? sum + seen.closing : sum, k + 1.0);
      k += 2;
    }
  }

  const Number& value() const { return value_; }

  /// The sum of N . m times D of the order after.
  Number sum_along(const Vector3<Number>& normal) const {
    Number sum = 0.0;
    for (std::size_t i = 0; i < arcs_.size(); ++i) sum = sum + dot(normal, arcs_[i].axis) * along_.last[i];
    return sum;
  }

 private:
  const std::vector<Arc<Number>>& arcs_;
  ArcSums<Number> along_;
  Number value_ = 0.0;
};

/// Of a lobe about the mirrored eye: tau^n, or (n+2) times the integral of (R . u)^n (N . u) as n (R . N) tau^(n-1) and
/// the sum over arcs of (N . m) D_n.
template <class Number>
Number mirror_lobe(const VisibleBoundary<Number>& seen, const Directions<Number>& view, const Lobe& lobe) {
  const int n = lobe.exponent;
  if (!lobe.has_cosine()) return AreaMoments<Number>(seen, view.mirror, n).value();
  if (n == 0) {
    Number sum = 0.0;
    for (const Arc<Number>& arc : seen.before_mirror) sum = sum + dot(view.normal, arc.axis) * arc.angle;
    return Number(0.5) * (sum + view.eye_height * seen.closing);
  }
  const AreaMoments<Number> tau(seen, view.mirror, n - 1);
  return (Number(double(n)) * view.eye_height * tau.value() + tau.sum_along(view.normal)) / Number(n + 2.0);
}

/// 1 + q + ... + q^(count-1), each term positive.
template <class Number>
Number geometric_sum(const Number& q, int count) {
  Number sum = 0.0, next = 1.0;
  for (int bit = 1 << 14; bit > 0; bit /= 2) {
    sum = sum * (Number(1.0) + next);
    next = next * next;
    if ((count & bit) == 0) continue;
    sum = sum + next;
    next = next * q;
  }
  return sum;
}

/// The numbers that the integrand along an arc is made of, or bounds of their sizes.
template <class Number>
struct HalfwayTerms {
  Number base;          ///< N . H
  Number eye_half;      ///< E . H
  Number normal_turn;   ///< N . (H x H')
  Number eye_turn;      ///< E . (H x H')
  Number one_and_base;  ///< 1 + N . H
  Number eye_height;    ///< N . E

  /// (1 - (N . H)^k) / (1 - (N . H)²)
  Number quotient(int k) const {
    return k % 2 == 0 ? geometric_sum(base * base, k / 2) : geometric_sum(base, k) / one_and_base;
  }

  /// What is integrated along the boundary. `minus` is -1, or 1 where sizes are added up.
  Number integrand(const Lobe& lobe, double minus) const {
    const int n = lobe.exponent;
    const Number top = power(base, n);
    const Number first = (eye_height * quotient(n) * normal_turn + top * eye_turn) / Number(n + 2.0);
    if (!lobe.has_cosine()) return Number(4.0) * first;
    const Number moment = quotient(n + 2) * normal_turn / Number(n + 2.0);
    const Number second =
        (Number(n + 1.0) * eye_height * first + moment + top * base * eye_half * eye_turn) / Number(n + 4.0);
    return Number(4.0) * (Number(2.0) * second + Number(minus) * eye_height * first);
  }
};

/// Bounds of the terms in an ellipse. |1 + N . H| is at least 1 less what the real part may be below 0; the root's
/// argument is within an eighth of a turn, as that of its square is within a quarter.
class HalfwayBound {
 public:
  template <class Number>
  HalfwayBound(const Lobe& lobe, const Directions<Number>& view, const Arc<Number>& arc,
               const CentredArc<Number>& centred)
      : lobe_(lobe),
        normal_(centred, view.normal),
        eye_(centred, view.eye),
        normal_out_(largest(dot(view.normal, arc.axis))),
        eye_out_(largest(dot(view.eye, arc.axis))),
        aside_(largest(norm(cross(view.normal, view.eye)))),
        eye_height_(largest(view.eye_height)) {}

  double operator()(const Ellipse& e) const {
    const double half_square = 1 + eye_.least_real(e);
    if (!(half_square > 0)) return HUGE_VAL;
    const double root = std::sqrt(2 * half_square);
    const double below = std::fmax(-normal_.least_real(e) - 0.99 * eye_height_, 0);
    const double apart = 1 - (below + 0.75 * normal_.most_imaginary(e)) / root;
    if (!(apart > 0.1)) return HUGE_VAL;
    const HalfwayTerms<double> most{(normal_.most(e) + eye_height_) / root,
                                    std::sqrt((1 + eye_.most(e)) / 2),
                                    (normal_out_ + aside_ * std::cosh(e.imaginary)) / (2 * half_square),
                                    eye_out_ / (2 * half_square),
                                    apart,
                                    eye_height_};
    return 1.01 * (most.integrand(lobe_, 1));
  }

 private:
  Lobe lobe_;
  InPlane normal_, eye_;
  double normal_out_, eye_out_, aside_, eye_height_;
};

/// Of a lobe about N . H: reduced exactly to an integral along the boundary, on which H runs with the light. No cut but
/// the horizon's. `peak` is about the most that the integral may be. What is next to nothing needs no digits of its
/// own: pieces, however short, would not have them.
template <class Number>
Number halfway_lobe(const VisibleBoundary<Number>& seen, const Directions<Number>& view, const Lobe& lobe,
                    double peak) {
  const GaussEffort effort{1e-12 * std::fmax(peak, 1e-20), 400};
  const Vector3<Number> aside = cross(view.normal, view.eye);
  Number sum = 0.0;
  for (const Arc<Number>& arc : seen.above_horizon) {
    const CentredArc<Number> centred(arc);
    const Number normal_out = dot(view.normal, arc.axis), eye_out = dot(view.eye, arc.axis);
    const auto value = [&](const Number& s) {
      const Vector3<Number> light = centred.at(s);
      const Number square = Number(2.0) + Number(2.0) * dot(view.eye, light);
      const Number root = sqrt(square);
      const Number base = positive_part((dot(view.normal, light) + view.eye_height) / root);
      const Number turn = (normal_out + dot(aside, cross(arc.axis, light))) / square;
      const HalfwayTerms<Number> terms{base,           Number(0.5) * root, turn, eye_out / square, Number(1.0) + base,
                                       view.eye_height};
      return terms.integrand(lobe, -1);
    };
    sum = sum + gauss_integral(centred.half, effort, value, HalfwayBound(lobe, view, arc, centred));
  }
  return sum;
}

template <class Number>
Number area_lobe(const VisibleBoundary<Number>& seen, const Directions<Number>& view, const Lobe& lobe, double peak) {
  return lobe.is_about_halfway() ? halfway_lobe(seen, view, lobe, peak) : mirror_lobe(seen, view, lobe);
}

}  // namespace gnomon::shading
