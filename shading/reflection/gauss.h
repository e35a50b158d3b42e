#pragma once

/// Integrals along arcs by Gauss's rule, with a bound that is proven beforehand. Private to the libraries.

#include <array>
#include <cmath>
#include <vector>

#include "shading/reflection/arc_moments.h"

namespace gnomon::shading {

inline constexpr std::size_t gauss_nodes = 16;

/// Nodes and weights of the rule of 16 nodes on [-1, 1]: those that are positive, each twice.
template <class Number>
struct GaussRule {
  std::array<Number, gauss_nodes / 2> node;
  std::array<Number, gauss_nodes / 2> weight;
};

/// Exactness: nodes are enclosed by signs of Legendre's polynomial, whatever the precision.
template <class Number>
const GaussRule<Number>& gauss_rule();
template <>
const GaussRule<Bounded>& gauss_rule<Bounded>();
template <>
const GaussRule<Precise>& gauss_rule<Precise>();

/// Values of ln(rho) at which the bound is tried; more gain nothing.
inline constexpr std::array<double, 8> log_ellipses = {.12, .25, .45, .7, 1, 1.4, 1.9, 2.6};

/// An arc from its middle: u(s) = cos(s) middle + sin(s) ahead, |s| <= half.
template <class Number>
struct CentredArc {
  Vector3<Number> middle;
  Vector3<Number> ahead;
  Number half;

  explicit CentredArc(const Arc<Number>& arc)
      : middle(middle_of_arc(arc)), ahead(cross(arc.axis, middle)), half(Number(0.5) * arc.angle) {}

  Vector3<Number> at(const Number& s) const { return plus(times(cos(s), middle), times(sin(s), ahead)); }

 private:
  static Vector3<Number> middle_of_arc(const Arc<Number>& arc) {
    const Vector3<Number> sum = plus(arc.start, arc.end);
    if (shading::middle(dot(sum, sum)) > 1) return unit_of(sum);
    return unit_of(cross(minus(arc.end, arc.start), arc.axis));
  }
};

/// A stretch of an arc about its middle, and the ellipse of the complex plane with its ends as foci on which an
/// integrand is bounded: real parts reach from centre - real to centre + real, imaginary ones to `imaginary`.
struct Ellipse {
  double centre = 0;
  double real = 0;
  double imaginary = 0;
};

/// A direction as seen in the plane of an arc, for bounds: what of it lies there, and where it points.
struct InPlane {
  double length = 0;
  double place = 0;
  double slack = 0;  ///< w . u(z) is off by at most this times cosh of the imaginary part of z

  template <class Number>
  InPlane(const CentredArc<Number>& arc, const Vector3<Number>& w)
      : InPlane(bounded(dot(arc.middle, w)), bounded(dot(arc.ahead, w))) {}
  InPlane(const Bounded& along, const Bounded& ahead)
      : length(std::hypot(along.value, ahead.value)),
        place(std::atan2(ahead.value, along.value)),
        slack(along.error + ahead.error + 1e-12) {}

  /// Of numbers in the ellipse, how near and far their real parts come to the place, up to half a turn.
  double nearest(const Ellipse& e) const { return std::fmax(away(e) - e.real - 1e-12, 0); }
  double farthest(const Ellipse& e) const { return std::fmin(away(e) + e.real + 1e-12, std::numbers::pi); }
  /// At least |w . u(z)| for all z in the ellipse.
  double most(const Ellipse& e) const {
    const double cosine = std::fmax(std::cos(std::fmin(nearest(e), std::numbers::pi / 2)), -std::cos(farthest(e)));
    return length * std::hypot(cosine, std::sinh(e.imaginary)) + slack * std::cosh(e.imaginary);
  }
  /// At most the real part of w . u(z) = length cos(x) cosh(y) there.
  double least_real(const Ellipse& e) const {
    const double cosine = std::cos(farthest(e));
    return length * cosine * (cosine < 0 ? std::cosh(e.imaginary) : 1) - slack * std::cosh(e.imaginary);
  }
  /// At least the size of its imaginary part.
  double most_imaginary(const Ellipse& e) const { return (length + slack) * std::sinh(e.imaginary); }

 private:
  double away(const Ellipse& e) const { return std::fabs(std::remainder(e.centre - place, 2 * std::numbers::pi)); }
};

/// How Gauss's rule is to be used: pieces are halved until the errors together fit the tolerance.
struct GaussEffort {
  double tolerance = 1e-12;
  int most_pieces = 400;
};

/// The integral of f along an arc, from its middle.
///
/// Definition: `integrand(s)`; `most(ellipse)` is at least |integrand| in the ellipse, or infinite if that is not
/// known. Exactness:  on a piece of half-width h the rule of m = 16 nodes errs by at most (64/15) M rho^(-2m) h / (1 -
/// rho^-2)
///             where |f| <= M on the ellipse of rho: Chebyshev's coefficients are at most 2 M rho^-k, odd ones vanish,
///             and for even k >= 4 the integral is at most 2/15 and the rule at most 2. Where too many pieces would be
///             needed the error is infinite.
/// After:      [ATAP] ch. 19.
template <class Number, class Integrand, class Most>
Number gauss_integral(const Number& half, const GaussEffort& effort, const Integrand& integrand, const Most& most) {
  struct Piece {
    double from, to;  ///< as shares of the half arc, from -1 to 1
  };
  const GaussRule<Number>& rule = gauss_rule<Number>();
  const double half_above = largest(half);
  std::vector<Piece> waiting = {{-1, 1}};
  Number sum = 0.0;
  int pieces = 0;
  while (!waiting.empty()) {
    const Piece piece = waiting.back();
    waiting.pop_back();
    const double centre = (piece.from + piece.to) / 2, width = (piece.to - piece.from) / 2;
    double error = HUGE_VAL;
    for (const double log_rho : log_ellipses) {
      const double h = width * half_above;
      const Ellipse ellipse{centre * half_above, h * std::cosh(log_rho) + 1e-12, h * std::sinh(log_rho)};
      const double decay = std::exp(-2.0 * gauss_nodes * log_rho) / (1 - std::exp(-2 * log_rho));
      const double bound = 64.0 / 15 * most(ellipse) * decay * h;
      if (bound < error) error = bound;
    }
    if (!(error <= effort.tolerance * width)) {
      if (++pieces + static_cast<int>(waiting.size()) > effort.most_pieces) return widened(sum, HUGE_VAL);
      waiting.push_back({piece.from, centre});
      waiting.push_back({centre, piece.to});
      continue;
    }
    Number part = 0.0;
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
      const Number step = Number(width) * rule.node[k];
      part = part +
             rule.weight[k] * (integrand(half * (Number(centre) + step)) + integrand(half * (Number(centre) - step)));
    }
    sum = widened(sum + Number(width) * half * part, 1.01 * error);
  }
  return sum;
}

}  // namespace gnomon::shading
