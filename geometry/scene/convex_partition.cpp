#include "geometry/scene/convex_partition.h"

#include <CGAL/Partition_traits_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/partition_2.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "geometry/kernel.h"
#include "geometry/spatial/polygon_checks.h"

namespace gnomon {
namespace {

using FlatPoint = InputKernel::Point_2;
using Traits = CGAL::Partition_traits_2<InputKernel, CGAL::Pointer_property_map<FlatPoint>::type>;

}  // namespace

std::vector<std::vector<std::uint32_t>> convex_partition(std::span<const Point3> polygon) {
  const int axis = polygon_plane(polygon)->dropped_axis;
  std::vector<FlatPoint> ring;
  ring.reserve(polygon.size());
  for (const Point3& p : polygon) {
    const Point2 q = projected(p, axis);
    ring.emplace_back(q.x, q.y);
  }
  std::vector<std::size_t> order(ring.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const bool clockwise = CGAL::orientation_2(ring.begin(), ring.end(), InputKernel()) == CGAL::CLOCKWISE;
  if (clockwise) std::reverse(order.begin(), order.end());
  std::vector<Traits::Polygon_2> pieces;
  CGAL::approx_convex_partition_2(order.begin(), order.end(), std::back_inserter(pieces),
                                  Traits(CGAL::make_property_map(ring)));
  std::vector<std::vector<std::uint32_t>> result;
  for (const Traits::Polygon_2& piece : pieces) {
    std::vector<std::uint32_t>& loop = result.emplace_back();
    for (const std::size_t i : piece.container()) loop.push_back(static_cast<std::uint32_t>(i));
    if (clockwise) std::reverse(loop.begin(), loop.end());
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace gnomon
