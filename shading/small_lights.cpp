#include "shading/small_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/rounding.h"
#include "shading/exact_stretch.h"
#include "shading/vector.h"

namespace gnomon {
namespace {

using shading::across_part;
using shading::along_part;
using shading::ExactStretch;
using shading::exponent;
using shading::length;
using shading::length_above;
using shading::of_size_one;
using shading::scaled;
using shading::StretchEnds;
using shading::unit;
using shading::Vector;
using shading::with_underflow;

/// The nearest doubles: each coordinate is off by at most u times itself.
Vector nearest_vector(const ExactVector& v) {
  return {nearest_double(v.x), nearest_double(v.y), nearest_double(v.z)};
}

/// The direction with coordinates of a size that can be multiplied.
Vector direction(const Point3& p) {
  return of_size_one({p.x, p.y, p.z});
}

/// The binary exponent of the largest coordinate, which is a difference of doubles.
int exponent(const ExactVector& v) {
  if (is_zero(v)) return std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits;
  const Vector nearest = nearest_vector(v);
  return length_above(nearest) < HUGE_VAL ? exponent(nearest) : std::numeric_limits<double>::max_exponent;
}

Rational power_of_two(int exponent) {
  const int half = exponent / 2;
  return Rational(std::scalbn(1.0, half)) * Rational(std::scalbn(1.0, exponent - half));
}

/// What was found with all lengths divided by 2^exponent, where the irradiance falls with that power of distance.
Irradiance in_true_size(const Irradiance& e, int exponent, int power) {
  if (e.value == 0 && e.error_bound == 0) return {};
  const double value = shading::times_two_to(e.value, -power * exponent);
  return {value, value < HUGE_VAL ? with_underflow(shading::times_two_to(e.error_bound, -power * exponent)) : HUGE_VAL};
}

/// Whatever the size.
double safe_length(const Vector& a) {
  return shading::times_two_to(length(of_size_one(a)), exponent(a));
}

Vector unit_vector(const Vector& a) {
  const Vector b = of_size_one(a);
  return 1 / length(b) * b;
}

Irradiance infinite() {
  return {HUGE_VAL, HUGE_VAL};
}

/// Bound. The product with the normal errs by 4.1 u of the sum of its absolute terms, which the norms bound; lengths
/// and quotients add 12 u of the value.
Irradiance cosine_over(const Vector& normal, const Vector& d, double divisor) {
  const double scale = length(normal) * length(d);
  const double value = dot(normal, d) / scale / divisor;
  const double error = 1.01 * (8 * unit * length_above(normal) * length_above(d) / scale / divisor);
  if (value <= 0) return {0, value + error > 0 ? value + error : 0};
  return {value, error + 16 * unit * value};
}

std::optional<StretchEnds> above_horizon(StretchEnds stretch, const ExactVector& normal) {
  const Rational from = dot(normal, stretch.from);
  const Rational to = dot(normal, stretch.to);
  if (from <= 0 && to <= 0) return std::nullopt;
  if (from >= 0 && to >= 0) return stretch;
  const ExactVector cut = stretch.from + Rational(from / (from - to)) * (stretch.to - stretch.from);
  (from < 0 ? stretch.from : stretch.to) = cut;
  return stretch;
}

/// Seen end-on: the integral of 1 / r², at one cosine.
Irradiance end_on(const StretchEnds& stretch, const Vector& normal) {
  if (dot(stretch.from, stretch.to) <= 0) return infinite();
  const Vector a = nearest_vector(stretch.from);
  const double a_length = safe_length(a);
  const double b_length = safe_length(nearest_vector(stretch.to));
  const Irradiance cosine = cosine_over(normal, of_size_one(a), 1);
  const double near = 1 / std::fmin(a_length, b_length);
  if (!(near < HUGE_VAL)) return infinite();
  const double value = near - 1 / std::fmax(a_length, b_length);
  const double error = 16 * unit * near;
  return {cosine.value * value,
          1.01 * (cosine.error_bound * value + cosine.value * error + cosine.error_bound * error)};
}

/// What is the same for all stretches of a light that is not seen end-on.
struct Crosswise {
  Vector along;         ///< from the light's start to its end
  Vector tangent;       ///< n x N, of unit normals n of the plane of light and point and N of the receiver
  double distance = 0;  ///< of the light's line
  double error = 0;     ///< relative
};

/// Bound. The cross product of an end and the light's direction errs by 8 u |a| |d|, which n and h pass on. It is that
/// of vectors of size one: where these are so nearly parallel that squares underflow, nothing is left of the bound.
Crosswise crosswise(const Vector& start, const Vector& along, const Vector& normal) {
  const Vector a = of_size_one(start);
  const Vector d = of_size_one(along);
  const Vector axis = cross(a, d);
  const double axis_length = length(axis);
  const double d_length = length(d);
  return {along, 1 / (axis_length * length(normal)) * cross(axis, normal),
          shading::times_two_to(axis_length / d_length, exponent(start)),
          1.01 * 8 * unit * length(a) * d_length / axis_length + 16 * unit};
}

/// An end of a stretch, relative to the point, and how far it may be off.
struct End {
  Vector place;
  double error = 0;
};

/// A stretch and its own length: of a short one the ends do not tell that well enough.
struct FastStretch {
  End from;
  End to;
  Vector along;      ///< from one end to the other
  double error = 0;  ///< of `along`
};

/// With u and v the unit vectors to the ends, n the unit normal of their plane and h the distance of the light's line,
/// the integral is (v - u) . (n x N) / h. Of ends A and B a way D apart v - u is (D - u D . (A + B) / (|A| + |B|)) /
/// |B|, which keeps the digits of D; the plain difference of u and v loses those that both have. Bound. With errors in
/// parts of lengths, u errs by twice that of A and 5 u, the quotient after D by twice those of both ends and 9 u; the
/// difference rounds 2 u and 1 / |B| 9 u. So the whole errs by twice what D does and these, times D.
Irradiance seen_across(const FastStretch& stretch, const Crosswise& light) {
  const Vector& a = stretch.from.place;
  const Vector& b = stretch.to.place;
  const Vector& d = stretch.along;
  const double a_length = safe_length(a), b_length = safe_length(b);
  const double share = dot(d, a + b) / (a_length + b_length);
  const Vector change = 1 / b_length * (d + -share * unit_vector(a));
  const double value = dot(change, light.tangent) / light.distance;
  const double ends = stretch.from.error / a_length + stretch.to.error / b_length;
  const double moved = (2.1 * stretch.error + (6 * ends + 26 * unit) * 1.01 * safe_length(d)) / b_length;
  const double error = (moved + length_above(change) * light.error) / light.distance;
  const double bound = 1.01 * (error + std::fabs(value) * light.error);
  return {std::fmax(value, 0), bound >= 0 && ends < 0.01 ? bound : HUGE_VAL};
}

/// Cosine over squared distance, added up along a stretch. With s the place along the line, h its distance, d its
/// direction and e that of the foot, the integrand is N . (s d + h e) / r³. Nothing is lost where the line all but goes
/// through the point.
Irradiance seen_across(const StretchEnds& true_stretch, const Vector& normal) {
  const bool from_is_nearer = dot(true_stretch.from, true_stretch.from) < dot(true_stretch.to, true_stretch.to);
  const int size = exponent(from_is_nearer ? true_stretch.from : true_stretch.to);
  const Rational power = power_of_two(-size);
  const ExactStretch stretch({power * true_stretch.from, power * true_stretch.to});
  const ExactVector n{Rational(normal.x), Rational(normal.y), Rational(normal.z)};
  const Irradiance along = along_part(stretch, n), across = across_part(stretch, n);
  const double value = (along.value + across.value) / length(normal);
  // The last is for what underflows: the nearer end is about 1 away.
  const double error = (along.error_bound + across.error_bound) / length(normal) + 0x1p-900;
  if (!(std::fabs(value) < HUGE_VAL) || !(error < HUGE_VAL)) return infinite();
  return in_true_size({std::fmax(value, 0), 1.01 * error + 8 * unit * std::fabs(value)}, size, 1);
}

/// Bound. The product and the sum are rounded: 3 u of the light's length and of the start, in each coordinate.
End end_of(const StretchEnd& end, const Vector& start, const Vector& along) {
  const double size = length_above(start) + length_above(along);
  return {start + end.share * along, end.error * length_above(along) + 6 * unit * size};
}

/// Bound. The light's direction is a difference of doubles, rounded; shares are off by what they say.
FastStretch stretch_of(const VisibleStretch& seen, const Vector& start, const Vector& along) {
  const double share = seen.to.share - seen.from.share;
  const double error = (seen.from.error + seen.to.error + 6 * unit * std::fabs(share)) * length_above(along);
  return {end_of(seen.from, start, along), end_of(seen.to, start, along), share * along, error};
}

/// The part of a stretch before the place where its height over the horizon, or what rounding made of it, is 0.
/// Requires: heights of different signs. Bound. The cut may be anywhere that is on the stretch up to rounding.
FastStretch cut_at_horizon(const FastStretch& stretch, double from_height, double to_height, double size) {
  const double share = from_height / (from_height - to_height);
  const End cut{stretch.from.place + share * stretch.along, stretch.from.error + stretch.to.error + 6 * unit * size};
  const double kept = from_height < 0 ? -to_height / (from_height - to_height) : share;
  const double error = stretch.error + 4 * unit * length_above(stretch.along);
  if (from_height < 0) return {cut, stretch.to, kept * stretch.along, error};
  return {stretch.from, cut, kept * stretch.along, error};
}

/// A stretch is cut where its height over the horizon is about 0. Bound. Between the cut and the horizon, heights are
/// no more than what rounding makes of them, the cosine is the height over the distance, and distances are at least h.
Irradiance above_horizon(const FastStretch& stretch, const Crosswise& light, const Vector& normal) {
  const auto& [from, to, along, along_error] = stretch;
  const double normal_length = length(normal);
  const double from_height = dot(normal, from.place) / normal_length;
  const double to_height = dot(normal, to.place) / normal_length;
  const double size = length_above(from.place) + length_above(to.place);
  const double error = 2 * (from.error + to.error) + 16 * unit * size;
  if (from_height < -error && to_height < -error) return {};
  if (!(light.error < 0.5)) return infinite();
  const double h = light.distance * (1 - light.error);
  const double cut_error = error * (length_above(along) + along_error) / (h * h * h);
  if (from_height > error && to_height > error) return seen_across(stretch, light);
  if (from_height <= 0 && to_height <= 0) return {0, 1.01 * cut_error};
  const bool is_cut = from_height < 0 || to_height < 0;
  Irradiance part = seen_across(is_cut ? cut_at_horizon(stretch, from_height, to_height, size) : stretch, light);
  part.error_bound += 1.01 * cut_error;
  return part;
}

}  // namespace

Irradiance point_irradiance(const PointLight& light, const Point3& p, const Point3& normal) {
  if (light.position == p) return infinite();
  const Vector towards = step(p, light.position);
  if (!(length_above(towards) < HUGE_VAL)) return {0, std::numeric_limits<double>::denorm_min()};
  const Vector d = of_size_one(towards);
  return in_true_size(cosine_over(direction(normal), d, dot(d, d)), exponent(towards), 2);
}

Irradiance directional_irradiance(const DirectionalLight& light, const Point3& normal) {
  return cosine_over(direction(normal), -1 * direction(light.direction), 1);
}

Irradiance linear_irradiance(const LinearLight& light, std::span<const std::array<Rational, 2>> intervals,
                             const Point3& p, const Point3& normal) {
  const ExactVector true_start = exact(light.start) - exact(p);
  const ExactVector true_along = exact(light.end) - exact(light.start);
  const int size = std::max(exponent(true_start), exponent(true_along));
  const ExactVector start = power_of_two(-size) * true_start;
  const ExactVector along = power_of_two(-size) * true_along;
  const bool is_end_on = is_zero(cross(start, along));
  const Vector n = direction(normal);
  Irradiance sum;
  for (const std::array<Rational, 2>& interval : intervals) {
    const auto stretch = above_horizon({start + interval[0] * along, start + interval[1] * along}, exact(normal));
    if (!stretch) continue;
    const Irradiance part = is_end_on ? end_on(*stretch, n) : seen_across(*stretch, n);
    sum.value += part.value;
    sum.error_bound += part.error_bound + 2 * unit * sum.value;
  }
  return in_true_size(sum, size, 1);
}

Irradiance linear_irradiance(const LinearLight& light, const VisibleLinearLight& seen, const Point3& p,
                             const Point3& normal) {
  const Vector true_start = step(p, light.start);
  const Vector true_along = step(light.start, light.end);
  const int size = std::max(exponent(true_start), exponent(true_along));
  const Vector start = scaled(true_start, -size);
  const Vector along = scaled(true_along, -size);
  const Vector n = direction(normal);
  const Crosswise across = crosswise(start, along, n);
  Irradiance sum;
  for (const VisibleStretch& stretch : seen.visible) {
    const Irradiance part = above_horizon(stretch_of(stretch, start, along), across, n);
    sum.value += part.value;
    sum.error_bound += part.error_bound + 2 * unit * sum.value;
  }
  if (!(sum.error_bound < HUGE_VAL) || !(sum.value < HUGE_VAL)) return infinite();
  return in_true_size(sum, size, 1);
}

}  // namespace gnomon
