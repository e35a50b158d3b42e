#pragma once

/// Intervals of any precision. Private to the libraries.

#include <mpfi.h>

#include "geometry/numbers/kernel.h"
#include "shading/reflection/bounded.h"

namespace gnomon::shading {

/// An interval of MPFI that holds the real number it stands for. It has the operations of Bounded, so that a formula
/// that is written once answers at both levels.
class Precise {
 public:
  /// While it lives, numbers of this thread are made with so many bits.
  class Bits {
   public:
    explicit Bits(int bits) : before_(bits_) { bits_ = bits; }
    Bits(const Bits&) = delete;
    Bits& operator=(const Bits&) = delete;
    ~Bits() { bits_ = before_; }

   private:
    int before_;
  };

  Precise() : Precise(0.0) {}
  Precise(double exact) {  // NOLINT: doubles are exact
    mpfi_init2(value_, bits_);
    mpfi_set_d(value_, exact);
  }
  explicit Precise(const Rational& exact);
  Precise(const Precise& other) {
    mpfi_init2(value_, mpfi_get_prec(other.value_));
    mpfi_set(value_, other.value_);
  }
  Precise& operator=(const Precise& other) {
    if (this != &other) mpfi_set(value_, other.value_);
    return *this;
  }
  ~Precise() { mpfi_clear(value_); }

  mpfi_ptr get() { return value_; }
  mpfi_srcptr get() const { return value_; }

 private:
  static thread_local int bits_;
  mpfi_t value_;
};

Precise operator-(const Precise& a);
Precise operator+(const Precise& a, const Precise& b);
Precise operator-(const Precise& a, const Precise& b);
Precise operator*(const Precise& a, const Precise& b);
Precise operator/(const Precise& a, const Precise& b);

/// As of Bounded.
inline Precise folded(double top, const Precise& square, const Precise& a, const Precise& b, double below);
Precise sqrt(const Precise& a);  ///< of the part that is not negative
Precise atan2(const Precise& y, const Precise& x);
Precise cos(const Precise& a);
Precise sin(const Precise& a);
Precise positive_part(const Precise& a);
Precise widened(const Precise& a, double error);
double middle(const Precise& a);
double largest(const Precise& a);
int certain_sign(const Precise& a);
Precise pi(const Precise&);

/// The double in the middle, and at least how far the interval reaches from it.
Bounded bounded(const Precise& a);

inline Precise folded(double top, const Precise& square, const Precise& a, const Precise& b, double below) {
  return (b + Precise(top) * square * a) / Precise(below);
}

}  // namespace gnomon::shading
