#pragma once

/// Single draws inside rc::gen::exec: integers that shrink toward zero.

#include <algorithm>

#include <rapidcheck.h>

#include "gnomon/point.h"

namespace gnomon::laws {

/// An integer from `least` to `most`, both included; shrinks toward the one nearest to zero.
inline int draw(int least, int most) {
  const int target = std::clamp(0, least, most);
  return *rc::gen::shrink(rc::gen::noShrink(rc::gen::inRange(least, most + 1)),
                          [target](int value) { return rc::shrink::towards(value, target); });
}

/// True once in `n` draws; shrinks toward false.
inline bool once_in(int n) {
  return draw(0, n - 1) == n - 1;
}

/// A vector of integers from -reach to reach.
inline Point3 draw_vector(int reach) {
  const double x = draw(-reach, reach);
  const double y = draw(-reach, reach);
  return {x, y, double(draw(-reach, reach))};
}

}  // namespace gnomon::laws
