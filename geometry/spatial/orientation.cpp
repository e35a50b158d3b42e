#include "geometry/spatial/orientation.h"

#include "geometry/kernel.h"

namespace gnomon {

int exact_orientation(const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
  return static_cast<int>(CGAL::orientation(to_cgal(p), to_cgal(q), to_cgal(r), to_cgal(s)));
}

}  // namespace gnomon
