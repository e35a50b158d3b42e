#pragma once

#include "shading/inverse/cells.h"

namespace gnomon::inverse {

/// The directions in which a cell extends, for lengths of normals within it: a plane that a flat cell crosses askew
/// moves through it faster than through space.
class Extent {
 public:
  Extent(const CellSpace& space, const Cell& cell);

  int dimension() const { return dimension_; }

  /// The square of the length of the normal's part along the cell.
  Rational squared(const ExactVector& normal) const;

  /// That length, or a rational number above it by less than 2^-51 of it; exact where it is a double.
  Rational length_above(const ExactVector& normal) const;

  /// The most that the normal grows within the part of a cube along the axes, of half side 1, in the cell's directions.
  Rational cube_support(const ExactVector& normal) const;

 private:
  int dimension_;
  ExactVector across_;  ///< of a flat cell: its normal; of a segment: along it
};

/// The volume of a bounded cell of dimension 3, right to 2^-50 of itself: exact sums of many corners have denominators
/// that nobody reads.
double near_volume(const CellSpace& space, const Cell& cell);

/// The squared length, area or volume of a bounded cell of dimension 1, 2 or 3.
Rational squared_size(const CellSpace& space, const Cell& cell);

}  // namespace gnomon::inverse
