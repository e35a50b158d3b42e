#include "shading/lambert.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/errors.h"
#include "shading/arc_factor.h"
#include "shading/vector.h"

namespace gnomon {
namespace {

using shading::cross;
using shading::dot;
using shading::length;
using shading::length_above;
using shading::Vector;
using shading::vector;

constexpr double unit = 0x1p-53;

/// A direction and how far it may be off, in parts of its length.
struct Direction {
  Vector vector;
  double error = 0;
};

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
Horizon horizon(const Point3& normal, const SightDirection& forward) {
  const Vector n{normal.x, normal.y, normal.z};
  const double scale = std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)});
  if (!(scale > 0) || !std::isfinite(scale)) throw PreconditionError("the receiver's normal has no direction");
  const Vector scaled{n.x / scale, n.y / scale, n.z / scale};
  Horizon result;
  result.normal = (1 / length(scaled)) * scaled;
  result.lift = result.normal;
  const Vector f = vector(forward);
  const double product = dot(result.normal, f);
  if (product < 0) {
    result.lift = result.normal + (-product / dot(f, f)) * f;
    result.rise = dot(result.normal, result.lift);
    result.tilt = result.rise > 0 ? length_above(result.lift) / result.rise : HUGE_VAL;
  }
  return result;
}

/// Adds up angle times cosine, and what each may be off.
class ArcSum {
 public:
  explicit ArcSum(const Horizon& horizon) : horizon_(horizon) {}

  void add(const BoundaryPiece& piece);
  double value() const { return sum_; }
  double error() const { return error_; }

 private:
  void add_term(double value, double error) {
    sum_ += value;
    error_ += error + 2 * unit * std::fabs(sum_);
  }
  void add_arc(const Vector& a, const Vector& b, const BoundaryPiece& piece, double ends_error);
  void add_wide_arc(const Vector& a, const Vector& b, const BoundaryPiece& piece, double ends_error);
  void add_on_horizon(const Vector& a, const Vector& b, double ends_error);
  void add_crossing(const Vector& a, const Vector& b, const BoundaryPiece& piece, double ends_error);

  const Horizon& horizon_;
  double sum_ = 0;
  double error_ = 0;
};

/// Bound. As a function of the two unit vectors the term changes at most 1.21 times as fast as they do, up to 60
/// degrees. Rounding: 8 u in the product of three vectors, times 1.21; 3 u in the scale, 3.5 u in x, arc_factor_error,
/// each times at most 1.21 sin(60 degrees). Together less than 26 u.
void ArcSum::add_arc(const Vector& a, const Vector& b, const BoundaryPiece& piece, double ends_error) {
  const double inverse = 1 / std::sqrt(dot(a, a) * dot(b, b));
  const double x = std::max(0.5 - 0.5 * inverse * dot(a, b), 0.0);
  if (!(x <= 0.25)) return add_wide_arc(a, b, piece, ends_error);
  const double sine = inverse * dot(horizon_.normal, cross(a, b));
  add_term(sine * arc_factor(x), 1.25 * ends_error + 26 * unit);
}

/// Bound. The angle is off by what its ends are and 20 u, the piece's unit normal by its own error and 8 u; the cosine
/// is at most 1 and the angle at most pi.
void ArcSum::add_wide_arc(const Vector& a, const Vector& b, const BoundaryPiece& piece, double ends_error) {
  const Vector n = vector(piece.normal);
  const double n_length = length(n);
  const double angle = std::atan2(length(cross(a, b)), dot(a, b));
  const double normal_error = 1.1 * piece.normal.error / n_length + 8 * unit;
  add_term(angle * dot(horizon_.normal, n) / n_length, 1.1 * ends_error + 24 * unit + std::numbers::pi * normal_error);
}

/// Bound. Lifting multiplies an error by at most 1 + tilt; what is short after it is off by more of its length.
void ArcSum::add_on_horizon(const Vector& a, const Vector& b, double ends_error) {
  const Vector p = a + (-horizon_.height(a) / horizon_.rise) * horizon_.lift;
  const Vector q = b + (-horizon_.height(b) / horizon_.rise) * horizon_.lift;
  const double angle = std::atan2(dot(horizon_.normal, cross(p, q)), dot(p, q));
  const double shrunk = std::fmax(length_above(a) / length(p), length_above(b) / length(q));
  const double error = (1 + horizon_.tilt) * shrunk * (1.1 * ends_error + 12 * unit) + 20 * unit;
  // Near half a turn the sign of the angle is not certain.
  add_term(angle, std::numbers::pi - std::fabs(angle) < 4 * error ? HUGE_VAL : error);
}

/// Where exactly the piece is cut hardly matters: a cut at height h instead of 0 changes the sum by at most tilt * h.
void ArcSum::add_crossing(const Vector& a, const Vector& b, const BoundaryPiece& piece, double ends_error) {
  const double height_a = horizon_.height(a);
  const double height_b = horizon_.height(b);
  const Vector cut = std::fabs(height_b) * a + std::fabs(height_a) * b;
  error_ += 2 * (1 + horizon_.tilt) * (ends_error + 30 * unit);
  if (height_a >= 0) {
    add_arc(a, cut, piece, ends_error);
    add_on_horizon(cut, b, ends_error);
  } else {
    add_on_horizon(a, cut, ends_error);
    add_arc(cut, b, piece, ends_error);
  }
}

void ArcSum::add(const BoundaryPiece& piece) {
  const Vector a = vector(piece.start);
  const Vector b = vector(piece.end);
  const double ends_error = 1.01 * (piece.start.error / length(a) + piece.end.error / length(b));
  const bool a_above = horizon_.height(a) >= 0;
  const bool b_above = horizon_.height(b) >= 0;
  if (!(ends_error < 0.01)) error_ = HUGE_VAL;
  if (a_above && b_above) return add_arc(a, b, piece, ends_error);
  if (a_above || b_above) return add_crossing(a, b, piece, ends_error);
  add_on_horizon(a, b, ends_error);
}

bool certainly_below(const Horizon& horizon, const SightDirection& d) {
  const Vector v = vector(d);
  return horizon.height(v) < -(1.01 * d.error + 12 * unit * length_above(v));
}

}  // namespace

Irradiance lambert_irradiance(const LightSeen& seen, const Point3& normal, double radiance) {
  const Horizon above = horizon(normal, seen.forward);
  const auto hidden = [&](const BoundaryPiece& piece) {
    return certainly_below(above, piece.start) && certainly_below(above, piece.end);
  };
  if (std::all_of(seen.boundary.begin(), seen.boundary.end(), hidden)) return {0, 0};
  ArcSum sum(above);
  for (const BoundaryPiece& piece : seen.boundary) sum.add(piece);
  const double most = std::numbers::pi * radiance;
  const double value = radiance / 2 * sum.value();
  const double clamped = value >= 0 ? std::fmin(value, most) : 0;
  const double bound = 1.01 * (radiance / 2 * sum.error() + 16 * unit * clamped);
  return {clamped, bound >= 0 ? std::fmin(bound, most * (1 + 4 * unit)) : most * (1 + 4 * unit)};
}

}  // namespace gnomon
