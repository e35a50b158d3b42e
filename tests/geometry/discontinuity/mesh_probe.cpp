#include "tests/geometry/discontinuity/mesh_probe.h"

#include <algorithm>
#include <utility>

#include "gnomon/scene.h"

namespace gnomon {
namespace {

/// Twice what a segment adds to the winding number around a point; nothing if the point lies on it.
std::optional<int> doubled_winding(const event::FlatPoint& a, const event::FlatPoint& b, const event::FlatPoint& p) {
  const Rational turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  const bool between = (a.x <= p.x && p.x <= b.x) || (b.x <= p.x && p.x <= a.x);
  const bool level = (a.y <= p.y && p.y <= b.y) || (b.y <= p.y && p.y <= a.y);
  if (turn == 0 && between && level) return std::nullopt;
  const int rise = (b.y > p.y ? 1 : b.y < p.y ? -1 : 0) - (a.y > p.y ? 1 : a.y < p.y ? -1 : 0);
  return rise != 0 && ((turn > 0) == (rise > 0)) ? rise : 0;
}

/// The same of an arc, as its parameter grows: where it passes the height of p on its right. Heights of the arc's ends
/// count as those of points close to them.
int doubled_winding(const FaceArc& arc, const event::FlatPoint& p) {
  const auto height = [&](std::size_t axis, const Rational& of) {
    const auto& c = arc.curve.point;
    return Polynomial(Integer(denominator(of)) * c[axis] - Integer(numerator(of)) * c[0]);
  };
  const Polynomial above = height(2, p.y), beyond = height(1, p.x), w(arc.curve.point[0]);
  RealRoot from = arc.from, to = arc.to;
  const Rational start = from.is_rational() ? from.low : from.high, end = to.low;
  const auto side = [&](const Rational& t) { return above.sign_at(t) * w.sign_at(t); };
  int doubled = 0;
  std::vector<RealRoot> roots = real_roots(above, start, end);
  Rational last = start;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    RealRoot after = k + 1 < roots.size() ? roots[k + 1] : rational_root(end);
    if (compare(roots[k], after) >= 0) continue;
    const Rational next = number_between(roots[k], after);
    if (sign_at(beyond, roots[k]) * w.sign_at(next) > 0) doubled += side(next) - side(last);
    last = next;
  }
  return doubled;
}

std::optional<int> doubled_winding(const ReceiverMesh::Data& data, const std::vector<MeshEdgeUse>& cycle,
                                   const event::FlatPoint& p) {
  int doubled = 0;
  for (const MeshEdgeUse use : cycle) {
    const MeshEdge& edge = data.edges[use / 2];
    if (edge.arc != MeshEdge::nowhere) {
      doubled += (use % 2 == 0 ? 1 : -1) * doubled_winding(data.arcs[edge.arc], p);
      continue;
    }
    event::FlatPoint a = data.point(edge.source), b = data.point(edge.target);
    if (use % 2 == 1) std::swap(a, b);
    const auto part = doubled_winding(a, b, p);
    if (!part) return std::nullopt;
    doubled += *part;
  }
  return doubled;
}

}  // namespace

std::vector<ReceiverTriangle> straight_triangles(const ReceiverMesh& mesh) {
  std::vector<ReceiverTriangle> triangles = mesh.drawing().triangles;
  std::erase_if(triangles, [&](const ReceiverTriangle& t) {
    return t.is_at_arc || std::ranges::any_of(t.vertices, [&](std::uint32_t v) { return v >= mesh.vertex_count(); });
  });
  return triangles;
}

bool is_in_face(const ReceiverMesh& mesh, std::uint32_t face, const ExactVector& point) {
  const event::FlatPoint p = mesh.data().plane.flat(point);
  int doubled = 0;
  for (const auto& cycle : mesh.faces()[face].cycles) {
    const auto winding = doubled_winding(mesh.data(), cycle, p);
    if (!winding) return false;
    doubled += *winding;
  }
  return doubled != 0;
}

std::optional<std::uint32_t> face_at(const ReceiverMesh& mesh, const ExactVector& point) {
  const event::FlatPoint p = mesh.data().plane.flat(point);
  for (std::uint32_t f = 0; f < mesh.faces().size(); ++f) {
    int doubled = 0;
    for (const auto& cycle : mesh.faces()[f].cycles) {
      const auto winding = doubled_winding(mesh.data(), cycle, p);
      if (!winding) return std::nullopt;
      doubled += *winding;
    }
    if (doubled != 0) return f;
  }
  return std::nullopt;
}

ConvexPolygon rectangle(double x0, double y0, double x1, double y1, double z, Facing facing) {
  std::vector<Point3> points{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
  if (facing == Facing::down) std::reverse(points.begin(), points.end());
  return ConvexPolygon::from_points(points);
}

ConvexBlocker box(const Point3& low, const Point3& high) {
  std::vector<Point3> points;
  for (const double x : {low.x, high.x}) {
    for (const double y : {low.y, high.y}) {
      for (const double z : {low.z, high.z}) points.push_back({x, y, z});
    }
  }
  return ConvexSolid::hull_of(points);
}

ConvexBlocker turned_box(double x, double y, double z0, double z1, double c, double s) {
  std::vector<Point3> points;
  for (const double z : {z0, z1}) {
    points.push_back({x + c, y + s, z});
    points.push_back({x - s, y + c, z});
    points.push_back({x - c, y - s, z});
    points.push_back({x + s, y - c, z});
  }
  return ConvexSolid::hull_of(points);
}

std::vector<ConvexBlocker> parts_of_blockers(const SpaceScene& scene) {
  std::vector<ConvexBlocker> parts;
  for (const SceneBlocker& blocker : scene.blockers) {
    for (ConvexPart& part : convex_parts(blocker)) parts.push_back(std::move(part.shape));
  }
  return parts;
}

std::vector<ConvexPolygon> receivers_of(const SpaceScene& scene) {
  std::vector<ConvexPolygon> receivers;
  for (const SceneReceiver& receiver : scene.receivers) receivers.push_back(receiver.shape);
  return receivers;
}

AreaLight lamp(ConvexPolygon polygon) {
  return {std::move(polygon), false};
}

ProbeResult compare_with_definition(const ReceiverMesh& mesh, const ConvexPolygon& receiver, const Light& light,
                                    const std::vector<ConvexBlocker>& blockers, std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto points = receiver.points();
  const auto [x0, x1] = std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.x < b.x; });
  const auto [y0, y1] = std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.y < b.y; });
  std::uniform_real_distribution<double> x(x0->x, x1->x), y(y0->y, y1->y);
  const Obstacles obstacles{blockers, {}};
  ProbeResult result;
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 p{x(random), y(random), points[0].z};
    const auto face = face_at(mesh, exact(p));
    if (!face) continue;
    const ReceiverRegion region = mesh.faces()[*face].region;
    ++result.compared;
    if (region == ReceiverRegion::unresolved_eee) {
      ++result.unresolved;
      continue;
    }
    if (static_cast<int>(region) != static_cast<int>(exact_visibility(light, obstacles, p).region)) ++result.different;
  }
  return result;
}

}  // namespace gnomon
