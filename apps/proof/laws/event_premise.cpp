#include "apps/proof/laws/event_premise.h"

#include <algorithm>
#include <array>
#include <limits>

#include "apps/proof/laws/definition.h"
#include "apps/proof/laws/pair_generator.h"
#include "geometry/numbers/rounding.h"

namespace gnomon::laws {
namespace {

using Polygon = std::vector<ExactVector>;

/// The part of the closed segment, as shares of the way, in a closed convex set; nothing if they do not meet.
std::optional<std::array<Rational, 2>> contact(const Walls& blocker, const ExactVector& start,
                                               const ExactVector& along) {
  Rational from = 0, to = 1;
  for (const ExactPlane& wall : blocker) {
    const Rational at = wall.height(start), rise = dot(wall.normal, along);
    if (sign(rise) == 0) {
      if (sign(at) > 0) return std::nullopt;
      continue;
    }
    const Rational zero = -at / rise;
    if (sign(rise) > 0) to = std::min(to, zero);
    if (sign(rise) < 0) from = std::max(from, zero);
    if (from > to) return std::nullopt;
  }
  return std::array{from, to};
}

const LinedUp* element_of(const EventCase& drawn, int of) {
  const auto found = std::ranges::find(drawn.elements, of, &LinedUp::of);
  return found == drawn.elements.end() ? nullptr : &*found;
}

Polygon points_of(const EventCase& drawn, int of) {
  if (of < 0) return vertices(drawn.light);
  return std::visit([](const auto& shape) { return exact(shape.points()); }, drawn.blockers[std::size_t(of)]);
}

/// The vertices next to one of a shape.
Polygon neighbours(const EventCase& drawn, int of, std::uint32_t vertex) {
  const Polygon points = points_of(drawn, of);
  const auto* solid = of < 0 ? nullptr : std::get_if<ConvexSolid>(&drawn.blockers[std::size_t(of)]);
  if (!solid) {
    const std::size_t n = points.size();
    return n == 2 ? Polygon{points[1 - vertex]} : Polygon{points[(vertex + 1) % n], points[(vertex + n - 1) % n]};
  }
  Polygon result;
  for (const ConvexSolid::Edge& e : solid->edges()) {
    if (e.from == vertex) result.push_back(points[e.to]);
    if (e.to == vertex) result.push_back(points[e.from]);
  }
  return result;
}

ExactVector direction_of(const LinedUp& edge) {
  return exact(edge.points[1]) - exact(edge.points[0]);
}

const LinedUp& only(const EventCase& drawn, OnLine what) {
  return *std::ranges::find(drawn.elements, what, &LinedUp::what);
}

/// The determinant of the planes through the path's points and three edges, as a polynomial of degree 3 in t.
std::array<Rational, 4> determinant(const EventScene& scene) {
  std::array<ExactVector, 3> at, rise;
  std::size_t k = 0;
  for (const LinedUp& element : scene.drawn.elements) {
    if (element.what != OnLine::edge) continue;
    const ExactVector a = exact(element.points[0]) - scene.path.start, b = exact(element.points[1]) - scene.path.start;
    at[k] = cross(a, b);
    rise[k] = cross(scene.path.direction, a - b);
    ++k;
  }
  const auto det = [](const ExactVector& a, const ExactVector& b, const ExactVector& c) { return dot(cross(a, b), c); };
  return {det(at[0], at[1], at[2]),
          Rational(det(rise[0], at[1], at[2]) + det(at[0], rise[1], at[2]) + det(at[0], at[1], rise[2])),
          Rational(det(rise[0], rise[1], at[2]) + det(rise[0], at[1], rise[2]) + det(at[0], rise[1], rise[2])),
          det(rise[0], rise[1], rise[2])};
}

/// True if two edges at the vertex are seen on one line: no corner is seen then.
bool sees_edges_on_one_line(const Polygon& edges, const ExactVector& along) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (is_zero(cross(cross(edges[i], along), cross(edges[j], along)))) return true;
    }
  }
  return false;
}

/// The normals of the planes of the line of sight and each edge in line.
Polygon normals_of_edges(const EventScene& scene) {
  Polygon normals;
  for (const LinedUp& element : scene.drawn.elements) {
    if (element.what == OnLine::edge) normals.push_back(cross(scene.along, direction_of(element)));
  }
  return normals;
}

}  // namespace

EventScene::EventScene(const EventCase& one)
    : drawn(one), along(exact(one.on_light) - exact(one.point)), path{exact(one.point), exact(one.direction)} {
  for (const ConvexBlocker& blocker : one.blockers) blockers.push_back(walls(blocker));
  const Rational little(1, Integer(1) << 60);
  // By different shares, so that no edge that is seen to start on the line of sight passes through a vertex by chance.
  int share = 1009;
  for (const ExactVector& l : vertices(one.light)) {
    near_light.push_back(exact(one.on_light) + Rational(little * share / 1009) * (l - exact(one.on_light)));
    share += 17;
  }
  plane = plane_through(path.start, path.start + along, path.start + exact(one.across));
}

