#include "geometry/numbers/real_roots.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

Interval interval_around(const Rational& x) {
  const auto [low, high] = CGAL::to_interval(x);
  return {low, high};
}

/// A power of two beyond which there is no root.
Integer root_bound(const Polynomial& p) {
  const Coefficients& c = p.coefficients();
  long most = 0;
  const auto bits = [](const Integer& x) { return x == 0 ? -1L : static_cast<long>(msb(abs(x))); };
  for (std::size_t k = 0; k + 1 < c.size(); ++k) most = std::max(most, bits(c[k]) - bits(c.back()) + 2);
  return Integer(1) << static_cast<unsigned>(most + 1);
}

}  // namespace

RootCounter::RootCounter(const Polynomial& p) {
  const Polynomial slope(derivative(p.coefficients()));
  Polynomial simple = p;
  if (!slope.is_zero()) {
    const Polynomial common = greatest_common_divisor(p, slope);
    if (common.degree() > 0) simple = quotient(p, common);
  }
  square_free_ = std::make_shared<const Polynomial>(std::move(simple));
  chain_.push_back(*square_free_);
  Polynomial next(derivative(square_free_->coefficients()));
  while (!next.is_zero()) {
    chain_.push_back(next);
    const Polynomial& last = chain_[chain_.size() - 2];
    next = Polynomial(Integer(-1) * pseudo_remainder(last.coefficients(), chain_.back().coefficients()));
  }
}

