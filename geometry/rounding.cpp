#include "geometry/rounding.h"

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

}  // namespace gnomon
