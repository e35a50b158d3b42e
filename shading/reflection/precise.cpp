#include "shading/reflection/precise.h"

#include <mpfi_io.h>

namespace gnomon::shading {
namespace {

/// A number of MPFR that cleans up after itself: an end of an interval.
class End {
 public:
  explicit End(const Precise& of) { mpfr_init2(value_, mpfi_get_prec(of.get())); }
  End(const End&) = delete;
  End& operator=(const End&) = delete;
  ~End() { mpfr_clear(value_); }

  double low(const Precise& a) {
    mpfi_get_left(value_, a.get());
    return mpfr_get_d(value_, MPFR_RNDD);
  }
  double high(const Precise& a) {
    mpfi_get_right(value_, a.get());
    return mpfr_get_d(value_, MPFR_RNDU);
  }

 private:
  mpfr_t value_;
};

template <class Operation>
Precise with(Operation operation, const Precise& a) {
  Precise result;
  operation(result.get(), a.get());
  return result;
}

template <class Operation>
Precise with(Operation operation, const Precise& a, const Precise& b) {
  Precise result;
  operation(result.get(), a.get(), b.get());
  return result;
}

}  // namespace

thread_local int Precise::bits_ = 128;

Precise::Precise(const Rational& exact) {
  mpfi_init2(value_, bits_);
  mpfi_set_q(value_, exact.backend().data());
}

Precise operator-(const Precise& a) {
  return with(mpfi_neg, a);
}

Precise operator+(const Precise& a, const Precise& b) {
  return with(mpfi_add, a, b);
}

Precise operator-(const Precise& a, const Precise& b) {
  return with(mpfi_sub, a, b);
}

Precise operator*(const Precise& a, const Precise& b) {
  return with(mpfi_mul, a, b);
}

Precise operator/(const Precise& a, const Precise& b) {
  return with(mpfi_div, a, b);
}

Precise sqrt(const Precise& a) {
  return with(mpfi_sqrt, positive_part(a));
}

Precise atan2(const Precise& y, const Precise& x) {
  return with(mpfi_atan2, y, x);
}

Precise cos(const Precise& a) {
  return with(mpfi_cos, a);
}

Precise sin(const Precise& a) {
  return with(mpfi_sin, a);
}

Precise positive_part(const Precise& a) {
  if (mpfi_is_nonneg(a.get()) > 0) return a;
  Precise result(a);
  End end(a);
  const double high = end.high(a);
  mpfi_interv_d(result.get(), 0, high > 0 ? high : 0);
  return result;
}

Precise widened(const Precise& a, double error) {
  Precise range;
  mpfi_interv_d(range.get(), -error, error);
  return a + range;
}

double middle(const Precise& a) {
  return mpfi_get_d(a.get());
}

double largest(const Precise& a) {
  End end(a);
  const double low = end.low(a), high = end.high(a);
  return low == low && high == high ? std::fmax(-low, high) : HUGE_VAL;
}

int certain_sign(const Precise& a) {
  if (mpfi_is_zero(a.get()) > 0) return 0;
  if (mpfi_is_strictly_pos(a.get()) > 0) return 1;
  return mpfi_is_strictly_neg(a.get()) > 0 ? -1 : 2;
}

Precise pi(const Precise&) {
  Precise result;
  mpfi_const_pi(result.get());
  return result;
}

Bounded bounded(const Precise& a) {
  End end(a);
  const double low = end.low(a), high = end.high(a);
  const double value = low / 2 + high / 2;
  const double off = std::fmax(high - value, value - low);
  return {value, off >= 0 ? std::nextafter(off, HUGE_VAL) : HUGE_VAL};
}

}  // namespace gnomon::shading
