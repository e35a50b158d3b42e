#include "shading/reflection/small_reflection.h"

namespace gnomon::shading {
namespace {

/// The nearest doubles.
Vector difference(const PointLight& light, const Point3& p) {
  return {light.position.x - p.x, light.position.y - p.y, light.position.z - p.z};
}

/// Of light along a vector towards it, and what it gives across.
template <class Number>
Integrals<Number> along(const Vector3<Number>& towards, const Number& across, const ReflectionQuery& query) {
  const Directions<Number> view = directions<Number>(query.normal, query.to_eye);
  const Vector3<Number> light = unit_of(towards);
  const double peak = middle(across);
  return {across * positive_part(dot(view.normal, light)), across * lobe_value(query.lobe, view, light), peak, peak};
}

/// From the surface's point to the light, over 2^size: rounded, or exact.
template <class Number>
Vector3<Number> towards(const PointLight& light, const Point3& p, int size);

template <>
Vector3<Bounded> towards(const PointLight& light, const Point3& p, int size) {
  const Vector d = scaled(difference(light, p), -size);
  return {{d.x, unit * std::fabs(d.x)}, {d.y, unit * std::fabs(d.y)}, {d.z, unit * std::fabs(d.z)}};
}

template <>
Vector3<Precise> towards(const PointLight& light, const Point3& p, int size) {
  const int half = size / 2;
  const Rational by = Rational(std::scalbn(1.0, -half)) * Rational(std::scalbn(1.0, half - size));
  return vector_of<Precise>(by * (exact(light.position) - exact(p)));
}

}  // namespace

Reflection point_reflection(const PointLight& light, const ReflectionQuery& query) {
  if (light.position == query.point) return {{HUGE_VAL, HUGE_VAL}, {HUGE_VAL, HUGE_VAL}};
  const int size = exponent(difference(light, query.point));
  const auto ask = [&]<class Number>(const Number&) {
    const Vector3<Number> d = towards<Number>(light, query.point, size);
    return along(d, Number(1.0) / dot(d, d), query);
  };
  return with_rising_precision(ask, 2 * size);
}

Reflection directional_reflection(const DirectionalLight& light, const ReflectionQuery& query) {
  const Vector d = of_size_one({-light.direction.x, -light.direction.y, -light.direction.z});
  const auto ask = [&]<class Number>(const Number&) {
    return along(Vector3<Number>{d.x, d.y, d.z}, Number(1.0), query);
  };
  return with_rising_precision(ask, 0);
}

}  // namespace gnomon::shading
