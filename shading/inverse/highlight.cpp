#include "shading/inverse/highlight.h"

#include "shading/reflection/precise.h"

namespace gnomon::inverse {

std::optional<ExactVector> mirror_direction(const ExactVector& normal, const ExactVector& eye) {
  const Rational height = dot(normal, eye);
  if (height <= 0) return std::nullopt;
  return Rational(2 * height) * normal - dot(normal, normal) * eye;
}

std::optional<BoundedNumber> phong_exponent(const ExactVector& normal, const ExactVector& eye, const ExactVector& light,
                                            double threshold) {
  const auto mirrored = mirror_direction(normal, eye);
  if (!mirrored) return std::nullopt;
  const Rational along = dot(*mirrored, light);
  const Rational square = along * along / (dot(*mirrored, *mirrored) * dot(light, light));
  if (along <= 0 || square >= 1) return std::nullopt;
  constexpr int bits = 120;
  const shading::Precise::Bits more(bits);
  shading::Precise cosine{square}, wanted(threshold);
  mpfi_log(cosine.get(), cosine.get());
  mpfi_log(wanted.get(), wanted.get());
  const shading::Bounded exponent = shading::bounded(shading::Precise(2.0) * wanted / cosine);
  return BoundedNumber{exponent.value, exponent.error};
}

}  // namespace gnomon::inverse
