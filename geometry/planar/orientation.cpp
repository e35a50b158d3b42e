#include "geometry/planar/orientation.h"

#include <cmath>
#include <limits>

#include "geometry/numbers/kernel.h"

namespace gnomon::planar {
namespace {

/// True if the difference a - b is the double `difference` itself (the error term of Knuth's two-sum vanishes).
bool is_exact_difference(double a, double b, double difference) {
  const double b_virtual = a - difference;
  const double a_virtual = difference + b_virtual;
  return a - a_virtual == 0 && b_virtual - b == 0;
}

/// True if neither the product nor its rounding error underflows or overflows.
bool is_tame(double x, double y, double product) {
  return x == 0 || y == 0 || (std::fabs(product) > 0x1p-900 && std::fabs(product) < 0x1p1000);
}

int sign(double value) {
  return (value > 0) - (value < 0);
}

int exact_turn(const Point2& p, const Point2& q, const Point2& r, const Point2& s) {
  const Rational left = (Rational(q.x) - Rational(p.x)) * (Rational(s.y) - Rational(r.y));
  const Rational right = (Rational(q.y) - Rational(p.y)) * (Rational(s.x) - Rational(r.x));
  return CGAL::compare(left, right);
}

}  // namespace

int turn(const Point2& p, const Point2& q, const Point2& r, const Point2& s) {
  const double ax = q.x - p.x, ay = q.y - p.y;
  const double bx = s.x - r.x, by = s.y - r.y;
  const double left = ax * by, right = ay * bx;
  const double det = left - right;
  // With unit roundoff u, each difference is good to a factor 1 + u, each product of two of them to (1 + u)^3 and
  // 2^-1075 for underflow, and the last difference adds u of the products' sum m: |error| <= (4 + 7 u) u m + 2^-1073.
  // The bound below is larger by enough to cover its own rounding. An overflow makes it infinite or not a number.
  const double bound = 5 * 0x1p-53 * (std::fabs(left) + std::fabs(right)) + std::numeric_limits<double>::min();
  if (det > bound) return 1;
  if (det < -bound) return -1;
  // Ties are common, and mostly between coordinates of few digits: there the differences are exact. Rounding is
  // monotone, so different rounded products are in the order of the exact ones; equal ones differ by their errors.
  if (is_exact_difference(q.x, p.x, ax) && is_exact_difference(q.y, p.y, ay) && is_exact_difference(s.x, r.x, bx) &&
      is_exact_difference(s.y, r.y, by) && is_tame(ax, by, left) && is_tame(ay, bx, right)) {
    if (left != right) return left > right ? 1 : -1;
    return sign(std::fma(ax, by, -left) - std::fma(ay, bx, -right));
  }
  return exact_turn(p, q, r, s);
}

}  // namespace gnomon::planar
