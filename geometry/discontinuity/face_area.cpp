#include <algorithm>

#include "geometry/discontinuity/receiver_mesh_data.h"

namespace gnomon {

conic::PointBox ReceiverMesh::Data::point_box(std::uint32_t vertex, unsigned bits) const {
  if (is_rational(vertex)) {
    const event::FlatPoint p = point(vertex);
    return {RationalInterval(p.x), RationalInterval(p.y)};
  }
  const ArcPoint& p = arc_point(vertex);
  RealRoot root = p.root;
  return conic::point_box(p.curve, root, bits);
}

namespace {

/// What lies between an edge and the origin, seen from its source to its target.
void add_edge(const ReceiverMesh::Data& data, const MeshEdge& edge, int sign, unsigned bits, FlatArea& area) {
  if (edge.arc == MeshEdge::nowhere && data.is_rational(edge.source) && data.is_rational(edge.target)) {
    const event::FlatPoint p = data.point(edge.source), q = data.point(edge.target);
    area.exact += sign * (p.x * q.y - p.y * q.x);
    return;
  }
  const conic::PointBox p = data.point_box(edge.source, bits), q = data.point_box(edge.target, bits);
  RationalInterval part = p.x * q.y - p.y * q.x;
  if (edge.arc != MeshEdge::nowhere) {
    const FaceArc& arc = data.arcs[edge.arc];
    RealRoot from = arc.from, to = arc.to;
    part = part + conic::doubled_segment(arc.curve, from, to, bits);
  }
  area.is_exact = false;
  area.rest = sign > 0 ? area.rest + part : area.rest - part;
}

}  // namespace

FlatArea doubled_flat_area(const ReceiverMesh::Data& data, std::span<const std::vector<MeshEdgeUse>> cycles,
                           unsigned bits) {
  FlatArea area;
  for (const auto& cycle : cycles) {
    for (const MeshEdgeUse use : cycle) add_edge(data, data.edges[use / 2], use % 2 == 0 ? 1 : -1, bits, area);
  }
  return area;
}

void put_outer_cycle_first(const ReceiverMesh::Data& data, std::vector<std::vector<MeshEdgeUse>>& cycles) {
  if (cycles.size() < 2) return;
  const auto sign = [&](const std::vector<MeshEdgeUse>& cycle) {
    for (unsigned bits = 64;; bits *= 2) {
      const FlatArea area = doubled_flat_area(data, std::span(&cycle, 1), bits);
      if (area.is_exact) return area.exact.sign();
      if (const int known = area.sum().certain_sign()) return known;
    }
  };
  const auto outer = std::find_if(cycles.begin(), cycles.end(), [&](const auto& cycle) { return sign(cycle) > 0; });
  if (outer != cycles.end()) std::swap(*outer, cycles.front());
}

}  // namespace gnomon
