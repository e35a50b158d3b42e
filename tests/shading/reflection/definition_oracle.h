#pragma once

/// What a surface reflects, by quadrature of the definition: the truth that tests compare with. It shares no code with
/// what it judges.

#include <boost/multiprecision/mpfr.hpp>
#include <vector>

#include "gnomon/reflection.h"

namespace gnomon::test_support {

/// Of 40 digits.
using Long =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<40, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// The two integrals, and what they would come to without lobe and cosine.
template <class Real>
struct Integrated {
  Real received = 0;
  Real lobe = 0;
  Real across = 0;
  bool is_certain = true;  ///< false where halving has not come to rest
};

/// What of a linear light of intensity 1 per length, times its emission, is reflected, nothing hidden: Gauss's rule of
/// 20 nodes on halves of halves, with 40 digits, cut where a cosine changes sign and at flaps. `across` is without
/// emission.
Integrated<Long> integrated_line(const LinearLight& light, const View& view, ReflectionModel model, int exponent);

/// The same of a convex area light of radiance 1 whose front the point is before, with 64 bits.
Integrated<long double> integrated_polygon(const std::vector<Point3>& corners, const View& view, ReflectionModel model,
                                           int exponent);

/// The integrand at one direction, for lights without size.
Integrated<Long> integrand_towards(const Point3& towards, const View& view, ReflectionModel model, int exponent);

}  // namespace gnomon::test_support