int RootCounter::variations(const Rational& x) const {
  int changes = 0, last = 0;
  for (const Polynomial& p : chain_) {
    const int sign = p.sign_at(x);
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes;
}

int RootCounter::count(const Rational& low, const Rational& high) const {
  return variations(low) - variations(high);
}

RealRoot rational_root(const Rational& x) {
  return {std::make_shared<const Polynomial>(Coefficients{-numerator(x), denominator(x)}), x, x};
}

namespace {

/// Parts intervals until each holds one root.
class Isolation {
 public:
  Isolation(const RootCounter& counter, std::vector<RealRoot>& roots) : counter_(counter), roots_(roots) {}

  /// Of low < x <= high.
  void isolate(const Rational& low, const Rational& high, int count) {
    if (count == 0) return;
    if (count == 1) return isolate_one(low, high);
    const Rational middle = short_number_between(low, high);
    const int below = counter_.count(low, middle);
    isolate(low, middle, below);
    isolate(middle, high, count - below);
  }

 private:
  void isolate_one(Rational low, Rational high) {
    const Polynomial& p = *counter_.square_free();
    // A root at `low` belongs to the interval before.
    while (p.sign_at(high) != 0 && p.sign_at(low) == 0) {
      const Rational middle = short_number_between(low, high);
      (counter_.count(low, middle) == 1 ? high : low) = middle;
    }
    if (p.sign_at(high) == 0) low = high;
    roots_.push_back({counter_.square_free(), std::move(low), std::move(high)});
  }

  const RootCounter& counter_;
  std::vector<RealRoot>& roots_;
};

}  // namespace

namespace {

/// All roots, if they are rational and the degree is at most 2.
std::optional<std::vector<Rational>> rational_roots(const Polynomial& p) {
  const Coefficients& c = p.coefficients();
  if (p.degree() == 1) return std::vector{Rational(-c[0], c[1])};
  if (p.degree() != 2) return std::nullopt;
  const Integer discriminant = c[1] * c[1] - 4 * c[0] * c[2];
  if (discriminant < 0) return std::vector<Rational>();
  Integer rest;
  const Integer root = sqrt(discriminant, rest);
  if (rest != 0) return std::nullopt;
  std::vector<Rational> roots{Rational(-c[1] - root, 2 * c[2]), Rational(-c[1] + root, 2 * c[2])};
  if (root == 0) roots.pop_back();
  std::sort(roots.begin(), roots.end());
  return roots;
}

}  // namespace

std::vector<RealRoot> real_roots(const Polynomial& p, const Rational& low, const Rational& high) {
  if (p.degree() <= 0 || low > high) return {};
  std::vector<RealRoot> roots;
  if (const auto rational = rational_roots(p)) {
    for (const Rational& x : *rational) {
      if (low <= x && x <= high) roots.push_back(rational_root(x));
    }
    return roots;
  }
  const Integer bound = root_bound(p);
  const Rational from = std::max(Rational(low), Rational(-bound)), to = std::min(Rational(high), Rational(bound));
  if (from > to) return {};
  const RootCounter counter(p);
  if (counter.square_free()->sign_at(from) == 0) roots.push_back({counter.square_free(), from, from});
  if (from < to) Isolation(counter, roots).isolate(from, to, counter.count(from, to));
  for (std::size_t k = 0; k + 1 < roots.size(); ++k) compare(roots[k], roots[k + 1]);
  return roots;
}

void refine(RealRoot& root) {
  if (root.is_rational()) return;
  const Rational middle = short_number_between(root.low, root.high);
  const int at_middle = root.of->sign_at(middle);
  if (at_middle == 0) {
    root.low = root.high = middle;
  } else {
    (at_middle == root.of->sign_at(root.low) ? root.low : root.high) = middle;
  }
}

int compare(RealRoot& a, const Rational& b) {
  if (a.is_rational()) return a.low < b ? -1 : a.low > b ? 1 : 0;
  if (b <= a.low) return 1;
  if (b >= a.high) return -1;
  const int at_b = a.of->sign_at(b);
  if (at_b == 0) {
    a.low = a.high = b;
    return 0;
  }
  const bool is_above = at_b == a.of->sign_at(a.low);
  (is_above ? a.low : a.high) = b;
  return is_above ? 1 : -1;
}

namespace {

/// The sign of a - b where the intervals tell.
std::optional<int> order_of_intervals(const RealRoot& a, const RealRoot& b) {
  if (a.high < b.low) return -1;
  if (b.high < a.low) return 1;
  // Open intervals that touch are apart; so is a rational root at the end of an open one.
  const bool one_is_open = !a.is_rational() || !b.is_rational();
  if (one_is_open && a.high == b.low) return -1;
  if (one_is_open && b.high == a.low) return 1;
  return std::nullopt;
}

/// Whether two roots in overlapping intervals are one.
bool are_equal(const RealRoot& a, const RealRoot& b) {
  const Rational low = std::max(a.low, b.low), high = std::min(a.high, b.high);
  if (a.of == b.of) return a.of->sign_at(low) != a.of->sign_at(high);
  const Polynomial common = greatest_common_divisor(*a.of, *b.of);
  // Its roots are simple, and at most one lies in either interval.
  return common.degree() > 0 && common.sign_at(low) * common.sign_at(high) < 0;
}

}  // namespace

int compare(RealRoot& a, RealRoot& b) {
  if (b.is_rational()) return compare(a, Rational(b.low));
  if (a.is_rational()) return -compare(b, Rational(a.low));
  bool is_known_apart = false;
  while (true) {
    if (const auto known = order_of_intervals(a, b)) return *known;
    if (a.is_rational() || b.is_rational()) return compare(a, b);
    if (!is_known_apart) {
      if (are_equal(a, b)) return 0;
      is_known_apart = true;
    }
    refine(a.high - a.low > b.high - b.low ? a : b);
  }
}

Rational short_number_between(const Rational& low, const Rational& high) {
  const Rational middle = (low + high) / 2;
  const double near = nearest_double(middle);
  if (std::isfinite(near)) {
    // The fewest bits that still tell it from both ends.
    const double width = nearest_double(Rational(high - low));
    if (width > 0 && std::isfinite(width)) {
      const double step = std::ldexp(1, std::ilogb(width) - 2);
      const double rounded = std::nearbyint(near / step) * step;
      if (std::isfinite(rounded) && Rational(rounded) > low && Rational(rounded) < high) return Rational(rounded);
    }
    if (Rational(near) > low && Rational(near) < high) return Rational(near);
  }
  return middle;
}

Rational number_between(RealRoot& a, RealRoot& b) {
  while (a.high > b.low || (a.high == b.low && (a.is_rational() || b.is_rational()))) {
    if (a.is_rational() && b.is_rational()) break;
    if (b.is_rational() || (!a.is_rational() && a.high - a.low > b.high - b.low)) {
      refine(a);
    } else {
      refine(b);
    }
  }
  return a.high == b.low ? a.high : short_number_between(a.high, b.low);
}

int sign_at(const Polynomial& p, RealRoot& root) {
  if (p.is_zero()) return 0;
  if (root.is_rational()) return p.sign_at(root.low);
  if (p.degree() == 0) return p.sign_at(root.low);
  const auto near_sign = [&]() -> std::optional<int> {
    const CGAL::Protect_FPU_rounding<true> upward;
    if (!p.is_certainly_signed(interval_around(root.low), interval_around(root.high))) return std::nullopt;
    return p.sign_at(root.low);
  };
  if (const auto known = near_sign()) return *known;
  const Polynomial common = greatest_common_divisor(p, *root.of);
  if (common.degree() > 0 && common.sign_at(root.low) * common.sign_at(root.high) < 0) return 0;
  const RootCounter counter(p);
  while (!root.is_rational() && (counter.count(root.low, root.high) > 0 || p.sign_at(root.low) == 0)) refine(root);
  return p.sign_at(root.low);
}

}  // namespace gnomon
