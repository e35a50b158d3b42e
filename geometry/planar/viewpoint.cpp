#include "geometry/planar/viewpoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/numbers/rounding.h"
#include "geometry/planar/light_line.h"
#include "geometry/planar/orientation.h"

namespace gnomon::planar {
namespace {

/// The sign of the cross product (q - p) x (s - r) where p, or r, has coordinates that may be off by `error`;
/// 0 if doubles cannot tell.
int filtered_turn(const Point2& p, const Point2& q, const Point2& r, const Point2& s, double error_p, double error_s) {
  const double ax = q.x - p.x, ay = q.y - p.y;
  const double bx = s.x - r.x, by = s.y - r.y;
  const double left = ax * by, right = ay * bx;
  const double det = left - right;
  // As in turn(), with each difference off by its error besides; twice that covers the roundings of the bound.
  const double bound = 5 * 0x1p-53 * (std::fabs(left) + std::fabs(right)) + std::numeric_limits<double>::min() +
                       2 * error_p * (std::fabs(bx) + std::fabs(by) + error_s) +
                       2 * error_s * (std::fabs(ax) + std::fabs(ay) + error_p);
  return (det > bound) - (det < -bound);
}

Rational exact_turn(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r, const ExactPoint& s) {
  return (q.x - p.x) * (s.y - r.y) - (q.y - p.y) * (s.x - r.x);
}

}  // namespace

Viewpoint::Viewpoint(ExactPoint point) : near_{nearest_double(point.x), nearest_double(point.y)} {
  // Half a unit in the last place, or half the smallest double.
  error_ = std::max({std::fabs(near_.x), std::fabs(near_.y), std::numeric_limits<double>::min()}) * 0x1p-52;
  evaluate_ = [exact = std::move(point)] { return exact; };
}

ExactPoint Viewpoint::exact() const {
  if (!evaluate_) return planar::exact(near_);
  if (!exact_) exact_ = evaluate_();
  return *exact_;
}

int orientation(const Viewpoint& p, const Point2& q, const Point2& r) {
  if (p.is_input()) return orientation(p.near(), q, r);
  if (const int sign = filtered_turn(p.near(), q, p.near(), r, p.error(), p.error())) return sign;
  return CGAL::sign(exact_turn(p.exact(), exact(q), p.exact(), exact(r)));
}

int height_order(const Point2& a, const Point2& b, const Point2& q, const Viewpoint& p) {
  if (p.is_input()) return turn(a, b, q, p.near());
  if (const int sign = filtered_turn(a, b, q, p.near(), 0, p.error())) return sign;
  return CGAL::sign(exact_turn(exact(a), exact(b), exact(q), p.exact()));
}

}  // namespace gnomon::planar
