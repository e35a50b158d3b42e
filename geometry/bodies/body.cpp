#include "geometry/bodies/body.h"

#include <unordered_map>

namespace gnomon {
namespace {

/// Adds the vertices between corner k and the next one.
void add_inside(Body& body, const ConvexPolygon& polygon, std::uint32_t k) {
  const auto size = static_cast<std::uint32_t>(polygon.points().size());
  const auto corners = polygon.corners();
  const std::uint32_t end = corners[(k + 1) % corners.size()];
  for (std::uint32_t i = (corners[k] + 1) % size; i != end; i = (i + 1) % size) {
    body.inside.push_back({i, polygon.points()[i]});
  }
}

Body flat_body(const ConvexPolygon& polygon) {
  Body body;
  body.flat = true;
  const auto size = static_cast<std::uint32_t>(polygon.corners().size());
  body.facets.resize(2);
  for (std::uint32_t k = 0; k < size; ++k) {
    body.index.push_back(polygon.corners()[k]);
    body.corners.push_back(polygon.points()[polygon.corners()[k]]);
    const auto first = static_cast<std::uint32_t>(body.inside.size());
    add_inside(body, polygon, k);
    const auto last = static_cast<std::uint32_t>(body.inside.size());
    body.edges.push_back({k, (k + 1) % size, 0, 1, polygon.side_edge(k), first, last});
    body.facets[0].loop.push_back(k);
  }
  body.facets[1].loop.assign(body.facets[0].loop.rbegin(), body.facets[0].loop.rend());
  return body;
}

Body solid_body(const ConvexSolid& solid) {
  Body body;
  std::unordered_map<std::uint32_t, std::uint32_t> corner;
  for (const std::uint32_t index : solid.corners()) {
    corner[index] = static_cast<std::uint32_t>(body.index.size());
    body.index.push_back(index);
    body.corners.push_back(solid.points()[index]);
  }
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    Body::Facet& added = body.facets.emplace_back();
    for (const std::uint32_t index : facet.loop) added.loop.push_back(corner.at(index));
  }
  std::uint32_t name = 0;
  for (const ConvexSolid::Edge& edge : solid.edges()) {
    body.edges.push_back({corner.at(edge.from), corner.at(edge.to), edge.left, edge.right, name++});
  }
  return body;
}

/// The hull of a polygon whose vertices were rounded off their plane; its edges are named as the polygon's.
Body rounded_body(const ConvexPolygon& polygon) {
  const auto size = static_cast<std::uint32_t>(polygon.points().size());
  Body body = solid_body(ConvexSolid::hull_of({polygon.points().begin(), polygon.points().end()}));
  for (Body::Edge& edge : body.edges) {
    const std::uint32_t a = body.index[edge.from];
    const std::uint32_t b = body.index[edge.to];
    edge.name = (a + 1) % size == b ? a : (b + 1) % size == a ? b : Body::none;
  }
  return body;
}

struct BodyOf {
  Body operator()(const PointLight& light) const {
    Body body;
    body.corners = {light.position};
    body.index = {0};
    return body;
  }
  Body operator()(const DirectionalLight& light) const {
    const auto& [x, y, z] = light.direction;
    Body body = (*this)(PointLight{{-x, -y, -z}});
    body.at_infinity = true;
    return body;
  }
  Body operator()(const LinearLight& light) const {
    Body body;
    body.corners = {light.start, light.end};
    body.index = {0, 1};
    body.edges = {{0, 1, Body::none, Body::none, 0}};
    return body;
  }
  Body operator()(const AreaLight& light) const { return (*this)(light.polygon); }
  Body operator()(const ConvexPolygon& polygon) const {
    return polygon.is_flat() ? flat_body(polygon) : rounded_body(polygon);
  }
  Body operator()(const ConvexSolid& blocker) const { return solid_body(blocker); }
};

struct PointsOf {
  std::vector<Point3> operator()(const PointLight& light) const { return {light.position}; }
  std::vector<Point3> operator()(const DirectionalLight&) const { return {}; }
  std::vector<Point3> operator()(const LinearLight& light) const { return {light.start, light.end}; }
  std::vector<Point3> operator()(const AreaLight& light) const {
    return {light.polygon.points().begin(), light.polygon.points().end()};
  }
};

}  // namespace

std::vector<Point3> light_points(const Light& light) {
  return std::visit(PointsOf{}, light);
}

Body body(const Light& light) {
  return std::visit(BodyOf{}, light);
}

Body body(const ConvexBlocker& blocker) {
  return std::visit(BodyOf{}, blocker);
}

}  // namespace gnomon
