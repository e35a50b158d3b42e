#include "geometry/numbers/printed_bound.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gnomon {
namespace {

/// A positive number as m * 10^exponent or m * 2^exponent.
struct Scaled {
  std::uint64_t m = 0;
  int exponent = 0;
};

/// The shortest decimal that reads back as a positive double: at most 17 digits.
Scaled shortest_decimal(double value) {
  std::array<char, 32> text{};
  const char* end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific).ptr;
  Scaled decimal;
  bool after_point = false;
  for (const char* c = text.data(); c != end; ++c) {
    if (*c == '.') {
      after_point = true;
    } else if (*c == 'e') {
      int exponent = 0;
      std::from_chars(c[1] == '+' ? c + 2 : c + 1, end, exponent);
      decimal.exponent += exponent;
      break;
    } else {
      decimal.m = 10 * decimal.m + static_cast<std::uint64_t>(*c - '0');
      if (after_point) --decimal.exponent;
    }
  }
  return decimal;
}

Scaled binary(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<std::uint64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

bool divide_by_five(std::uint64_t& m, int times) {
  for (; times > 0; --times) {
    if (m % 5 != 0) return false;
    m /= 5;
  }
  return true;
}

void make_odd(Scaled& number) {
  for (; number.m % 2 == 0; ++number.exponent) number.m /= 2;
}

/// m 10^q is m 5^q 2^q: its fives go to the other side, so that nothing grows.
bool is_its_shortest_decimal(double value) {
  if (value == 0) return true;
  Scaled decimal = shortest_decimal(std::fabs(value));
  Scaled exact = binary(std::fabs(value));
  const int fives = decimal.exponent;
  if (!divide_by_five(fives < 0 ? decimal.m : exact.m, std::abs(fives))) return false;
  make_odd(decimal);
  make_odd(exact);
  return decimal.m == exact.m && decimal.exponent == exact.exponent;
}

/// At least half the distance to either neighbour. Of the smallest numbers it is all of it, as it has no half.
double half_ulp(double value) {
  const double size = std::fabs(value);
  const double next = std::nextafter(size, std::numeric_limits<double>::infinity());
  const double ulp = std::isfinite(next) ? next - size : size - std::nextafter(size, 0.0);
  return std::fmax(ulp / 2, std::numeric_limits<double>::denorm_min());
}

double next_larger(double value) {
  return std::nextafter(value, std::numeric_limits<double>::infinity());
}

}  // namespace

double printed_error_bound(double value, double bound) {
  if (!std::isfinite(value) || !std::isfinite(bound)) return bound;
  const bool is_exact = is_its_shortest_decimal(value);
  if (is_exact && bound == 0) return 0;
  // Once for the sum's rounding, once for what the decimal of the bound falls short of it.
  return next_larger(next_larger(is_exact ? bound : bound + half_ulp(value)));
}

}  // namespace gnomon
