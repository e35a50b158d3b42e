#include <cmath>
#include <numbers>

#include "gnomon/errors.h"
#include "gnomon/reflection.h"
#include "shading/reflection/bounded.h"

namespace gnomon {
namespace {

using shading::Bounded;

Bounded bounded_norm(ReflectionModel model, int exponent) {
  if (exponent < 0 || exponent > 10000) throw PreconditionError("a lobe's exponent is from 0 to 10000");
  const double n = exponent;
  const Bounded pi = shading::pi(Bounded{});
  if (model == ReflectionModel::phong) return Bounded(n + 2) / (Bounded(2.0) * pi);
  if (model != ReflectionModel::blinn) return 1.0;
  const double root = std::exp2(-n / 2);
  const Bounded sum = Bounded(n) + Bounded(root, 2 * shading::unit * root);
  return Bounded((n + 2) * (n + 4)) / (Bounded(8.0) * pi * sum);
}

/// A factor times an integral; infinite integrals stay so, but nothing of them is nothing.
Bounded share_of(const Irradiance& integral, const Bounded& factor) {
  if (shading::is_exact_zero(factor)) return 0.0;
  return Bounded(integral.value, integral.error_bound) * factor;
}

Radiance radiance(const Bounded& sum) {
  if (shading::is_exact_zero(sum)) return {};
  if (!(sum.value < HUGE_VAL) || !(sum.error < HUGE_VAL)) return {HUGE_VAL, HUGE_VAL};
  return {sum.value, shading::with_underflow(1.01 * sum.error)};
}

}  // namespace

double lobe_norm(ReflectionModel model, int exponent) {
  return bounded_norm(model, exponent).value;
}

RadianceRgb reflected_radiance(const Reflection& reflection, const Material& material, const Rgb& strength) {
  const Bounded norm = bounded_norm(material.model, material.exponent), pi = shading::pi(Bounded{});
  RadianceRgb result;
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Bounded diffuse = share_of(reflection.received, Bounded(strength[k]) * Bounded(material.diffuse[k]) / pi);
    const Bounded lobe = share_of(reflection.lobe, Bounded(strength[k]) * (Bounded(material.specular[k]) * norm));
    result[k] = radiance(diffuse + lobe);
  }
  return result;
}

RadianceRgb total_radiance(std::span<const RadianceRgb> parts) {
  std::array<Bounded, 3> sums;
  for (const RadianceRgb& part : parts) {
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = sums[k] + Bounded(part[k].value, part[k].error_bound);
  }
  return {radiance(sums[0]), radiance(sums[1]), radiance(sums[2])};
}

double exponent_of_highlight(double angle, double threshold) {
  const bool is_in_range = angle > 0 && angle < std::numbers::pi / 2 && threshold > 0 && threshold < 1;
  if (!is_in_range) throw PreconditionError("a highlight's angle is within (0, pi/2), its threshold within (0, 1)");
  return std::log(threshold) / std::log(std::cos(angle));
}

}  // namespace gnomon
