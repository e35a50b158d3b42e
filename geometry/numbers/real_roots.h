#pragma once

/// Real roots of polynomials with whole coefficients, as exact numbers that can be compared. Private to geometry/.

#include <memory>
#include <vector>

#include "geometry/numbers/polynomial.h"

namespace gnomon {

/// A polynomial's real roots, each counted once.
class RootCounter {
 public:
  /// Requires: not zero.
  explicit RootCounter(const Polynomial& p);

  /// The same roots, all of them simple.
  const std::shared_ptr<const Polynomial>& square_free() const { return square_free_; }

  /// In low < x <= high.
  int count(const Rational& low, const Rational& high) const;

 private:
  int variations(const Rational& x) const;

  std::shared_ptr<const Polynomial> square_free_;
  std::vector<Polynomial> chain_;  ///< Sturm's
};

/// A real root: the only one of `of`, which has simple roots alone, in low < x < high; or rational, low = x = high.
struct RealRoot {
  std::shared_ptr<const Polynomial> of;
  Rational low;
  Rational high;

  bool is_rational() const { return low == high; }
};

RealRoot rational_root(const Rational& x);

/// The real roots in low <= x <= high, ascending, their intervals apart. Requires: not zero.
std::vector<RealRoot> real_roots(const Polynomial& p, const Rational& low, const Rational& high);

/// Halves the interval around a root.
void refine(RealRoot& root);

/// Signs of a - b. They refine what is compared.
int compare(RealRoot& a, const Rational& b);
int compare(RealRoot& a, RealRoot& b);

/// A rational number strictly between, a short one where possible. Requires: a < b.
Rational number_between(RealRoot& a, RealRoot& b);

/// The sign of a polynomial at a root, which is refined.
int sign_at(const Polynomial& p, RealRoot& root);

/// A short rational number in low < x < high. Requires: low < high.
Rational short_number_between(const Rational& low, const Rational& high);

}  // namespace gnomon
