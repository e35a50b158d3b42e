#include "shading/illumination/hidden_exchange.h"

#include <cmath>
#include <vector>

#include "shading/illumination/triangle_integral.h"
#include "shading/vector.h"

namespace gnomon::illumination {
namespace {

bool has_arcs(const ReceiverMesh& mesh, const RegionPolygon& region) {
  for (const auto& cycle : region.cycles) {
    for (const MeshEdgeUse use : cycle) {
      if (mesh.edges()[use / 2].arc != MeshEdge::nowhere) return true;
    }
  }
  return false;
}

Loops loops_of(const ReceiverMesh& mesh, const RegionPolygon& region, const std::vector<Point3>& vertices) {
  Loops loops;
  for (const auto& cycle : region.cycles) {
    loops.emplace_back();
    for (const MeshEdgeUse use : cycle) {
      const MeshEdge& edge = mesh.edges()[use / 2];
      loops.back().push_back(vertices[use % 2 == 0 ? edge.source : edge.target]);
    }
  }
  return loops;
}

/// At most what an exchange area changes by when each vertex is rounded: the area passed over, as a factor is at
/// most 1.
double rounding_of(const Loops& loops) {
  double sum = 0;
  for (const auto& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point3 &p = loop[k], &q = loop[(k + 1) % loop.size()];
      sum += sum_norm(step(p, q)) * 0x1p-51 * (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
    }
  }
  return sum;
}

}  // namespace

Exchange hidden_exchange(const ReceiverMesh& mesh, const RestingPiece& receiver, const Loops& light,
                         LightIrradiance& irradiance, const HiddenEffort& effort) {
  Exchange result;
  const std::vector<Point3> vertices = mesh.vertices();
  std::vector<bool> is_done(mesh.faces().size(), false);
  for (const RegionPolygon& region : mesh.regions()) {
    if (region.region != ReceiverRegion::lit || has_arcs(mesh, region)) continue;
    for (const std::uint32_t face : region.faces) is_done[face] = true;
    const Loops loops = loops_of(mesh, region, vertices);
    result.area = result.area + widened(exchange_area(loops, light), rounding_of(loops));
  }
  const MeshDrawing drawing = mesh.drawing();
  std::vector<Triangle> triangles;
  for (const ReceiverTriangle& t : drawing.triangles) {
    const ReceiverRegion region = mesh.faces()[t.face].region;
    const bool is_dark = region == ReceiverRegion::umbra || region == ReceiverRegion::unlit;
    if (is_done[t.face] || (is_dark && !t.is_at_arc)) continue;
    const auto& [a, b, c] = t.vertices;
    triangles.push_back({drawing.points[a], drawing.points[b], drawing.points[c]});
  }
  if (triangles.empty()) return result;
  TriangleIntegral integral(receiver, irradiance, effort);
  integral.add(triangles);
  result.area = result.area + integral.value();
  result.is_proven = false;
  result.evaluations = integral.evaluations();
  return result;
}

}  // namespace gnomon::illumination
