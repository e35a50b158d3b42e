#include "shading/reference_irradiance.h"

#include <mpfi.h>
#include <mpfi_io.h>

#include <cstddef>

namespace gnomon {
namespace {

Rational dot(const ExactCorner& a, const ExactCorner& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

ExactCorner cross(const ExactCorner& a, const ExactCorner& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A number of MPFI that cleans up after itself.
class Enclosure {
 public:
  explicit Enclosure(int bits) { mpfi_init2(value_, bits); }
  Enclosure(int bits, const Rational& number) : Enclosure(bits) { mpfi_set_q(value_, number.backend().data()); }
  Enclosure(const Enclosure&) = delete;
  Enclosure& operator=(const Enclosure&) = delete;
  ~Enclosure() { mpfi_clear(value_); }

  mpfi_ptr get() { return value_; }

 private:
  mpfi_t value_;
};

ExactView above_horizon(const ExactView& polygon, const ExactCorner& normal) {
  ExactView result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ExactCorner& a = polygon[k];
    const ExactCorner& b = polygon[(k + 1) % polygon.size()];
    const Rational height_a = dot(normal, a);
    const Rational height_b = dot(normal, b);
    if (height_a >= 0) result.push_back(a);
    if (height_a.sign() * height_b.sign() >= 0) continue;
    const Rational t = height_a / (height_a - height_b);
    ExactCorner cut;
    for (std::size_t i = 0; i < 3; ++i) cut[i] = a[i] + t * (b[i] - a[i]);
    result.push_back(cut);
  }
  return result;
}

/// Adds the angle between a and b, |a x b| and a . b as sides of a right triangle, times normal . (a x b) / |a x b|.
void add_arc(Enclosure& sum, const ExactCorner& a, const ExactCorner& b, const ExactCorner& normal, int bits) {
  const ExactCorner axis = cross(a, b);
  const Rational squared = dot(axis, axis);
  if (squared == 0) return;
  Enclosure sine(bits, squared);
  mpfi_sqrt(sine.get(), sine.get());
  Enclosure angle(bits, dot(a, b));
  mpfi_atan2(angle.get(), sine.get(), angle.get());
  Enclosure term(bits, dot(normal, axis));
  mpfi_mul(term.get(), term.get(), angle.get());
  mpfi_div(term.get(), term.get(), sine.get());
  mpfi_add(sum.get(), sum.get(), term.get());
}

}  // namespace

IrradianceInterval reference_irradiance(std::span<const ExactView> visible, const ExactCorner& normal, int bits) {
  Enclosure total(bits, Rational(0));
  for (const ExactView& polygon : visible) {
    const ExactView above = above_horizon(polygon, normal);
    Enclosure sum(bits, Rational(0));
    for (std::size_t k = 0; k < above.size(); ++k) add_arc(sum, above[k], above[(k + 1) % above.size()], normal, bits);
    mpfi_abs(sum.get(), sum.get());
    mpfi_add(total.get(), total.get(), sum.get());
  }
  Enclosure length(bits, dot(normal, normal));
  mpfi_sqrt(length.get(), length.get());
  mpfi_div(total.get(), total.get(), length.get());
  mpfi_div_ui(total.get(), total.get(), 2);
  IrradianceInterval result;
  mpfr_t end;
  mpfr_init2(end, bits);
  mpfi_get_left(end, total.get());
  result.low = mpfr_get_d(end, MPFR_RNDD);
  mpfi_get_right(end, total.get());
  result.high = mpfr_get_d(end, MPFR_RNDU);
  mpfr_clear(end);
  return result;
}

}  // namespace gnomon
