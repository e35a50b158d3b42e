#include "shading/illumination/touching_places.h"

#include <map>
#include <set>

#include "geometry/numbers/orientation.h"
#include "geometry/numbers/rounding.h"
#include "shading/illumination/outlines.h"
#include "shading/illumination/receiver_traces.h"
#include "shading/illumination/vertex_places.h"

namespace gnomon::illumination {
namespace {

/// Where the line from one point to another, which are on different sides of a plane, meets it.
ExactVector crossing_with(const Point3& from, const Point3& to, const ExactVector& origin, const ExactVector& normal) {
  const ExactVector a = exact(from), b = exact(to);
  const Rational above = dot(normal, a - origin), below = dot(normal, b - origin);
  return a + Rational(above / (above - below)) * (b - a);
}

}  // namespace

std::vector<Body> touching_bodies(std::span<const Light> lights, std::span<const ConvexBlocker> blockers) {
  std::vector<Body> bodies;
  for (const Light& light : lights) {
    if (!std::holds_alternative<DirectionalLight>(light)) bodies.push_back(body(light));
  }
  for (const ConvexBlocker& blocker : blockers) bodies.push_back(body(blocker));
  return bodies;
}

std::vector<ExactVector> touching_places(std::span<const Body> bodies, const ConvexPolygon& receiver) {
  const auto corner = [&](std::size_t k) { return receiver.points()[receiver.corners()[k]]; };
  const ExactVector origin = exact(corner(0));
  const ExactVector normal = cross(exact(corner(1)) - origin, exact(corner(2)) - origin);
  std::vector<ExactVector> found;
  const auto side = [&](const Point3& p) { return exact_orientation(corner(0), corner(1), corner(2), p); };
  const auto add = [&](const ExactVector& p) {
    if (is_on(receiver, near_point(p))) found.push_back(p);
  };
  for (const Body& body : bodies) {
    std::vector<int> sides;
    for (const Point3& p : body.corners) {
      sides.push_back(side(p));
      if (sides.back() == 0) add(exact(p));
    }
    for (const Body::InsideVertex& vertex : body.inside) {
      if (side(vertex.point) == 0) add(exact(vertex.point));
    }
    for (const Body::Edge& edge : body.edges) {
      if (edge.name == Body::none || sides[edge.from] * sides[edge.to] >= 0) continue;
      add(crossing_with(body.corners[edge.from], body.corners[edge.to], origin, normal));
    }
  }
  return found;
}

std::vector<Point3> corners_of_jumps(const ReceiverMesh& mesh) {
  const VertexPlaces places(mesh);
  std::map<std::uint32_t, ExactVector> along;  // of a vertex, the first such line that ends there
  std::set<std::uint32_t> corners;
  for (const MeshEdge& edge : mesh.edges()) {
    if (order_of(mesh, edge) != 0) continue;
    const ExactVector way = places.at(edge.target) - places.at(edge.source);
    for (const std::uint32_t v : {edge.source, edge.target}) {
      const auto [first, is_new] = along.try_emplace(v, way);
      if (!is_new && !is_zero(cross(first->second, way))) corners.insert(v);
    }
  }
  std::vector<Point3> found;
  for (const std::uint32_t v : corners) found.push_back(nearest_point(places.at(v)));
  return found;
}

Point3 nearest_point(const ExactVector& p) {
  return {nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)};
}

}  // namespace gnomon::illumination
