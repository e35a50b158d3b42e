#pragma once

#include "geometry/kernel.h"

namespace gnomon::event {

/// The double nearest to the square root of a number that is not negative. Private to the libraries.
double nearest_root(const Rational& number);

}  // namespace gnomon::event
