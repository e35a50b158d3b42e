#include "shading/small_lights.h"

#include <cmath>
#include <optional>

#include "geometry/rounding.h"
#include "geometry/visibility/exact_vector.h"
#include "shading/vector.h"

namespace gnomon {
namespace {

using shading::cross;
using shading::dot;
using shading::length;
using shading::length_above;
using shading::Vector;

constexpr double unit = 0x1p-53;

/// The nearest doubles: each coordinate is off by at most u times itself.
Vector rounded(const ExactVector& v) {
  return {nearest_double(v.x), nearest_double(v.y), nearest_double(v.z)};
}

Vector rounded(const Point3& p) {
  return {p.x, p.y, p.z};
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

/// A part of a linear light above the horizon, its ends relative to the point.
struct Stretch {
  ExactVector from;
  ExactVector to;
};

std::optional<Stretch> above_horizon(Stretch stretch, const ExactVector& normal) {
  const Rational from = dot(normal, stretch.from);
  const Rational to = dot(normal, stretch.to);
  if (from <= 0 && to <= 0) return std::nullopt;
  if (from >= 0 && to >= 0) return stretch;
  const ExactVector cut = stretch.from + Rational(from / (from - to)) * (stretch.to - stretch.from);
  (from < 0 ? stretch.from : stretch.to) = cut;
  return stretch;
}

/// Seen end-on: the integral of 1 / r², at one cosine.
Irradiance end_on(const Stretch& stretch, const Vector& normal) {
  const Vector a = rounded(stretch.from);
  const Vector b = rounded(stretch.to);
  if (dot(stretch.from, stretch.to) <= 0) return infinite();
  const Irradiance cosine = cosine_over(normal, a, 1);
  const double near = 1 / std::fmin(length(a), length(b));
  const double value = near - 1 / std::fmax(length(a), length(b));
  const double error = 16 * unit * near;
  return {cosine.value * value,
          1.01 * (cosine.error_bound * value + cosine.value * error + cosine.error_bound * error)};
}

/// With u and v the unit vectors to the ends, n the unit normal of their plane and h the distance of the light's line,
/// the integral is (v - u) . (n x N) / h.
/// Bound. The cross product of an end and the light's direction errs by 8 u |a| |d|, which n and h pass on; unit
/// vectors err by 5 u.
Irradiance seen_across(const Stretch& stretch, const Vector& normal) {
  const Vector a = rounded(stretch.from);
  const Vector b = rounded(stretch.to);
  const Vector d = rounded(stretch.to - stretch.from);
  const Vector axis = cross(a, d);
  const double axis_length = length(axis);
  const double relative = 1.01 * 8 * unit * length(a) * length(d) / axis_length;
  const Vector change = 1 / length(b) * b + -1 / length(a) * a;
  const Vector tangent = 1 / (axis_length * length(normal)) * cross(axis, normal);
  const double factor = length(d) / axis_length;
  const double value = factor * dot(change, tangent);
  const double error = factor * (20 * unit + length_above(change) * (relative + 16 * unit));
  const double bound = 1.01 * (error + std::fabs(value) * (relative + 16 * unit));
  return {std::fmax(value, 0), bound >= 0 ? bound : HUGE_VAL};
}

}  // namespace

Irradiance point_irradiance(const PointLight& light, const Point3& p, const Point3& normal) {
  if (light.position == p) return infinite();
  const Vector d = rounded(exact(light.position) - exact(p));
  return cosine_over(rounded(normal), d, dot(d, d));
}

Irradiance directional_irradiance(const DirectionalLight& light, const Point3& normal) {
  return cosine_over(rounded(normal), -1 * rounded(light.direction), 1);
}

Irradiance linear_irradiance(const LinearLight& light, std::span<const std::array<Rational, 2>> intervals,
                             const Point3& p, const Point3& normal) {
  const ExactVector start = exact(light.start) - exact(p);
  const ExactVector along = exact(light.end) - exact(light.start);
  Irradiance sum;
  for (const std::array<Rational, 2>& interval : intervals) {
    const auto stretch = above_horizon({start + interval[0] * along, start + interval[1] * along}, exact(normal));
    if (!stretch) continue;
    const bool is_end_on = is_zero(cross(start, along));
    const Irradiance part = is_end_on ? end_on(*stretch, rounded(normal)) : seen_across(*stretch, rounded(normal));
    sum.value += part.value;
    sum.error_bound += part.error_bound + 2 * unit * sum.value;
  }
  return sum;
}

}  // namespace gnomon
