#include "geometry/discontinuity/arc_faces.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace gnomon::event {
namespace {

/// Where an arc ends on an edge.
struct EdgePoint {
  RealRoot at;  ///< on the edge's line
  std::uint32_t vertex = 0;
};

/// Ends of arcs are known so closely where they are irrational.
constexpr unsigned near_bits = 100;

class FaceDivider {
 public:
  explicit FaceDivider(ReceiverMesh::Data& data) : data_(data), points_(data.edges.size()) {
    for (std::uint32_t n = 0; n < data.names.size(); ++n) numbers_.try_emplace(data.names[n], n);
  }

  void divide(std::span<const FaceDivision> divisions) {
    for (const FaceDivision& d : divisions) add_points(d);
    part_edges();
    for (MeshFace& face : data_.faces) {
      for (auto& cycle : face.cycles) cycle = parted(cycle);
    }
    for (std::size_t k = 0; k < divisions.size(); ++k) add_cells(divisions[k], vertex_of_[k]);
    find_faces_of_edges();
  }

 private:
  std::uint32_t add_vertex(const conic::FlatCurve& curve, const RealRoot& root) {
    ArcPoint point{curve, root, {}, root.is_rational()};
    if (point.is_rational) {
      point.near = *curve.at(root.low);
    } else {
      const conic::PointBox box = conic::point_box(curve, point.root, near_bits);
      point.near = {box.x.high, box.y.high};
    }
    data_.arc_points.push_back(std::move(point));
    return static_cast<std::uint32_t>(data_.vertex_count() - 1);
  }

  /// Gives all nodes of cells their vertices: those on edges first, which faces on both sides may have in common.
  void add_points(const FaceDivision& d) {
    std::vector<std::uint32_t>& vertices = vertex_of_.emplace_back(d.cells.nodes.size(), MeshEdge::nowhere);
    for (std::size_t n = 0; n < vertices.size(); ++n) {
      const std::uint32_t own = d.cells.nodes[n].vertex;
      if (own != conic::CurveMap::nowhere) vertices[n] = d.vertices[own];
    }
    for (const Cell& cell : d.cells.cells) {
      for (const auto& cycle : cell.cycles) {
        for (const CellSide& side : cycle) {
          if (side.is_arc) continue;
          if (vertices[side.start] == MeshEdge::nowhere) {
            vertices[side.start] = point_on(side.index / 2, side.at_start, d.cells, side.start);
          }
          if (vertices[side.end] == MeshEdge::nowhere) {
            vertices[side.end] = point_on(side.index / 2, side.at_end, d.cells, side.end);
          }
        }
      }
    }
    for (const CellArc& arc : d.cells.arcs) {
      for (const std::uint32_t node : {arc.start, arc.end}) {
        if (vertices[node] != MeshEdge::nowhere) continue;
        const auto& of = d.cells.nodes[node];
        vertices[node] = add_vertex(d.cells.curves[of.curve], of.root);
      }
    }
  }

  std::uint32_t point_on(std::uint32_t edge, const RealRoot& root, const FaceCells& cells, std::uint32_t node) {
    std::vector<EdgePoint>& points = points_[edge];
    RealRoot at = root;
    std::size_t place = 0;
    for (; place < points.size(); ++place) {
      const int order = compare(at, points[place].at);
      if (order == 0) return points[place].vertex;
      if (order < 0) break;
    }
    const std::uint32_t vertex = add_vertex(cells.curves[cells.nodes[node].curve], cells.nodes[node].root);
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(place), {std::move(at), vertex});
    return vertex;
  }

  /// Parts of each edge, from its source to its target.
  void part_edges() {
    const std::size_t n = data_.edges.size();
    parts_.resize(n);
    for (std::uint32_t e = 0; e < n; ++e) {
      parts_[e] = {e};
      if (points_[e].empty()) continue;
      const FlatPoint source = data_.point(data_.edges[e].source), target = data_.point(data_.edges[e].target);
      // Points are in the order of the line's parameter, which is one of the coordinates.
      const conic::FlatCurve line = conic::straight_curve(conic::line_through(source, target));
      const bool is_by_x = line.parameters.front().start[1] != 0;
      if (is_by_x ? source.x > target.x : source.y > target.y) std::reverse(points_[e].begin(), points_[e].end());
      const std::uint32_t last = data_.edges[e].target;
      for (const EdgePoint& p : points_[e]) {
        data_.edges[parts_[e].back()].target = p.vertex;
        MeshEdge more = data_.edges[e];
        more.source = p.vertex;
        more.target = last;
        parts_[e].push_back(static_cast<std::uint32_t>(data_.edges.size()));
        data_.edges.push_back(std::move(more));
      }
    }
  }

  std::vector<MeshEdgeUse> parted(const std::vector<MeshEdgeUse>& cycle) const {
    std::vector<MeshEdgeUse> result;
    for (const MeshEdgeUse use : cycle) append_uses(parts_[use / 2], use % 2 == 0, result);
    return result;
  }

