#include "geometry/scene/flat_ring.h"

#include <CGAL/Polygon_2_algorithms.h>

#include "geometry/bodies/polygon_checks.h"

namespace gnomon {

FlatRing seen_along(int dropped_axis, std::span<const Point3> points, const Ring& ring) {
  FlatRing flat;
  flat.reserve(ring.size());
  for (const std::uint32_t i : ring) {
    const Point2 q = projected(points[i], dropped_axis);
    flat.emplace_back(q.x, q.y);
  }
  return flat;
}

bool is_simple(const FlatRing& ring) {
  return CGAL::is_simple_2(ring.begin(), ring.end(), InputKernel());
}

bool is_clockwise(const FlatRing& ring) {
  return CGAL::orientation_2(ring.begin(), ring.end(), InputKernel()) == CGAL::CLOCKWISE;
}

std::string crossing_edges(const FlatRing& ring, const Ring& names) {
  using Segment = InputKernel::Segment_2;
  const std::size_t n = ring.size();
  constexpr std::size_t longest = 2000;
  for (std::size_t j = 0; j < n && n <= longest; ++j) {
    const Segment second(ring[j], ring[(j + 1) % n]);
    for (std::size_t i = 0; i < j; ++i) {
      const bool neighbours = i + 1 == j || (i == 0 && j + 1 == n);
      if (neighbours || !CGAL::do_intersect(Segment(ring[i], ring[(i + 1) % n]), second)) continue;
      return "edges " + std::to_string(names[i]) + " and " + std::to_string(names[j]) + " meet";
    }
  }
  return "edges meet";
}

}  // namespace gnomon
