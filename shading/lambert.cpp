#include "shading/lambert.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gnomon/errors.h"
#include "shading/arc_factor.h"
#include "shading/vector.h"

namespace gnomon {
namespace {

using shading::length;
using shading::length_above;
using shading::of_size_one;
using shading::Pair;
using shading::square_root;
using shading::twice;
using shading::unit;
using shading::Vector;
using shading::vector;
using shading::VectorPair;
using shading::vectors;

/// Of a squared length: it and its products with others are far from what overflows or loses digits.
constexpr double least_tame = 1e-60;
constexpr double most_tame = 1e60;

bool is_tame(double squared) {
  return squared > least_tame && squared < most_tame;
}

/// The receiver, and the direction along which what is below its horizon is moved up to it.
struct Horizon {
  Vector normal;    ///< of unit length up to roundings
  Vector lift;      ///< has a positive product with the normal, and none that is negative with the light's direction
  double rise = 1;  ///< that positive product
  double tilt = 1;  ///< length of the lift over rise: what moving up does to errors, at most

  double height(const Vector& d) const { return dot(normal, d); }
};

/// The light's directions have a positive product with `forward`, and so have those that are lifted: they stay in half
/// a plane, in which angles are unique.
Horizon horizon(const Point3& normal, const VisibleDirection& forward) {
  Vector n{normal.x, normal.y, normal.z};
  if (!is_tame(dot(n, n))) n = of_size_one(n);
  if (!is_tame(dot(n, n))) throw PreconditionError("the receiver's normal has no direction");
  Horizon result;
  result.normal = (1 / length(n)) * n;
  result.lift = result.normal;
  Vector f = vector(forward);
  if (!is_tame(dot(f, f))) f = of_size_one(f);
  if (dot(result.normal, f) < 0) {
    result.lift = result.normal + (-dot(result.normal, f) / dot(f, f)) * f;
    result.rise = dot(result.normal, result.lift);
    result.tilt = result.rise > 0 ? length_above(result.lift) / result.rise : HUGE_VAL;
  }
  if (!(forward.error < 0.01)) result.tilt = HUGE_VAL;
  return result;
}

/// The ends of a piece: directions of tame lengths.
struct Ends {
  Vector a;
  Vector b;
  double inverse = 1;  ///< 1 over the product of their lengths
  double error = 0;    ///< the sum of how far each is off, in parts of its length
};

Ends ends(const Vector& a, const Vector& b, double error) {
  return {a, b, 1 / std::sqrt(dot(a, a) * dot(b, b)), error};
}

Ends ends(const VisibleDirection& start, const VisibleDirection& end) {
  return ends(vector(start), vector(end), start.error + end.error);
}

double squared_length(const VisibleDirection& d) {
  return dot(vector(d), vector(d));
}

/// Adds up angle times cosine, and what each may be off.
class ArcSum {
 public:
  explicit ArcSum(const Horizon& horizon) : horizon_(horizon) {}

  void add(std::span<const BoundaryPiece> pieces);
  double value() const { return sum_; }
  double error() const { return error_; }

 private:
  void add_term(double value, double error) {
    sum_ += value;
    error_ += error + 2 * unit * std::fabs(sum_);
  }
  bool add_two(const BoundaryPiece& p, const BoundaryPiece& q);
  void add(const BoundaryPiece& piece);
  void add(const Ends& ends, const VisibleDirection& normal);
  void add_in_two(const Ends& ends, const VisibleDirection& normal);
  void add_part(const Ends& ends, const VisibleDirection& normal);
  void add_arc(const Ends& ends, const VisibleDirection& normal);
  void add_wide_arc(const Ends& ends, const VisibleDirection& normal);
  void add_on_horizon(const Ends& ends);
  void add_crossing(const Ends& ends, const VisibleDirection& normal);

