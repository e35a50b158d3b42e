#include "geometry/scene/polygon_examination.h"

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/scene/flat_ring.h"
#include "geometry/scene/json_node.h"

namespace gnomon {
namespace {

PolygonRefusal crooked(const PolygonPlane& plane, std::uint32_t vertex) {
  return {
      vertex, "a vertex " + few_digits(plane.deviation) + " away from the polygon's plane",
      "at most 1e-2 of the polygon's diameter; cut it into triangles, or write a polytope if the hull of its points "
      "is meant"};
}

PolygonRefusal crossing(const std::string& edges) {
  return {{},
          "a boundary that crosses or touches itself" + (edges.empty() ? "" : " (" + edges + ")"),
          "a simple polygon, its vertices in order around it"};
}

/// A simple ring is convex if it turns one way only.
bool turns_one_way(const FlatRing& ring) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto turn = CGAL::orientation(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]);
    left = left || turn == CGAL::LEFT_TURN;
    right = right || turn == CGAL::RIGHT_TURN;
  }
  return !(left && right);
}

/// An edge of one of several rings.
struct RingEdge {
  InputKernel::Segment_2 segment;
  std::size_t ring;
  std::uint32_t vertex;
};

/// Edges of two rings that meet, or nothing. Edges are compared where the ranges of their first coordinates overlap.
std::optional<std::string> meeting_rings(const std::vector<FlatRing>& flat, const std::vector<Ring>& rings) {
  std::vector<RingEdge> edges;
  for (std::size_t r = 0; r < flat.size(); ++r) {
    for (std::size_t i = 0; i < flat[r].size(); ++i) {
      edges.push_back({{flat[r][i], flat[r][(i + 1) % flat[r].size()]}, r, rings[r][i]});
    }
  }
  std::ranges::sort(edges, {}, [](const RingEdge& edge) { return edge.segment.min().x(); });
  for (auto edge = edges.begin(); edge != edges.end(); ++edge) {
    for (auto other = edge + 1; other != edges.end() && other->segment.min().x() <= edge->segment.max().x(); ++other) {
      if (edge->ring == other->ring || !CGAL::do_intersect(edge->segment, other->segment)) continue;
      const auto [low, high] = std::minmax(edge->vertex, other->vertex);
      return "edges " + std::to_string(low) + " and " + std::to_string(high) + " meet";
    }
  }
  return std::nullopt;
}

bool lies_inside(const InputKernel::Point_2& point, const FlatRing& ring) {
  return CGAL::bounded_side_2(ring.begin(), ring.end(), point, InputKernel()) == CGAL::ON_BOUNDED_SIDE;
}

/// Rings that do not meet: the first has to hold the others, and these one another not. Where they hang together by
/// seams, as the first few do, a hole runs the other way round, or the boundary covers itself.
std::optional<PolygonRefusal> nesting_refusal(const std::vector<FlatRing>& flat, const std::vector<Ring>& rings,
                                              std::size_t by_seams) {
  const std::string expected = "holes inside of the outer boundary, apart from each other";
  for (std::size_t r = 1; r < flat.size(); ++r) {
    const std::uint32_t vertex = rings[r][0];
    if (!lies_inside(flat[r][0], flat[0])) return PolygonRefusal{vertex, "a ring beside the outer one", expected};
    if (r < by_seams && is_clockwise(flat[r]) == is_clockwise(flat[0])) {
      return PolygonRefusal{vertex, "a boundary that goes round twice here", expected};
    }
    for (std::size_t other = 1; other < flat.size(); ++other) {
      if (other == r || !lies_inside(flat[r][0], flat[other])) continue;
      return PolygonRefusal{vertex, "a hole inside of another", expected};
    }
  }
  return std::nullopt;
}

/// Rings that lie near one plane.
std::optional<PolygonRefusal> boundary_refusal(std::span<const Point3> points, PolygonExamination& polygon,
                                               std::size_t by_seams) {
  std::vector<FlatRing> flat;
  for (const Ring& ring : polygon.rings) {
    flat.push_back(seen_along(polygon.plane.dropped_axis, points, ring));
    if (!is_simple(flat.back())) return crossing(crossing_edges(flat.back(), ring));
  }
  polygon.is_convex = turns_one_way(flat[0]);
  if (flat.size() == 1) return std::nullopt;
  if (const auto edges = meeting_rings(flat, polygon.rings)) return crossing(*edges);
  return nesting_refusal(flat, polygon.rings, by_seams);
}

/// Rings that share a vertex, or an edge that runs back to one.
PolygonRefusal touching(std::span<const Point3> points, const Ring& vertices) {
  const std::optional<RepeatedVertex> found = repeated_vertex(points_of_rings(points, {&vertices, 1}));
  return found ? repeated_refusal(points, vertices[found->vertex], vertices[found->other]) : crossing("");
}

/// The rings of a boundary that has an area, or why it has none.
std::optional<PolygonRefusal> area_refusal(std::span<const Point3> points, const Ring& boundary,
                                           PolygonExamination& polygon) {
  if (boundary.size() < 3) {
    polygon.has_area = false;
    return too_few_refusal(boundary.size());
  }
  std::optional<std::vector<Ring>> rings = without_seams(points, boundary);
  if (!rings) return touching(points, boundary);
  polygon.rings = std::move(*rings);
  polygon.has_area = !polygon.rings.empty();
  if (!polygon.has_area) return touching(points, boundary);
  if (polygon_plane(points_of_rings(points, polygon.rings))) return std::nullopt;
  polygon.has_area = false;
  return collinear_refusal();
}

std::optional<PolygonRefusal> refusal_of(std::span<const Point3> points, const Ring& boundary,
                                         const std::vector<Ring>& holes, PolygonExamination& polygon) {
  if (auto refusal = area_refusal(points, boundary, polygon)) return refusal;
  const std::size_t by_seams = polygon.rings.size();
  for (const Ring& hole : holes) {
    if (hole.size() < 3) return too_few_refusal(hole.size());
    polygon.rings.push_back(hole);
  }
  const std::vector<Point3> vertices = points_of_rings(points, polygon.rings);
  Ring names;
  for (const Ring& ring : polygon.rings) names.insert(names.end(), ring.begin(), ring.end());
  if (repeated_vertex(vertices)) return touching(points, names);
  polygon.plane = *polygon_plane(vertices);
  if (polygon.plane.flatness == Flatness::crooked) return crooked(polygon.plane, names[polygon.plane.farthest]);
  if (polygon.rings.size() == 1 && names.size() == 3) {
    polygon.is_convex = true;
    return std::nullopt;
  }
  put_outer_ring_first(points, polygon.plane.dropped_axis, polygon.rings);
  return boundary_refusal(points, polygon, by_seams);
}

}  // namespace

PolygonExamination examined_polygon(std::span<const Point3> points, const Ring& boundary,
                                    const std::vector<Ring>& holes) {
  PolygonExamination polygon;
  polygon.refusal = refusal_of(points, boundary, holes, polygon);
  return polygon;
}

}  // namespace gnomon
