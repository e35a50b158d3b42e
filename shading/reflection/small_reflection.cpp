#include "shading/reflection/small_reflection.h"

namespace gnomon::shading {
namespace {

/// Of light along a vector towards it, and what it gives across.
template <class Number>
Integrals<Number> along(const Vector3<Number>& towards, const Number& across, const Sight& sight) {
  const Directions<Number> view = directions<Number>(sight.normal, sight.to_eye);
  const Vector3<Number> light = unit_of(towards);
  const double peak = middle(across);
  return {across * positive_part(dot(view.normal, light)), across * lobe_value(sight.lobe, view, light), peak, peak};
}

}  // namespace

Reflection point_reflection(const PointLight& light, const Sight& sight) {
  const ExactVector towards = exact(light.position) - exact(sight.point);
  if (is_zero(towards)) return {{HUGE_VAL, HUGE_VAL}, {HUGE_VAL, HUGE_VAL}};
  const Vector nearest{nearest_double(towards.x), nearest_double(towards.y), nearest_double(towards.z)};
  const int size = exponent(nearest), half = size / 2;
  const Rational by = Rational(std::scalbn(1.0, -half)) * Rational(std::scalbn(1.0, half - size));
  const ExactVector scaled = by * towards;
  const auto ask = [&]<class Number>(const Number&) {
    const Vector3<Number> d = vector_of<Number>(scaled);
    return along(d, Number(1.0) / dot(d, d), sight);
  };
  return with_rising_precision(ask, 2 * size);
}

Reflection directional_reflection(const DirectionalLight& light, const Sight& sight) {
  const Vector d = of_size_one({-light.direction.x, -light.direction.y, -light.direction.z});
  const auto ask = [&]<class Number>(const Number&) {
    return along(Vector3<Number>{d.x, d.y, d.z}, Number(1.0), sight);
  };
  return with_rising_precision(ask, 0);
}

}  // namespace gnomon::shading
