#include "apps/proof/laws/receiver_probe.h"

#include <algorithm>

#include "apps/proof/laws/definition.h"

namespace gnomon::laws {
namespace {

using Edge = std::array<ExactVector, 2>;

Rational larger(const Rational& a, const Rational& b) {
  return a < b ? b : a;
}

Rational size(const ExactVector& v) {
  return larger(larger(abs(v.x), abs(v.y)), abs(v.z));
}

/// How much the area between a, b and p may be off if they are off by `little` each.
Rational doubt(const ReceiverScene& scene, const ExactVector& a, const ExactVector& b, const ExactVector& p) {
  return 8 * scene.little * (size(b - a) + size(p - a) + scene.little);
}

/// Seen from the front; the floor is level.
Rational area(const ExactVector& a, const ExactVector& b, const ExactVector& p) {
  return Rational((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
}

/// The points in which a loop passes through the floor's plane.
std::vector<ExactVector> section(const std::vector<ExactVector>& loop, const ExactPlane& floor) {
  std::vector<ExactVector> ends;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const ExactVector &p = loop[k], &q = loop[(k + 1) % loop.size()];
    const Rational at_p = floor.height(p), at_q = floor.height(q);
    if (sign(at_p) == 0) ends.push_back(p);
    if (sign(at_p) * sign(at_q) < 0) ends.push_back(p + Rational(at_p / (at_p - at_q)) * (q - p));
  }
  return ends;
}

ExactVector normal_through(const ExactVector& p, const Edge& edge) {
  return cross(edge[0] - p, edge[1] - p);
}

/// True if the polynomial a + b s + c s² has a zero from 0 to 1.
bool has_zero(const Rational& a, const Rational& b, const Rational& c) {
  const int at_0 = sign(a), at_1 = sign(Rational(a + b + c));
  if (at_0 * at_1 <= 0) return true;
  if (sign(c) == 0) return false;
  const Rational lowest = -b / (2 * c);
  if (lowest <= 0 || lowest >= 1) return false;
  return sign(Rational(a + b * lowest / 2)) * at_0 <= 0;
}

bool may_be_in_line(const std::array<Edge, 3>& edges, const ExactVector& from, const ExactVector& to) {
  const auto at = [&](const Rational& s) {
    const ExactVector p = from + s * (to - from);
    return dot(cross(normal_through(p, edges[0]), normal_through(p, edges[1])), normal_through(p, edges[2]));
  };
  // Quadratic: E4.
  const Rational first = at(0), middle = at(Rational(1, 2)), last = at(1);
  return has_zero(first, Rational(4 * middle - 3 * first - last), Rational(2 * first + 2 * last - 4 * middle));
}

}  // namespace

ReceiverScene::ReceiverScene(const ReceiverCase& one)
    : drawn(one), floor(plane_of(exact(one.floor.points()))), direction(exact(one.direction)) {
  for (const ConvexBlocker& blocker : one.blockers) blockers.push_back(walls(blocker));
  Rational largest = 0;
  for (const Point3& p : one.floor.points()) largest = larger(largest, size(exact(p)));
  little = largest / Rational(Integer(1) << 51);
}

bool ReceiverScene::is_on_floor(const ExactVector& p) const {
  const std::vector<ExactVector> corners = exact(drawn.floor.points());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (sign(area(corners[k], corners[(k + 1) % corners.size()], p)) <= 0) return false;
  }
  return true;
}

std::vector<std::vector<ExactVector>> loops_of(const ConvexBlocker& blocker) {
  const auto* solid = std::get_if<ConvexSolid>(&blocker);
  if (!solid) return {exact(std::get<ConvexPolygon>(blocker).points())};
  std::vector<std::vector<ExactVector>> loops;
  for (const ConvexSolid::Facet& facet : solid->facets()) {
    loops.emplace_back();
    for (const std::uint32_t k : facet.loop) loops.back().push_back(exact(solid->points()[k]));
  }
  return loops;
}

std::vector<Edge> edges_of(const ConvexBlocker& blocker) {
  std::vector<Edge> edges;
  if (const auto* solid = std::get_if<ConvexSolid>(&blocker)) {
    for (const auto& e : solid->edges())
      edges.push_back({exact(solid->points()[e.from]), exact(solid->points()[e.to])});
    return edges;
  }
  const std::vector<ExactVector> points = exact(std::get<ConvexPolygon>(blocker).points());
  for (std::size_t k = 0; k < points.size(); ++k) edges.push_back({points[k], points[(k + 1) % points.size()]});
  return edges;
}

std::vector<Edge> contacts(const ReceiverScene& scene) {
  std::vector<Edge> found;
  for (const ConvexBlocker& blocker : scene.drawn.blockers) {
    for (const auto& loop : loops_of(blocker)) {
      const std::vector<ExactVector> ends = section(loop, scene.floor);
      if (ends.size() == 2) found.push_back({ends[0], ends[1]});
      if (ends.size() < 3) continue;
      for (std::size_t k = 0; k < ends.size(); ++k) found.push_back({ends[k], ends[(k + 1) % ends.size()]});
    }
  }
  return found;
}

std::optional<ExactVector> place_in(const ReceiverScene& scene, const DividedReceiver& mesh,
                                    const ReceiverTriangle& triangle, const std::array<Rational, 3>& shares) {
  std::array<ExactVector, 3> corners;
  ExactVector p;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = exact(mesh.vertices[triangle.vertices[k]]);
    p = p + shares[k] * corners[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const ExactVector &a = corners[k], &b = corners[(k + 1) % 3];
    if (area(a, b, p) <= doubt(scene, a, b, p)) return std::nullopt;
  }
  return p;
}

bool may_lie_on(const ReceiverScene& scene, const DividedReceiver& mesh, const MeshEdge& edge, const ExactVector& p) {
  const ExactVector a = exact(mesh.vertices[edge.source]), b = exact(mesh.vertices[edge.target]);
  if (abs(area(a, b, p)) > doubt(scene, a, b, p)) return false;
  const Rational length = dot(b - a, b - a), at = dot(p - a, b - a), more = doubt(scene, a, b, p);
  return at >= -more && at <= length + more;
}

std::vector<ExactPlane> event_planes(const ReceiverScene& scene) {
  const std::vector<ExactVector> light = vertices(scene.drawn.light);
  std::vector<ExactPlane> planes;
  const auto add = [&](const ExactPlane& plane) {
    if (!is_zero(plane.normal)) planes.push_back(plane);
  };
  for (const ConvexBlocker& blocker : scene.drawn.blockers) {
    for (const Edge& edge : edges_of(blocker)) {
      for (const ExactVector& l : light) add(plane_through(l, edge[0], edge[1]));
    }
    const auto points = std::visit([](const auto& shape) { return exact(shape.points()); }, blocker);
    for (const ExactVector& b : points) {
      for (std::size_t k = 0; k < light.size(); ++k) add(plane_through(b, light[k], light[(k + 1) % light.size()]));
    }
    for (const auto& loop : loops_of(blocker)) add(plane_of(loop));
  }
  return planes;
}

bool sees_three_edges_in_line(const ReceiverScene& scene, const ExactVector& from, const ExactVector& to) {
  std::vector<std::vector<Edge>> sets(1);
  const std::vector<ExactVector> light = vertices(scene.drawn.light);
  for (std::size_t k = 0; k < light.size(); ++k) sets[0].push_back({light[k], light[(k + 1) % light.size()]});
  for (const ConvexBlocker& blocker : scene.drawn.blockers) sets.push_back(edges_of(blocker));
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (std::size_t j = i + 1; j < sets.size(); ++j) {
      for (std::size_t k = j + 1; k < sets.size(); ++k) {
        for (const Edge& a : sets[i]) {
          for (const Edge& b : sets[j]) {
            for (const Edge& c : sets[k]) {
              if (may_be_in_line({a, b, c}, from, to)) return true;
            }
          }
        }
      }
    }
  }
  return false;
}

}  // namespace gnomon::laws
