#pragma once

/// Two doubles that are computed with at once. Private to this folder.

#include <cmath>

namespace gnomon::shading {

/// A vector as GCC and Clang have them: operators work on both numbers, comparisons give -1 for true.
using Pair = double __attribute__((vector_size(16)));

inline double magnitude(double a) {
  return std::fabs(a);
}

/// Without the bits of the signs.
inline Pair magnitude(const Pair& a) {
  using Bits = long long __attribute__((vector_size(16)));
  constexpr Bits all_but_sign{0x7fffffffffffffff, 0x7fffffffffffffff};
  return Pair(Bits(a) & all_but_sign);
}

inline Pair square_root(const Pair& a) {
  return Pair{std::sqrt(a[0]), std::sqrt(a[1])};
}

}  // namespace gnomon::shading
