#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "gnomon/point.h"

namespace gnomon {

/// Sign (-1, 0, +1) of the determinant |q - p, r - p, s - p|: +1 if p, q, r run counterclockwise seen from s.
///
/// Exactness: exact for all finite doubles.
int exact_orientation(const Point3& p, const Point3& q, const Point3& r, const Point3& s);

/// Sign of the determinant |q - p, r - p, v|: the side on which a point infinitely far away in the direction v lies of
/// the plane through p, q, r, which run counterclockwise seen from its positive side.
///
/// Exactness: exact for all finite doubles.
int exact_direction_side(const Point3& p, const Point3& q, const Point3& r, const Point3& v);

/// The sign of exact_orientation for points of one fixed box, filtered by an error bound that is computed once.
///
/// Bound. Let D = X Y Z be the product of the box's sides. Every difference of coordinates is at most a side, so the
/// sum of the absolute values of the determinant's six products is at most 6 D. Evaluated in doubles (unit roundoff u,
/// no contraction, no underflow) the determinant errs by at most (7 + 56 u) u times that sum, after the analysis of
/// Shewchuk's orient3d, hence by less than 43 u D, which also covers the rounding of X, Y, Z and D.
/// Underflow errs by at most 2^-1074 times a side in each of twelve products; D >= 1e-200 and sides <= 1e60 keep that
/// far below u D. Outside these limits the bound is infinite and every sign is taken exactly.
class OrientationFilter {
 public:
  /// Extends the box.
  void include(std::span<const Point3> points) {
    for (const Point3& p : points) include(p);
  }
  void include(const Point3& p) {
    min_ = {std::min(min_.x, p.x), std::min(min_.y, p.y), std::min(min_.z, p.z)};
    max_ = {std::max(max_.x, p.x), std::max(max_.y, p.y), std::max(max_.z, p.z)};
  }

  /// Computes the bound; call once after the last include.
  void close() {
    const double x = max_.x - min_.x;
    const double y = max_.y - min_.y;
    const double z = max_.z - min_.z;
    const double product = x * y * z;
    const bool safe = product >= 1e-200 && x <= 1e60 && y <= 1e60 && z <= 1e60;
    bound_ = safe ? 43 * 0x1p-53 * product : HUGE_VAL;
  }

  /// Requires: all four points were included.
  int operator()(const Point3& p, const Point3& q, const Point3& r, const Point3& s) const {
    const double qx = q.x - p.x, qy = q.y - p.y, qz = q.z - p.z;
    const double rx = r.x - p.x, ry = r.y - p.y, rz = r.z - p.z;
    const double sx = s.x - p.x, sy = s.y - p.y, sz = s.z - p.z;
    const double det = qx * (ry * sz - rz * sy) + qy * (rz * sx - rx * sz) + qz * (rx * sy - ry * sx);
    if (det > bound_) return 1;
    if (det < -bound_) return -1;
    return exact_orientation(p, q, r, s);
  }

  /// The plane through three included points, for many signs.
  ///
  /// The normal is the determinant's three minors, each the rounded difference of two products: the bound holds as it
  /// stands, for the analysis treats all three rows of the determinant alike.
  class Plane {
   public:
    /// As orientation(p, q, r, s).
    int side(const Point3& s) const {
      const double det = (s.x - p_.x) * normal_.x + (s.y - p_.y) * normal_.y + (s.z - p_.z) * normal_.z;
      if (det > bound_) return 1;
      if (det < -bound_) return -1;
      return exact_orientation(p_, q_, r_, s);
    }

   private:
    friend class OrientationFilter;
    Plane(const Point3& p, const Point3& q, const Point3& r, double bound) : p_(p), q_(q), r_(r), bound_(bound) {
      const double qx = q.x - p.x, qy = q.y - p.y, qz = q.z - p.z;
      const double rx = r.x - p.x, ry = r.y - p.y, rz = r.z - p.z;
      normal_ = {qy * rz - qz * ry, qz * rx - qx * rz, qx * ry - qy * rx};
    }

    Point3 p_, q_, r_, normal_;
    double bound_;
  };
  Plane plane(const Point3& p, const Point3& q, const Point3& r) const { return {p, q, r, bound_}; }

 private:
  Point3 min_{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Point3 max_{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  double bound_ = HUGE_VAL;
};

}  // namespace gnomon
