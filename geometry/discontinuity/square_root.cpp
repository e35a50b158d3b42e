#include "geometry/discontinuity/square_root.h"

#include "geometry/rounding.h"

namespace gnomon::event {

double nearest_root(const Rational& number) {
  // sqrt(n / d) = sqrt(n d) / d; the integer root of n d 4^k has k more bits than the number's own, and a sticky bit
  // below stands for the rest, which cannot change the rounding of a root that is longer than 64 bits.
  using Integer = boost::multiprecision::mpz_int;
  const Integer n = numerator(number), d = denominator(number);
  if (n == 0) return 0;
  const unsigned shift = 128 + static_cast<unsigned>(msb(d));
  Integer rest;
  const Integer root = sqrt(Integer((n * d) << (2 * shift)), rest);
  const Integer sticky = 2 * root + (rest == 0 ? 0 : 1);
  return nearest_double(Rational(sticky, Integer(d << (shift + 1))));
}

}  // namespace gnomon::event
