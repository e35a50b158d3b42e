#include "geometry/bodies/hull.h"

#include <unordered_map>

namespace gnomon {
namespace {

/// Adds the vertices between corner k and the next one.
void add_inside(Hull& hull, const ConvexPolygon& polygon, std::uint32_t k) {
  const auto size = static_cast<std::uint32_t>(polygon.points().size());
  const auto corners = polygon.corners();
  const std::uint32_t end = corners[(k + 1) % corners.size()];
  for (std::uint32_t i = (corners[k] + 1) % size; i != end; i = (i + 1) % size) {
    hull.inside.push_back({i, polygon.points()[i]});
  }
}

Hull flat_hull(const ConvexPolygon& polygon) {
  Hull hull;
  hull.flat = true;
  const auto size = static_cast<std::uint32_t>(polygon.corners().size());
  hull.facets.resize(2);
  for (std::uint32_t k = 0; k < size; ++k) {
    hull.index.push_back(polygon.corners()[k]);
    hull.corners.push_back(polygon.points()[polygon.corners()[k]]);
    const auto first = static_cast<std::uint32_t>(hull.inside.size());
    add_inside(hull, polygon, k);
    const auto last = static_cast<std::uint32_t>(hull.inside.size());
    hull.edges.push_back({k, (k + 1) % size, 0, 1, polygon.side_edge(k), first, last});
    hull.facets[0].loop.push_back(k);
  }
  hull.facets[1].loop.assign(hull.facets[0].loop.rbegin(), hull.facets[0].loop.rend());
  return hull;
}

Hull solid_hull(const ConvexSolid& solid) {
  Hull hull;
  std::unordered_map<std::uint32_t, std::uint32_t> corner;
  for (const std::uint32_t index : solid.corners()) {
    corner[index] = static_cast<std::uint32_t>(hull.index.size());
    hull.index.push_back(index);
    hull.corners.push_back(solid.points()[index]);
  }
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    Hull::Facet& added = hull.facets.emplace_back();
    for (const std::uint32_t index : facet.loop) added.loop.push_back(corner.at(index));
  }
  std::uint32_t name = 0;
  for (const ConvexSolid::Edge& edge : solid.edges()) {
    hull.edges.push_back({corner.at(edge.from), corner.at(edge.to), edge.left, edge.right, name++});
  }
  return hull;
}

/// The hull of a polygon whose vertices were rounded off their plane; its edges are named as the polygon's.
Hull rounded_hull(const ConvexPolygon& polygon) {
  const auto size = static_cast<std::uint32_t>(polygon.points().size());
  Hull hull = solid_hull(ConvexSolid::hull_of({polygon.points().begin(), polygon.points().end()}));
  for (Hull::Edge& edge : hull.edges) {
    const std::uint32_t a = hull.index[edge.from];
    const std::uint32_t b = hull.index[edge.to];
    edge.name = (a + 1) % size == b ? a : (b + 1) % size == a ? b : Hull::none;
  }
  return hull;
}

struct HullOf {
  Hull operator()(const PointLight& light) const {
    Hull hull;
    hull.corners = {light.position};
    hull.index = {0};
    return hull;
  }
  Hull operator()(const DirectionalLight& light) const {
    const auto& [x, y, z] = light.direction;
    Hull hull = (*this)(PointLight{{-x, -y, -z}});
    hull.at_infinity = true;
    return hull;
  }
  Hull operator()(const LinearLight& light) const {
    Hull hull;
    hull.corners = {light.start, light.end};
    hull.index = {0, 1};
    hull.edges = {{0, 1, Hull::none, Hull::none, 0}};
    return hull;
  }
  Hull operator()(const AreaLight& light) const { return (*this)(light.polygon); }
  Hull operator()(const ConvexPolygon& polygon) const {
    return polygon.is_flat() ? flat_hull(polygon) : rounded_hull(polygon);
  }
  Hull operator()(const ConvexSolid& blocker) const { return solid_hull(blocker); }
};

}  // namespace

Hull hull(const Light& light) {
  return std::visit(HullOf{}, light);
}

Hull hull(const ConvexBlocker& blocker) {
  return std::visit(HullOf{}, blocker);
}

}  // namespace gnomon
