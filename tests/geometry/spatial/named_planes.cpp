#include "tests/geometry/spatial/named_planes.h"

#include <algorithm>
#include <tuple>

#include "apps/proof/laws/pair_generator.h"
#include "geometry/numbers/kernel.h"
#include "geometry/numbers/orientation.h"

namespace gnomon {
namespace {

using Points = std::vector<Point3>;

bool is_on(const HalfSpace& half_space, const Point3& p) {
  const auto& [a, b, c] = half_space.plane;
  return (half_space.third_is_direction ? exact_direction_side(a, b, p, c) : exact_orientation(a, b, c, p)) == 0;
}

bool is_on_edge(const HalfSpace& half_space, const Point3& p) {
  return CGAL::collinear(to_cgal(half_space.plane[0]), to_cgal(half_space.plane[1]), to_cgal(p));
}

bool has_light_edge(const HalfSpace& half_space) {
  return half_space.name.kind == FacetKind::separating_light_plane;
}

bool is_facet(const HalfSpace& half_space) {
  return half_space.name.kind == FacetKind::blocker_face || half_space.name.kind == FacetKind::light_plane;
}

bool touches(const HalfSpace& half_space, const Point3& p) {
  return half_space.third_is_direction || (is_on(half_space, p) && !is_on_edge(half_space, p));
}

using Ends = std::pair<Point3, Point3>;

bool has_ends(const HalfSpace& half_space, const Ends& edge) {
  const auto& [a, b, c] = half_space.plane;
  return edge == Ends(a, b) || edge == Ends(b, a);
}

std::vector<Ends> edges_of(const Points& loop) {
  std::vector<Ends> edges;
  for (std::size_t i = 0; i < loop.size(); ++i) edges.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
  return edges;
}

/// The edges that names count: of a polygon those between its vertices, of a solid its own.
std::vector<Ends> edges_of(const ConvexBlocker& blocker) {
  const auto* solid = std::get_if<ConvexSolid>(&blocker);
  if (!solid) return edges_of(points_of(blocker));
  std::vector<Ends> edges;
  for (const auto& edge : solid->edges()) edges.emplace_back(solid->points()[edge.from], solid->points()[edge.to]);
  return edges;
}

bool is_rounded(const Light& light) {
  const auto* area = std::get_if<AreaLight>(&light);
  return area && !area->polygon.is_flat();
}

/// The points that names count, each in its place: all of a polygon's, of a solid's (which a rounded polygon stands
/// for) the corners.
using Vertices = std::vector<std::optional<Point3>>;

Vertices corners_of(const ConvexSolid& solid) {
  Vertices result(solid.points().size());
  for (const std::uint32_t i : solid.corners()) result[i] = solid.points()[i];
  return result;
}

Vertices vertices_of(const Light& light) {
  const Points points = points_of(light);
  return is_rounded(light) ? corners_of(ConvexSolid::hull_of(points)) : Vertices(points.begin(), points.end());
}

Vertices vertices_of(const ConvexBlocker& blocker) {
  const Points points = points_of(blocker);
  const auto* solid = std::get_if<ConvexSolid>(&blocker);
  return solid ? corners_of(*solid) : Vertices(points.begin(), points.end());
}

template <class Element, class Claim>
std::optional<std::uint32_t> lowest(const std::vector<Element>& elements, Claim claim) {
  const auto found = std::find_if(elements.begin(), elements.end(), claim);
  if (found == elements.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - elements.begin());
}

}  // namespace

std::vector<Point3> points_of(const Light& light) {
  if (const auto* direction = std::get_if<DirectionalLight>(&light)) return {direction->direction};
  return laws::light_points(light);
}

std::vector<Point3> points_of(const ConvexBlocker& blocker) {
  const auto points = std::visit([](const auto& shape) { return shape.points(); }, blocker);
  return {points.begin(), points.end()};
}

bool is_before(const Point3& a, const Point3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

bool is_before(const NamedPlane& a, const NamedPlane& b) {
  const auto less = [](const Points& p, const Points& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end(),
                                        [](const Point3& u, const Point3& v) { return is_before(u, v); });
  };
  if (a.kind != b.kind) return a.kind < b.kind;
  return a.edge == b.edge ? less(a.touching, b.touching) : less(a.edge, b.edge);
}

void sort_distinct(std::vector<Point3>& points) {
  std::sort(points.begin(), points.end(), [](const Point3& a, const Point3& b) { return is_before(a, b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

NamedPlane named_plane(const Light& light, const ConvexBlocker& blocker, const HalfSpace& half_space) {
  NamedPlane result{half_space.name.kind, {}, {}};
  const Points of_light = points_of(light);
  const Points of_blocker = points_of(blocker);
  const bool owned_by_light = has_light_edge(half_space) || half_space.name.kind == FacetKind::light_plane;
  for (const Point3& p : owned_by_light ? of_light : of_blocker) {
    if (is_facet(half_space) ? is_on(half_space, p) : is_on_edge(half_space, p)) {
      (is_facet(half_space) ? result.touching : result.edge).push_back(p);
    }
  }
  for (const Point3& p : owned_by_light ? of_blocker : of_light) {
    if (!is_facet(half_space) && touches(half_space, p)) result.touching.push_back(p);
  }
  sort_distinct(result.edge);
  sort_distinct(result.touching);
  return result;
}

bool is_same_plane(const HalfSpace& a, const HalfSpace& b) {
  const auto& [p, q, r] = b.plane;
  if (!is_on(a, p) || !is_on(a, q)) return false;
  if (!b.third_is_direction) return is_on(a, r);
  return a.third_is_direction ? a.plane[2] == r : exact_direction_side(a.plane[0], a.plane[1], a.plane[2], r) == 0;
}

bool names_lowest(const Light& light, const ConvexBlocker& blocker, const HalfSpace& half_space) {
  if (is_facet(half_space)) return true;
  const auto other = has_light_edge(half_space) ? vertices_of(blocker) : vertices_of(light);
  const std::vector<Ends> edges = has_light_edge(half_space) ? edges_of(points_of(light)) : edges_of(blocker);
  const auto lies_on_line = [&](const Ends& edge) {
    if (has_light_edge(half_space) && is_rounded(light)) return has_ends(half_space, edge);
    return is_on_edge(half_space, edge.first) && is_on_edge(half_space, edge.second);
  };
  return half_space.name.edge_index == lowest(edges, lies_on_line) &&
         half_space.name.vertex_index ==
             lowest(other, [&](const std::optional<Point3>& p) { return p && touches(half_space, *p); });
}

}  // namespace gnomon
