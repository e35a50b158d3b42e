#include "gnomon/shadow_volume.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

constexpr long widest = 900;

/// n with 2^(n - 1) < |number| < 2^(n + 1).
long magnitude(const Rational& number) {
  const auto bits = [](const auto& integer) { return static_cast<long>(mpz_sizeinbase(integer.backend().data(), 2)); };
  return bits(numerator(number)) - bits(denominator(number));
}

/// 2^n.
Rational power_of_two(long n) {
  Rational power = 1;
  if (n >= 0) mpq_mul_2exp(power.backend().data(), power.backend().data(), static_cast<mp_bitcnt_t>(n));
  if (n < 0) mpq_div_2exp(power.backend().data(), power.backend().data(), static_cast<mp_bitcnt_t>(-n));
  return power;
}

/// The plane's numbers, multiplied by one power of two if their doubles might overflow or vanish.
std::array<Rational, 4> in_range(std::array<Rational, 4> numbers) {
  long largest = std::numeric_limits<long>::min();
  for (const Rational& number : numbers) {
    if (number != 0) largest = std::max(largest, magnitude(number));
  }
  if (std::abs(largest) <= widest) return numbers;
  for (Rational& number : numbers) number *= power_of_two(-largest);
  return numbers;
}

}  // namespace

std::array<ExactNumber, 4> plane_coefficients(const HalfSpace& half_space) {
  const ExactVector a = exact(half_space.plane[0]);
  const ExactVector along = exact(half_space.plane[1]) - a;
  const ExactVector third = exact(half_space.plane[2]);
  const ExactVector normal = cross(along, half_space.third_is_direction ? third : third - a);
  const std::array<Rational, 4> numbers = in_range({normal[0], normal[1], normal[2], Rational(-dot(normal, a))});
  return {exact_number(numbers[0]), exact_number(numbers[1]), exact_number(numbers[2]), exact_number(numbers[3])};
}

}  // namespace gnomon
