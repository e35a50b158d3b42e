#include "geometry/numbers/rounding.h"

#include <mpfr.h>

#include <limits>

namespace gnomon {

double nearest_double(const Rational& number) {
  // With the exponent range of doubles set, mpfr_subnormalize turns the first rounding into the one of a double.
  const mpfr_exp_t saved_min = mpfr_get_emin();
  const mpfr_exp_t saved_max = mpfr_get_emax();
  mpfr_set_emin(std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits + 1);
  mpfr_set_emax(std::numeric_limits<double>::max_exponent);
  MPFR_DECL_INIT(value, std::numeric_limits<double>::digits);
  const int ternary = mpfr_set_q(value, number.backend().data(), MPFR_RNDN);
  mpfr_subnormalize(value, ternary, MPFR_RNDN);
  const double result = mpfr_get_d(value, MPFR_RNDN);
  mpfr_set_emin(saved_min);
  mpfr_set_emax(saved_max);
  return result;
}

ExactNumber exact_number(const Rational& number) {
  return {nearest_double(number), number.str()};
}

double nearest_root(const Rational& number) {
  // sqrt(n / d) = sqrt(n d) / d; the integer root of n d 4^k has k more bits than the number's own, and a sticky bit
  // below stands for the rest, which cannot change the rounding of a root that is longer than 64 bits.
  const Integer n = numerator(number), d = denominator(number);
  if (n == 0) return 0;
  const unsigned shift = 128 + static_cast<unsigned>(msb(d));
  Integer rest;
  const Integer root = sqrt(Integer((n * d) << (2 * shift)), rest);
  const Integer sticky = 2 * root + (rest == 0 ? 0 : 1);
  return nearest_double(Rational(sticky, Integer(d << (shift + 1))));
}

}  // namespace gnomon
