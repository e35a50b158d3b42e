#include "geometry/numbers/rational_interval.h"

#include "geometry/numbers/polynomial.h"

namespace gnomon {
namespace {

/// Rounded down to a multiple of 2^-shift.
Rational rounded_down(const Rational& x, long shift) {
  Integer n = numerator(x), d = denominator(x);
  (shift > 0 ? n : d) <<= static_cast<unsigned>(shift > 0 ? shift : -shift);
  Integer whole = n / d;
  if (n < 0 && whole * d != n) --whole;
  const Integer unit = Integer(1) << static_cast<unsigned>(shift > 0 ? shift : -shift);
  return shift > 0 ? Rational(whole, unit) : Rational(whole * unit);
}

}  // namespace

RationalInterval rounded(const RationalInterval& x, unsigned bits) {
  const Rational size = std::max(Rational(abs(x.low)), Rational(abs(x.high)));
  if (size == 0) return x;
  const long exponent = static_cast<long>(msb(numerator(size))) - static_cast<long>(msb(denominator(size)));
  const long shift = static_cast<long>(bits) - exponent;
  return {rounded_down(x.low, shift), Rational(-rounded_down(Rational(-x.high), shift))};
}

}  // namespace gnomon
