#include "geometry/numbers/orientation.h"

#include <CGAL/determinant.h>

#include "geometry/numbers/kernel.h"

namespace gnomon {

int exact_orientation(const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
  return static_cast<int>(CGAL::orientation(to_cgal(p), to_cgal(q), to_cgal(r), to_cgal(s)));
}

namespace {

template <class Number>
Number direction_determinant(const Point3& p, const Point3& q, const Point3& r, const Point3& v) {
  const Number x(p.x), y(p.y), z(p.z);
  return CGAL::determinant<Number>(Number(q.x) - x, Number(q.y) - y, Number(q.z) - z,  //
                                   Number(r.x) - x, Number(r.y) - y, Number(r.z) - z,  //
                                   Number(v.x), Number(v.y), Number(v.z));
}

}  // namespace

int exact_direction_side(const Point3& p, const Point3& q, const Point3& r, const Point3& v) {
  {
    const CGAL::Protect_FPU_rounding<true> protection;
    const Interval d = direction_determinant<Interval>(p, q, r, v);
    if (d.inf() > 0) return 1;
    if (d.sup() < 0) return -1;
  }
  return static_cast<int>(CGAL::sign(direction_determinant<CGAL::Mpzf>(p, q, r, v)));
}

}  // namespace gnomon
