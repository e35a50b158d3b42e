#include "geometry/scene/convex_partition.h"

#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/scene/flat_ring.h"
#include "geometry/scene/ring_triangles.h"

namespace gnomon {
namespace {

using Traits = CGAL::Partition_traits_2<InputKernel, CGAL::Pointer_property_map<InputKernel::Point_2>::type>;

/// The pieces of a polygon without holes, whose ring runs counterclockwise.
std::vector<Ring> pieces_of(FlatRing& points, const Ring& ring) {
  const std::vector<std::size_t> order(ring.begin(), ring.end());
  std::vector<Traits::Polygon_2> polygons;
  CGAL::approx_convex_partition_2(order.begin(), order.end(), std::back_inserter(polygons),
                                  Traits(CGAL::make_property_map(points)));
  std::vector<Ring> pieces;
  for (const Traits::Polygon_2& polygon : polygons) {
    pieces.emplace_back();
    for (const std::size_t i : polygon.container()) pieces.back().push_back(static_cast<std::uint32_t>(i));
  }
  return pieces;
}

/// The fan from the first vertex; nothing if one of its triangles does not turn to the left.
std::optional<std::vector<Ring>> fan(const FlatRing& points, const Ring& ring) {
  std::vector<Ring> triangles;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    triangles.push_back({ring[0], ring[i - 1], ring[i]});
    if (CGAL::orientation(points[ring[0]], points[ring[i - 1]], points[ring[i]]) != CGAL::LEFT_TURN) {
      return std::nullopt;
    }
  }
  return triangles;
}

}  // namespace

std::vector<Ring> convex_partition(std::span<const Point3> points, std::vector<Ring> rings) {
  const PolygonPlane plane = *polygon_plane(points_of_rings(points, rings));
  FlatRing flat = seen_along(plane.dropped_axis, points, whole_ring(points.size()));
  const bool clockwise = is_clockwise(seen_along(plane.dropped_axis, points, rings[0]));
  if (clockwise) std::reverse(rings[0].begin(), rings[0].end());
  std::vector<Ring> pieces;
  if (plane.flatness == Flatness::bent) {
    std::optional<std::vector<Ring>> triangles;
    // The first vertex of the file is the last one where the ring was turned round.
    if (clockwise) std::rotate(rings[0].begin(), rings[0].end() - 1, rings[0].end());
    if (rings.size() == 1) triangles = fan(flat, rings[0]);
    pieces = triangles ? std::move(*triangles) : ring_triangles(flat, rings);
  } else {
    pieces = rings.size() == 1 ? pieces_of(flat, rings[0]) : joined_triangles(flat, ring_triangles(flat, rings));
  }
  for (Ring& piece : pieces) {
    if (clockwise) std::reverse(piece.begin(), piece.end());
    std::rotate(piece.begin(), std::min_element(piece.begin(), piece.end()), piece.end());
  }
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

}  // namespace gnomon
