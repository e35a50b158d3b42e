#pragma once

/// Moments of sharp lobes in a time that does not grow with the exponent. Private to the libraries.

#include <array>
#include <memory>
#include <vector>

#include "shading/reflection/arc_moments.h"

namespace gnomon::shading {

/// The integral of cos^n from 0 to an angle, n at least `least_exponent`, as a function of the angle's sine s.
///
/// Definition: D(s) is the integral of (1 - t²)^((n-1)/2) from 0 to s; up to s = 8.6 / sqrt(n) in 16 pieces, of each
///             Taylor's polynomial of degree 17 about its middle; beyond it no more than 1e-16 of the whole is left.
/// Exactness:  coefficients are MPFI's, rounded. Bound. By Cauchy what the polynomial leaves out is at most M q^18 / (1
/// -
///             q) with |D| <= M on a circle about the middle, q the share of its radius that the piece reaches; of the
///             radii tried the best counts. Horner's rule errs by less than 40 u times the sum of absolute
///             coefficients. D changes by no more than s does.
class LobeTable {
 public:
  static constexpr int least_exponent = 100;

  /// Kept for the next one who asks, for any number of threads.
  static const LobeTable& of(int exponent);

  explicit LobeTable(int exponent);

  /// Requires: a sine, from -1 to 1 but for rounding.
  Bounded at(const Bounded& sine) const;

 private:
  static constexpr std::size_t pieces = 16, degree = 17;

  struct Piece {
    std::array<double, degree + 1> coefficients{};  ///< of powers of the place in the piece, from -1 to 1
    double error = 0;
  };

  double width_;  ///< of a piece
  std::array<Piece, pieces> table_;
  Bounded whole_;  ///< D beyond the last piece
};

/// D_k of an arc about a direction, by the table where that is quicker.
///
/// Definition: with c the length of the direction in the arc's plane it is c^k times what D rises by.
Bounded quick_moment(const ArcAxis<Bounded>& axis, int k);

inline Precise quick_moment(const ArcAxis<Precise>& axis, int k) {
  return arc_moment(axis, k);
}

}  // namespace gnomon::shading
