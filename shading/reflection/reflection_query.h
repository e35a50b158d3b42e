#pragma once

/// What is asked of a light, and answers of either level. Private to the libraries.

#include <optional>

#include "gnomon/reflection.h"
#include "shading/reflection/lobe.h"

namespace gnomon::shading {

/// A view and the lobe that is integrated; vectors of size one.
struct ReflectionQuery {
  Point3 point;
  Vector normal;
  Vector to_eye;
  Lobe lobe;
};

inline ExactVector exact(const Vector& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

/// Along R: 2 (N . E) N - (N . N) E, in rational numbers.
inline ExactVector exact_mirror(const ReflectionQuery& query) {
  const ExactVector n = exact(query.normal), e = exact(query.to_eye);
  const Rational double_height = 2 * dot(n, e);
  return Rational(double_height) * n - dot(n, n) * e;
}

/// The integrals, and how large they are at their peaks at most, roughly.
template <class Number>
struct Integrals {
  Number received = 0.0;
  Number lobe = 0.0;
  double received_peak = 0;
  double lobe_peak = 0;
};

/// What of an integral's peak may stay uncertain before more digits are asked for.
inline constexpr double widest_share = 1e-9;

inline Irradiance not_negative(const Bounded& x) {
  return {std::fmax(x.value, 0), x.error};
}

/// The same lengths times 2^exponent, where integrals fall with that power of them.
inline Irradiance in_true_size(const Irradiance& e, int falls_by) {
  if (e.value == 0 && e.error_bound == 0) return {};
  const double value = times_two_to(e.value, -falls_by);
  return {value, value < HUGE_VAL ? with_underflow(times_two_to(e.error_bound, -falls_by)) : HUGE_VAL};
}

/// An infinite error is not narrow, though the peak may have come out infinite as well.
inline bool is_narrow(const Bounded& sum, double peak) {
  return sum.error < HUGE_VAL && sum.error <= widest_share * peak;
}

template <class Number>
bool is_narrow(const Integrals<Number>& sums) {
  return is_narrow(bounded(sums.received), sums.received_peak) && is_narrow(bounded(sums.lobe), sums.lobe_peak);
}

template <class Number>
Reflection reflection(const Integrals<Number>& sums, int falls_by) {
  return {in_true_size(not_negative(bounded(sums.received)), falls_by),
          in_true_size(not_negative(bounded(sums.lobe)), falls_by)};
}

/// Asks with doubles, then with more and more bits until the answer is narrow, and takes what comes last.
/// `ask` answers for a number type that it is given a value of.
template <class Ask>
Reflection with_rising_precision(const Ask& ask, int falls_by) {
  const Integrals<Bounded> quick = ask(Bounded{});
  if (is_narrow(quick)) return reflection(quick, falls_by);
  Reflection last;
  for (const int bits : {128, 256, 512, 1024}) {
    const Precise::Bits protect(bits);
    const Integrals<Precise> slow = ask(Precise{});
    last = reflection(slow, falls_by);
    if (is_narrow(slow)) break;
  }
  return last;
}

}  // namespace gnomon::shading
