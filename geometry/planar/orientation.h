#pragma once

#include "gnomon/point.h"

namespace gnomon::planar {

/// Sign (-1, 0, +1) of the cross product (q - p) x (s - r): +1 if the direction from r to s lies to the left of the
/// direction from p to q, 0 if they are parallel.
///
/// Exactness: exact for all finite doubles.
int turn(const Point2& p, const Point2& q, const Point2& r, const Point2& s);

/// Sign of the determinant |q - p, r - p|: +1 if p, q, r run counterclockwise, that is, r lies left of the line p q.
///
/// Exactness: exact for all finite doubles.
inline int orientation(const Point2& p, const Point2& q, const Point2& r) {
  return turn(p, q, p, r);
}

}  // namespace gnomon::planar
