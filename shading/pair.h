#pragma once

/// Two doubles that are computed with at once. Private to this folder.

#include <cmath>

namespace gnomon::shading {

/// A vector as GCC and Clang have them: operators work on both numbers, comparisons give -1 for true.
using Pair = double __attribute__((vector_size(16)));

inline double magnitude(double a) {
  return std::fabs(a);
}

inline Pair magnitude(const Pair& a) {
  return Pair{std::fabs(a[0]), std::fabs(a[1])};
}

inline Pair square_root(const Pair& a) {
  return Pair{std::sqrt(a[0]), std::sqrt(a[1])};
}

}  // namespace gnomon::shading