  const Horizon& horizon_;
  double sum_ = 0;
  double error_ = 0;
};

/// sin²(angle / 2) between two directions; `inverse` is 1 over the product of their lengths.
template <class Number>
Number half_angle(const Vector3<Number>& a, const Vector3<Number>& b, const Number& inverse) {
  return 0.5 - 0.5 * inverse * dot(a, b);
}

/// Angle times cosine, of at most 60 degrees: x is half_angle().
template <class Number>
Number arc(const Vector3<Number>& normal, const Vector3<Number>& a, const Vector3<Number>& b, const Number& inverse,
           const Number& x) {
  return inverse * dot(normal, cross(a, b)) * arc_factor(x);
}

/// Bound. As a function of the two unit vectors the term changes at most 1.21 times as fast as they do, up to 60
/// degrees. Rounding, each times at most 1.21 sin(60 degrees): 5.5 u in the inverse and 2 u in products with it, 7 u in
/// the product of three vectors, 4.5 u in the normal's length, 3.5 u in x, arc_factor_error. Together less than 32 u.
template <class Number>
Number arc_error(const Number& ends_error) {
  return 1.25 * ends_error + 32 * unit;
}

inline void ArcSum::add_arc(const Ends& e, const VisibleDirection& normal) {
  const double x = std::max(half_angle(e.a, e.b, e.inverse), 0.0);
  if (!(x <= 0.25)) return add_wide_arc(e, normal);
  add_term(arc(horizon_.normal, e.a, e.b, e.inverse, x), arc_error(e.error));
}

/// Bound. The angle is off by what its ends are and 20 u, the piece's unit normal by its own error and 8 u; the cosine
/// is at most 1 and the angle at most pi.
void ArcSum::add_wide_arc(const Ends& e, const VisibleDirection& normal) {
  const Vector n = of_size_one(vector(normal));
  const double n_length = length(n);
  const double angle = std::atan2(length(cross(e.a, e.b)), dot(e.a, e.b));
  const double normal_error = 1.1 * normal.error + 8 * unit;
  add_term(angle * dot(horizon_.normal, n) / n_length, 1.1 * e.error + 24 * unit + std::numbers::pi * normal_error);
}

/// Bound. Lifting multiplies an error by at most 1 + tilt; what is short after it is off by more of its length.
void ArcSum::add_on_horizon(const Ends& e) {
  const Vector p = e.a + (-horizon_.height(e.a) / horizon_.rise) * horizon_.lift;
  const Vector q = e.b + (-horizon_.height(e.b) / horizon_.rise) * horizon_.lift;
  const double angle = std::atan2(dot(horizon_.normal, cross(p, q)), dot(p, q));
  const double shrunk = std::fmax(length_above(e.a) / length(p), length_above(e.b) / length(q));
  const double error = (1 + horizon_.tilt) * shrunk * (1.1 * e.error + 12 * unit) + 20 * unit;
  // Near half a turn the sign of the angle is not certain.
  add_term(angle, std::numbers::pi - std::fabs(angle) < 4 * error ? HUGE_VAL : error);
}

/// Bound. Where exactly the piece is cut hardly matters: a cut at height h instead of 0 changes the sum by at most tilt
/// * h. The ends are about a right angle apart at most, so they do not cancel: the cut is off by 1.5 times what they
/// are.
void ArcSum::add_crossing(const Ends& e, const VisibleDirection& normal) {
  const double height_a = horizon_.height(e.a);
  const double height_b = horizon_.height(e.b);
  const double scale = 1 / (std::fabs(height_a) + std::fabs(height_b));
  const Vector cut = (scale * std::fabs(height_b)) * e.a + (scale * std::fabs(height_a)) * e.b;
  const double cut_error = 1.5 * (e.error + 20 * unit);
  error_ += 2 * (1 + horizon_.tilt) * (cut_error + 30 * unit);
  if (height_a >= 0) {
    add_arc(ends(e.a, cut, e.error + cut_error), normal);
    add_on_horizon(ends(cut, e.b, e.error + cut_error));
  } else {
    add_on_horizon(ends(e.a, cut, e.error + cut_error));
    add_arc(ends(cut, e.b, e.error + cut_error), normal);
  }
}

/// Of at most a right angle, or little more.
inline void ArcSum::add_part(const Ends& e, const VisibleDirection& normal) {
  const bool a_above = horizon_.height(e.a) >= 0;
  const bool b_above = horizon_.height(e.b) >= 0;
  if (a_above && b_above) return add_arc(e, normal);
  if (a_above || b_above) return add_crossing(e, normal);
  add_on_horizon(e);
}

/// A quarter of a turn from its start, a piece passes n x a. Near half a turn both ends may be in the horizon up to
/// rounding while this is far from it; so the piece is parted there. Bound. The product errs by 6 u and what its
/// factors are off.
void ArcSum::add_in_two(const Ends& e, const VisibleDirection& normal) {
  const Vector middle = cross(of_size_one(vector(normal)), e.a);
  const double error = e.error + 1.1 * (e.error + normal.error + 12 * unit);
  if (!(error < 0.01)) error_ = HUGE_VAL;
  add_part(ends(e.a, middle, error), normal);
  add_part(ends(middle, e.b, error), normal);
}

inline void ArcSum::add(const Ends& e, const VisibleDirection& normal) {
  if (!(e.error < 0.01)) error_ = HUGE_VAL;
  if (dot(e.a, e.b) < 0) return add_in_two(e, normal);
  add_part(e, normal);
}

void ArcSum::add(const BoundaryPiece& piece) {
  if (is_tame(squared_length(piece.start)) && is_tame(squared_length(piece.end))) {
    return add(ends(piece.start, piece.end), piece.normal);
  }
  const Vector a = of_size_one(vector(piece.start));
  const Vector b = of_size_one(vector(piece.end));
  add(ends(a, b, piece.start.error + piece.end.error), piece.normal);
}

/// What add_arc() does, for two pieces at once; false if one of them is not of the common kind.
bool ArcSum::add_two(const BoundaryPiece& p, const BoundaryPiece& q) {
  const VectorPair a = vectors(p.start, q.start);
  const VectorPair b = vectors(p.end, q.end);
  const VectorPair n = twice(horizon_.normal);
  const Pair aa = dot(a, a);
  const Pair bb = dot(b, b);
  const Pair inverse = 1 / square_root(aa * bb);
  const Pair ends_error = Pair{p.start.error, q.start.error} + Pair{p.end.error, q.end.error};
  const Pair x = half_angle(a, b, inverse);
  const auto common = (aa > least_tame) & (aa < most_tame) & (bb > least_tame) & (bb < most_tame) & (dot(n, a) >= 0) &
                      (dot(n, b) >= 0) & (x <= 0.25) & (ends_error < 0.01);
  if ((common[0] & common[1]) == 0) return false;
  const Pair term = arc(n, a, b, inverse, x);
  const Pair error = arc_error(ends_error);
  add_term(term[0], error[0]);
  add_term(term[1], error[1]);
  return true;
}

void ArcSum::add(std::span<const BoundaryPiece> pieces) {
  while (!pieces.empty()) {
    const std::size_t count = pieces.size() > 1 && add_two(pieces[0], pieces[1]) ? 2 : 1;
    if (count == 1) add(pieces.front());
    pieces = pieces.subspan(count);
  }
}

bool certainly_below(const Horizon& horizon, const VisibleDirection& d) {
  const Vector v = vector(d);
  return horizon.height(v) < -(1.01 * d.error + 12 * unit) * length_above(v);
}

}  // namespace

Irradiance lambert_irradiance(const VisibleAreaLight& seen, const Point3& normal, double radiance) {
  const Horizon above = horizon(normal, seen.forward);
  const auto hidden = [&](const BoundaryPiece& piece) {
    return certainly_below(above, piece.start) && certainly_below(above, piece.end);
  };
  if (std::all_of(seen.boundary.begin(), seen.boundary.end(), hidden)) return {0, 0};
  ArcSum sum(above);
  sum.add(seen.boundary);
  const double most = std::numbers::pi * radiance;
  const double value = radiance / 2 * sum.value();
  const double clamped = value >= 0 ? std::fmin(value, most) : 0;
  const double bound = 1.01 * (radiance / 2 * sum.error() + 16 * unit * clamped);
  return {clamped, bound >= 0 ? std::fmin(bound, most * (1 + 4 * unit)) : most * (1 + 4 * unit)};
}

}  // namespace gnomon
