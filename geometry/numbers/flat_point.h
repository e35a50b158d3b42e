#pragma once

#include "geometry/numbers/kernel.h"

namespace gnomon::event {

/// A point of a receiver's plane in two of its coordinates.
struct FlatPoint {
  Rational x;
  Rational y;

  friend bool operator==(const FlatPoint&, const FlatPoint&) = default;
};

}  // namespace gnomon::event
