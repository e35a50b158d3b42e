#include "shading/light_flux.h"

#include <cmath>
#include <numbers>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

constexpr double pi = std::numbers::pi;

double length_of(const ExactVector& v) {
  return nearest_root(dot(v, v));
}

double area(const ConvexPolygon& polygon) {
  const auto& points = polygon.points();
  ExactVector doubled{0, 0, 0};
  for (std::size_t k = 2; k < points.size(); ++k) {
    const ExactVector a = exact(points[k - 1]) - exact(points[0]), b = exact(points[k]) - exact(points[0]);
    doubled = doubled + cross(a, b);
  }
  return length_of(doubled) / 2;
}

/// The integral of cos^j(beta) from -eta to eta.
double cosine_power_integral(int j, double eta) {
  double value = j % 2 == 0 ? 2 * eta : 2 * std::sin(eta);
  for (int i = 2 + j % 2; i <= j; i += 2) {
    value = (2 * std::pow(std::cos(eta), i - 1) * std::sin(eta) + (i - 1) * value) / i;
  }
  return value;
}

/// The angle of a light's half-planes.
double wedge_angle(const LinearLight& light) {
  if (!light.emission.shade) return 2 * pi;
  const ExactVector axis = exact(light.end) - exact(light.start);
  const ExactVector a = exact(light.emission.shade->from), b = exact(light.emission.shade->to);
  const double across = nearest_double(Rational(dot(axis, cross(a, b)))) * length_of(axis);
  const double angle = std::atan2(across, nearest_double(Rational(dot(cross(axis, a), cross(axis, b)))));
  return angle > 0 ? angle : angle + 2 * pi;
}

struct FluxOfOne {
  double unit;  ///< in metres

  std::optional<double> operator()(const PointLight&) const { return 4 * pi; }
  std::optional<double> operator()(const DirectionalLight&) const { return std::nullopt; }
  std::optional<double> operator()(const LinearLight& light) const {
    const double eta = light.emission.flaps ? *light.emission.flaps * pi / 180 : pi / 2;
    const double per_length = wedge_angle(light) * cosine_power_integral(light.emission.exponent + 1, eta);
    return per_length * length_of(exact(light.end) - exact(light.start)) * unit;
  }
  std::optional<double> operator()(const AreaLight& light) const {
    return (light.two_sided ? 2 : 1) * pi * area(light.polygon) * unit * unit;
  }
};

}  // namespace

std::optional<double> light_flux(const Light& light, double strength, const LengthUnit& unit) {
  const std::optional<double> of_one = std::visit(FluxOfOne{double(unit.top) / double(unit.bottom)}, light);
  if (!of_one) return std::nullopt;
  const double flux = strength * *of_one;
  return std::isfinite(flux) ? std::optional(flux) : std::nullopt;
}

}  // namespace gnomon
