#include "gnomon/blocker.h"

#include <vector>

namespace gnomon {

ConvexBlocker convex_blocker(const ConvexPolygon& polygon) {
  if (polygon.is_flat()) return polygon;
  return ConvexSolid::hull_of(std::vector<Point3>(polygon.points().begin(), polygon.points().end()));
}

}  // namespace gnomon