bool is_seen_alone(const EventScene& scene) {
  if (const auto* area = std::get_if<AreaLight>(&scene.drawn.light)) {
    const int side = plane_of(vertices(scene.drawn.light)).side(scene.path.start);
    if (area->two_sided ? side == 0 : side <= 0) return false;
  } else {
    const Polygon ends = vertices(scene.drawn.light);
    if (is_zero(cross(ends[1] - ends[0], scene.along))) return false;
  }
  for (std::size_t i = 0; i < scene.blockers.size(); ++i) {
    const LinedUp* element = element_of(scene.drawn, int(i));
    const auto met = contact(scene.blockers[i], scene.path.start, scene.along);
    if (met.has_value() != (element != nullptr)) return false;
    if (!met) continue;
    const auto& [from, to] = *met;
    if (sign(from) <= 0 || to >= 1) return false;
    if ((from == to) != (element->what != OnLine::facet)) return false;
  }
  return true;
}

bool is_simple_vertex_edge(const EventScene& scene) {
  const LinedUp& vertex = only(scene.drawn, OnLine::vertex);
  const ExactVector normal = cross(scene.along, direction_of(only(scene.drawn, OnLine::edge)));
  if (sign(dot(normal, scene.path.direction)) == 0) return false;
  Polygon edges = neighbours(scene.drawn, vertex.of, vertex.index);
  for (ExactVector& e : edges) e = e - exact(vertex.points[0]);
  return std::ranges::none_of(edges, [&](const ExactVector& e) { return sign(dot(normal, e)) == 0; }) &&
         !sees_edges_on_one_line(edges, scene.along);
}

bool is_simple_plane(const EventScene& scene) {
  if (sign(dot(scene.plane.normal, scene.path.direction)) == 0) return false;
  const auto in_plane = [&](const Point3& p) { return scene.plane.side(exact(p)) == 0; };
  for (const LinedUp& element : scene.drawn.elements) {
    if (!std::ranges::all_of(element.points, in_plane)) return false;
  }
  return std::ranges::none_of(normals_of_edges(scene), is_zero);
}

bool is_simple_triple(const EventScene& scene) {
  const Polygon normals = normals_of_edges(scene);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (is_zero(cross(normals[i], normals[j]))) return false;
    }
  }
  const auto polynomial = determinant(scene);
  return normals.size() == 3 && sign(polynomial[0]) == 0 && sign(polynomial[1]) != 0;
}

bool is_quadratic(const EventScene& scene) {
  return sign(determinant(scene)[3]) == 0;
}

bool names_event(const EventName& name, const EventCase& drawn) {
  const auto is = [](const EventElement& element, const LinedUp& lined_up) {
    const bool of_light = element.of == EventOf::light;
    return of_light == (lined_up.of < 0) && (of_light || int(element.body) == lined_up.of) &&
           number(element.index) == lined_up.index;
  };
  return name.kind == EventKind::vertex_edge && is(name.vertex, only(drawn, OnLine::vertex)) &&
         is(name.edge, only(drawn, OnLine::edge));
}

std::vector<ExactVector> named_points(const EventElement& element, bool is_vertex, bool is_facet, const Light& light,
                                      const std::vector<ConvexBlocker>& blockers) {
  const bool of_light = element.of == EventOf::light;
  const std::uint32_t body = number(element.body), index = number(element.index);
  const auto* solid = of_light ? nullptr : std::get_if<ConvexSolid>(&blockers[body]);
  Polygon points =
      of_light ? vertices(light) : std::visit([](const auto& shape) { return exact(shape.points()); }, blockers[body]);
  const std::size_t n = points.size();
  if (is_facet && !solid) return points;
  if (is_facet) {
    Polygon corners;
    for (const std::uint32_t k : solid->facets()[index].loop) corners.push_back(points[k]);
    return corners;
  }
  if (is_vertex) return index < n ? Polygon{points[index]} : Polygon{};
  if (solid) return {points[solid->edges()[index].from], points[solid->edges()[index].to]};
  return index < n ? Polygon{points[index], points[(index + 1) % n]} : Polygon{};
}

bool lies_in_plane(const EventName& name, const EventCase& drawn, const ExactPlane& plane) {
  const bool is_facet = name.kind == EventKind::coplanar_plane, are_edges = name.kind == EventKind::coplanar_edges;
  for (const bool is_vertex : {true, false}) {
    const Polygon points = named_points(is_vertex ? name.vertex : name.edge, is_vertex && !are_edges, is_facet,
                                        drawn.light, drawn.blockers);
    if (points.empty() || common_side(plane, points) != 0) return false;
  }
  return true;
}

Box3 box_around(const EventCase& drawn) {
  Box3 box{drawn.point, drawn.point};
  const auto add = [&](const Point3& p) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  };
  for (const Point3& p : light_points(drawn.light)) add(p);
  for (const ConvexBlocker& blocker : drawn.blockers) {
    std::visit([&](const auto& shape) { std::ranges::for_each(shape.points(), add); }, blocker);
  }
  const double size = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  add(moved(box.min, -size, {1, 1, 1}));
  add(moved(box.max, size, {1, 1, 1}));
  return box;
}

Point3 rounded(const ExactVector& p) {
  return {nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)};
}

}  // namespace gnomon::laws
