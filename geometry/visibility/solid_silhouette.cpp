#include <algorithm>

#include "geometry/numbers/orientation.h"
#include "geometry/visibility/silhouette_builder.h"

// What SilhouetteBuilder does with solids: they show their silhouette, and hide from within.
namespace gnomon::viewpoint {
namespace {

/// An edge between a facet that shows itself to the apex and one that does not.
struct SolidEdge {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t name;
};

/// The silhouette in order around the solid; empty if no facet shows itself: the apex lies in the solid.
std::vector<SolidEdge> silhouette_of(const Point3& apex, const ConvexSolid& solid) {
  const std::span<const Point3> points = solid.points();
  std::vector<bool> shows;
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    const auto& loop = facet.loop;
    shows.push_back(exact_orientation(points[loop[0]], points[loop[1]], points[loop[2]], apex) > 0);
  }
  std::vector<SolidEdge> edges;
  for (std::uint32_t e = 0; e < solid.edges().size(); ++e) {
    const ConvexSolid::Edge& edge = solid.edges()[e];
    if (shows[edge.left] == shows[edge.right]) continue;
    edges.push_back(shows[edge.left] ? SolidEdge{edge.from, edge.to, e} : SolidEdge{edge.to, edge.from, e});
  }
  for (std::size_t k = 0; k + 2 < edges.size(); ++k) {
    const auto next = std::find_if(edges.begin() + static_cast<std::ptrdiff_t>(k) + 1, edges.end(),
                                   [&](const SolidEdge& edge) { return edge.from == edges[k].to; });
    std::iter_swap(edges.begin() + static_cast<std::ptrdiff_t>(k) + 1, next);
  }
  return edges;
}

}  // namespace

/// Near the apex the solid is what lies behind all facets through it; a segment meets the solid if it starts into that.
Outcome SilhouetteBuilder::from_inside(const ConvexSolid& solid) const {
  const std::span<const Point3> points = solid.points();
  bool covers = true;
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    const auto side_of = [&](const Point3& p) {
      return exact_orientation(points[facet.loop[0]], points[facet.loop[1]], points[facet.loop[2]], p);
    };
    if (side_of(apex_) != 0) continue;
    bool apart = true;
    bool along = extent_ == Extent::length;
    for (const Point3& corner : light_corners_) {
      const int side = side_of(corner);
      apart = apart && side >= 0;
      along = along && side == 0;
      covers = covers && side <= 0;
    }
    if (apart && !along) return Outcome::apart;
  }
  return covers ? Outcome::covers : Outcome::undecided;
}

/// True if the light lies beyond every facet that shows itself to the apex, or in its plane; a linear light not wholly
/// in it.
bool SilhouetteBuilder::light_beyond_all_shown(const ConvexSolid& solid) const {
  const std::span<const Point3> points = solid.points();
  return std::all_of(solid.facets().begin(), solid.facets().end(), [&](const ConvexSolid::Facet& facet) {
    const auto side_of = [&](const Point3& p) {
      return exact_orientation(points[facet.loop[0]], points[facet.loop[1]], points[facet.loop[2]], p);
    };
    if (side_of(apex_) <= 0) return true;
    bool any_beyond = extent_ == Extent::area;
    for (const Point3& corner : light_corners_) {
      const int side = side_of(corner);
      if (side > 0) return false;
      any_beyond = any_beyond || side < 0;
    }
    return any_beyond;
  });
}

/// A facet seen edge-on leaves several edges in one plane; their common vertices are no rays of the silhouette.
Outcome SilhouetteBuilder::append_solid(const ConvexSolid& solid, std::uint32_t element) {
  const std::span<const Point3> points = solid.points();
  const std::vector<SolidEdge> edges = silhouette_of(apex_, solid);
  if (edges.empty()) return from_inside(solid);
  first_ = static_cast<std::uint32_t>(silhouettes_.rays.size());
  std::vector<std::uint32_t> names;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const SolidEdge& before = edges[k == 0 ? edges.size() - 1 : k - 1];
    if (exact_orientation(apex_, points[before.from], points[edges[k].from], points[edges[k].to]) == 0) continue;
    silhouettes_.rays.emplace_back(apex_, points[edges[k].from]);
    names.push_back(edges[k].name);
  }
  if (certainly_outside() || certainly_behind_apex()) return dropped();
  // What bulges between the silhouette and the apex, or away from it, may lie on the light's other side.
  std::vector<Ray> corners;
  for (const std::uint32_t i : solid.corners()) corners.emplace_back(apex_, points[i]);
  const Depth depth = depth_of(corners);
  if (depth == Depth::behind) return dropped();
  append_counterclockwise(names);
  const bool decided = !runs_along_light(corners) && (depth == Depth::in_front || light_beyond_all_shown(solid));
  const Outcome outcome = finished(element);
  return decided || outcome == Outcome::apart ? outcome : Outcome::undecided;
}

}  // namespace gnomon::viewpoint
