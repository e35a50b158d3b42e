#pragma once

/// Irradiance to any precision: the truth that tests compare with. Private: it speaks of rational numbers.

#include <array>
#include <span>
#include <vector>

#include "geometry/numbers/kernel.h"

namespace gnomon {

using ExactCorner = std::array<Rational, 3>;

/// A convex polygon, its corners relative to the point that looks.
using ExactView = std::vector<ExactCorner>;

/// An interval that holds the irradiance, its ends rounded outwards to doubles.
struct IrradianceInterval {
  double low = 0;
  double high = 0;
};

/// Irradiance at the origin from disjoint visible polygons of radiance 1.
///
/// Definition: lambert_irradiance. Every polygon is cut exactly at the horizon; angles and cosines are intervals.
/// Requires:   no polygon's plane holds the origin; the normal is not zero; precision of at least 64 bits.
/// Exactness:  encloses; more bits make the interval narrower.
IrradianceInterval reference_irradiance(std::span<const ExactView> visible, const ExactCorner& normal, int bits);

}  // namespace gnomon