  static void append_uses(std::span<const std::uint32_t> parts, bool is_forward, std::vector<MeshEdgeUse>& cycle) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      cycle.push_back(is_forward ? 2 * parts[k] : 2 * parts[parts.size() - 1 - k] + 1);
    }
  }

  /// The parts of an edge that a cell's side consists of.
  void append_parts(const CellSide& side, const std::vector<std::uint32_t>& vertices,
                    std::vector<MeshEdgeUse>& cycle) const {
    const std::vector<MeshEdgeUse> all = parted({side.is_forward ? side.index : side.index ^ 1U});
    bool is_on = false;
    for (const MeshEdgeUse use : all) {
      const MeshEdge& edge = data_.edges[use / 2];
      is_on = is_on || (use % 2 == 0 ? edge.source : edge.target) == vertices[side.start];
      if (is_on) cycle.push_back(use);
      if (is_on && (use % 2 == 0 ? edge.target : edge.source) == vertices[side.end]) return;
    }
  }

  std::uint32_t number(const EventName& name) {
    const auto [found, is_new] = numbers_.try_emplace(name, static_cast<std::uint32_t>(data_.names.size()));
    if (is_new) data_.names.push_back(name);
    return found->second;
  }

  /// Adds an arc as an edge, or in parts, so that the middle Bezier point of each has a positive weight.
  void add_arc(const MeshEdge& edge, const conic::FlatCurve& curve, RealRoot from, RealRoot to,
               std::vector<std::uint32_t>& parts) {
    if (!curve.is_straight) {
      conic::point_box(curve, from, near_bits);
      conic::point_box(curve, to, near_bits);
      if (!conic::is_short(curve, from.high, to.low)) {
        const RealRoot middle = rational_root(number_between(from, to));
        MeshEdge first = edge, second = edge;
        first.target = second.source = add_vertex(curve, middle);
        add_arc(first, curve, from, middle, parts);
        add_arc(second, curve, middle, to, parts);
        return;
      }
    }
    parts.push_back(static_cast<std::uint32_t>(data_.edges.size()));
    data_.edges.push_back(edge);
    if (curve.is_straight) return;
    data_.edges.back().arc = static_cast<std::uint32_t>(data_.arcs.size());
    data_.arcs.push_back({curve, std::move(from), std::move(to)});
  }

  void add_cells(const FaceDivision& d, const std::vector<std::uint32_t>& vertices) {
    std::vector<std::vector<std::uint32_t>> parts_of_arc;
    for (const CellArc& arc : d.cells.arcs) {
      std::vector<std::uint32_t> names;
      for (const std::uint32_t n : arc.names) names.push_back(number(d.names[n]));
      std::sort(names.begin(), names.end());
      const MeshEdge edge{vertices[arc.start], vertices[arc.end], MeshEdge::nowhere, MeshEdge::nowhere, names};
      add_arc(edge, d.cells.curves[arc.curve], arc.from, arc.to, parts_of_arc.emplace_back());
    }
    for (std::size_t c = 0; c < d.cells.cells.size(); ++c) {
      const Cell& cell = d.cells.cells[c];
      MeshFace face{cell.region, {}};
      for (const auto& sides : cell.cycles) {
        auto& cycle = face.cycles.emplace_back();
        for (const CellSide& side : sides) {
          if (side.is_arc) {
            append_uses(parts_of_arc[side.index], side.is_forward, cycle);
          } else {
            append_parts(side, vertices, cycle);
          }
        }
      }
      put_outer_cycle_first(data_, face.cycles);
      if (c == 0) {
        data_.faces[d.face] = std::move(face);
      } else {
        data_.faces.push_back(std::move(face));
      }
    }
  }

  void find_faces_of_edges() {
    for (MeshEdge& edge : data_.edges) edge.left = edge.right = MeshEdge::nowhere;
    for (std::uint32_t f = 0; f < data_.faces.size(); ++f) {
      for (const auto& cycle : data_.faces[f].cycles) {
        for (const MeshEdgeUse use : cycle) {
          MeshEdge& edge = data_.edges[use / 2];
          (use % 2 == 0 ? edge.left : edge.right) = f;
        }
      }
    }
  }

  ReceiverMesh::Data& data_;
  std::vector<std::vector<EdgePoint>> points_;         ///< of each edge
  std::vector<std::vector<std::uint32_t>> parts_;      ///< of each edge
  std::vector<std::vector<std::uint32_t>> vertex_of_;  ///< of each division's nodes
  std::map<EventName, std::uint32_t> numbers_;
};

}  // namespace

FaceSides sides_of(const ReceiverMesh::Data& data, const MeshFace& face) {
  std::set<MeshEdgeUse> uses;
  for (const auto& cycle : face.cycles) uses.insert(cycle.begin(), cycle.end());
  FaceSides result;
  std::map<std::uint32_t, std::uint32_t> numbers;
  const auto number = [&](std::uint32_t vertex) {
    const auto [found, is_new] = numbers.try_emplace(vertex, static_cast<std::uint32_t>(numbers.size()));
    if (is_new) result.vertices.push_back(vertex);
    return found->second;
  };
  for (const MeshEdgeUse use : uses) {
    const bool is_inside = uses.contains(use ^ 1U);
    if (is_inside && use % 2 == 1) continue;
    const MeshEdge& edge = data.edges[use / 2];
    const auto [from, to] = use % 2 == 0 ? std::pair(edge.source, edge.target) : std::pair(edge.target, edge.source);
    result.sides.push_back({data.point(from), data.point(to), number(from), number(to), use, is_inside});
  }
  return result;
}

void divide_faces(std::span<const FaceDivision> divisions, ReceiverMesh::Data& data) {
  if (!divisions.empty()) FaceDivider(data).divide(divisions);
}

}  // namespace gnomon::event
