#include "gnomon/flatland_partition.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/numbers/rounding.h"
#include "geometry/planar/partition_data.h"
#include "gnomon/errors.h"

namespace gnomon::planar {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using PlainFaceBase = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, PlainFaceBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using Triangle = Triangulation::Face_handle;
using Corner = Triangulation::Vertex_handle;

class FaceTriangulation {
 public:
  explicit FaceTriangulation(const Partition::Data& data) {
    for (std::uint32_t i = 0; i < data.exact_vertices.size(); ++i) {
      const ExactPoint& p = data.exact_vertices[i];
      const Corner corner = triangulation_.insert(Kernel::Point_2(Kernel::FT(p.x), Kernel::FT(p.y)));
      corner->info() = i;
      corners_.push_back(corner);
    }
    for (const PartitionEdge& edge : data.edges) {
      triangulation_.insert_constraint(corners_[edge.source], corners_[edge.target]);
    }
    for (const Triangle triangle : triangulation_.all_face_handles()) triangle->info() = nowhere;
    for (const PartitionEdge& edge : data.edges) begin_at(edge);
  }

  std::vector<FaceTriangle> triangles() const {
    std::vector<FaceTriangle> list;
    for (const Triangle triangle : triangulation_.finite_face_handles()) {
      if (triangle->info() == nowhere) continue;
      list.push_back(
          {{triangle->vertex(0)->info(), triangle->vertex(1)->info(), triangle->vertex(2)->info()}, triangle->info()});
    }
    return list;
  }

 private:
  /// A vertex may lie on an edge that it does not end: then the first triangle along the edge will do.
  void begin_at(const PartitionEdge& edge) {
    auto around = triangulation_.incident_faces(corners_[edge.source]);
    const auto first = around;
    const Corner target = corners_[edge.target];
    do {
      const int source_at = around->index(corners_[edge.source]);
      const Corner next = around->vertex(Triangulation::ccw(source_at));
      const Corner last = around->vertex(Triangulation::cw(source_at));
      if (next == target) spread(around, edge.left);
      if (last == target) spread(around, edge.right);
    } while (++around != first);
  }

  /// Gives a triangle its face, and all that are reached from it across no edge.
  void spread(Triangle start, std::uint32_t face) {
    if (face == nowhere || start->info() != nowhere || triangulation_.is_infinite(start)) return;
    std::vector<Triangle> waiting{start};
    start->info() = face;
    while (!waiting.empty()) {
      const Triangle triangle = waiting.back();
      waiting.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Triangle next = triangle->neighbor(i);
        if (triangle->is_constrained(i) || triangulation_.is_infinite(next) || next->info() != nowhere) continue;
        next->info() = face;
        waiting.push_back(next);
      }
    }
  }

  Triangulation triangulation_;
  std::vector<Corner> corners_;
};

Rational twice_area(const Partition::Data& data, const PartitionFace& face) {
  Rational sum = 0;
  for (const auto& cycle : face.boundary) {
    for (const EdgeUse& use : cycle) {
      const ExactPoint& p = data.exact_vertices[data.edges[use.edge].source];
      const ExactPoint& q = data.exact_vertices[data.edges[use.edge].target];
      const Rational area = p.x * q.y - p.y * q.x;
      if (use.way == EdgeUse::Way::forward) {
        sum += area;
      } else {
        sum -= area;
      }
    }
  }
  return sum;
}

}  // namespace

PartitionInBox partition_in_box(const Partition& partition) {
  if (!partition.box()) throw PreconditionError("triangles need a partition of a box");
  const Partition::Data& data = partition.data();
  PartitionInBox result{data.vertices, FaceTriangulation(data).triangles(), {}, {}};
  std::array<Rational, 3> twice{};
  for (const PartitionFace& face : data.faces) {
    const Rational area = twice_area(data, face);
    twice[static_cast<std::size_t>(face.region)] += area;
    result.faces.push_back({face.region, exact_number(area / 2)});
  }
  for (std::size_t k = 0; k < 3; ++k) result.areas[k] = exact_number(twice[k] / 2);
  return result;
}

}  // namespace gnomon::planar
