#pragma once

#include "geometry/numbers/kernel.h"
#include "gnomon/point.h"

namespace gnomon {

/// The double nearest to a rational number, ties to even, subnormals and overflow to infinity included.
/// Exactness: correctly rounded whatever the rounding mode of the processor is.
double nearest_double(const Rational& number);

/// The double nearest to the square root of a number that is not negative.
double nearest_root(const Rational& number);

/// The number correctly rounded and as text.
ExactNumber exact_number(const Rational& number);

}  // namespace gnomon
