#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>

#include "geometry/discontinuity/receiver_mesh_data.h"
#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

std::uint32_t face_left_of(const MeshEdge& edge, MeshEdgeUse use) {
  return use % 2 == 0 ? edge.left : edge.right;
}

/// The boundary cycles of one region, walked with the region on the left.
class RegionWalk {
 public:
  RegionWalk(const ReceiverMesh::Data& data, const std::vector<std::uint32_t>& set_of)
      : data_(data), set_of_(set_of), next_(2 * data.edges.size()), done_(2 * data.edges.size(), false) {
    for (const MeshFace& face : data_.faces) {
      for (const auto& cycle : face.cycles) {
        for (std::size_t k = 0; k < cycle.size(); ++k) next_[cycle[k]] = cycle[(k + 1) % cycle.size()];
      }
    }
  }

  bool is_boundary(MeshEdgeUse use) const {
    const MeshEdge& edge = data_.edges[use / 2];
    const std::uint32_t own = face_left_of(edge, use), other = face_left_of(edge, use ^ 1U);
    return other == MeshEdge::nowhere || set_of_[own] != set_of_[other];
  }

  bool is_done(MeshEdgeUse use) const { return done_[use]; }

  std::vector<MeshEdgeUse> cycle_from(MeshEdgeUse first) {
    std::vector<MeshEdgeUse> cycle;
    for (MeshEdgeUse use = first; !done_[use]; use = following(use)) {
      done_[use] = true;
      cycle.push_back(use);
    }
    return cycle;
  }

 private:
  /// The next boundary edge around the end of this one, past edges inside the region.
  MeshEdgeUse following(MeshEdgeUse use) const {
    MeshEdgeUse next = next_[use];
    while (!is_boundary(next)) next = next_[next ^ 1U];
    return next;
  }

  const ReceiverMesh::Data& data_;
  const std::vector<std::uint32_t>& set_of_;
  std::vector<MeshEdgeUse> next_;
  std::vector<bool> done_;
};

std::vector<std::uint32_t> sets_of_equal_region(const ReceiverMesh::Data& data) {
  boost::disjoint_sets_with_storage<> sets(data.faces.size());
  for (const MeshEdge& e : data.edges) {
    if (e.left == MeshEdge::nowhere || e.right == MeshEdge::nowhere) continue;
    if (data.faces[e.left].region == data.faces[e.right].region) sets.union_set(e.left, e.right);
  }
  std::vector<std::uint32_t> lowest(data.faces.size(), MeshEdge::nowhere), result(data.faces.size());
  for (std::uint32_t f = 0; f < result.size(); ++f) {
    std::uint32_t& of_set = lowest[sets.find_set(f)];
    result[f] = of_set = std::min(of_set, f);
  }
  return result;
}

void put_outer_cycle_first(const ReceiverMesh::Data& data, std::vector<std::vector<MeshEdgeUse>>& cycles) {
  // Of the boundary cycles of a connected region only the outer one runs counterclockwise.
  for (auto& cycle : cycles) {
    if (doubled_flat_area(data, std::span(&cycle, 1)) > 0) {
      std::swap(cycle, cycles.front());
      return;
    }
  }
}

RegionArea stretched(const Rational& doubled, const Rational& squared_stretch) {
  // An axis-parallel plane is not stretched; others by a square root.
  if (squared_stretch == 1) {
    const ExactNumber number = exact_number(Rational(doubled / 2));
    return {number.nearest, number.exact};
  }
  return {nearest_root(Rational(doubled * doubled * squared_stretch / 4)), std::nullopt};
}

}  // namespace

std::vector<RegionPolygon> ReceiverMesh::regions() const {
  const std::vector<std::uint32_t> set_of = sets_of_equal_region(*data_);
  RegionWalk walk(*data_, set_of);
  std::vector<RegionPolygon> result;
  std::vector<std::uint32_t> place(set_of.size());
  for (std::uint32_t f = 0; f < set_of.size(); ++f) {
    if (set_of[f] == f) {
      place[f] = static_cast<std::uint32_t>(result.size());
      result.push_back({data_->faces[f].region, {}, {}});
    }
    result[place[set_of[f]]].faces.push_back(f);
  }
  for (RegionPolygon& region : result) {
    for (const std::uint32_t f : region.faces) {
      for (const auto& cycle : data_->faces[f].cycles) {
        for (const MeshEdgeUse use : cycle) {
          if (walk.is_boundary(use) && !walk.is_done(use)) region.cycles.push_back(walk.cycle_from(use));
        }
      }
    }
    if (region.cycles.size() > 1) put_outer_cycle_first(*data_, region.cycles);
  }
  return result;
}

namespace {

std::array<Rational, receiver_region_count> doubled_areas(const ReceiverMesh& mesh) {
  std::array<Rational, receiver_region_count> areas{};
  for (const RegionPolygon& region : mesh.regions()) {
    areas[static_cast<std::size_t>(region.region)] += doubled_flat_area(mesh.data(), region.cycles);
  }
  return areas;
}

/// From the border alone.
Rational doubled_receiver_area(const ReceiverMesh& mesh) {
  std::vector<MeshEdgeUse> border;
  for (std::uint32_t e = 0; e < mesh.edges().size(); ++e) {
    if (mesh.edges()[e].right == MeshEdge::nowhere) border.push_back(2 * e);
    if (mesh.edges()[e].left == MeshEdge::nowhere) border.push_back(2 * e + 1);
  }
  return doubled_flat_area(mesh.data(), std::span(&border, 1));
}

}  // namespace

std::array<RegionArea, receiver_region_count> ReceiverMesh::areas() const {
  const Rational stretch = data_->plane.squared_stretch();
  std::array<RegionArea, receiver_region_count> result;
  const auto doubled = doubled_areas(*this);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = stretched(doubled[k], stretch);
  return result;
}

RegionArea ReceiverMesh::area() const {
  return stretched(doubled_receiver_area(*this), data_->plane.squared_stretch());
}

bool ReceiverMesh::areas_add_up() const {
  Rational sum = 0;
  for (const Rational& area : doubled_areas(*this)) sum += area;
  return sum == doubled_receiver_area(*this);
}

std::vector<Point3> ReceiverMesh::vertices() const {
  std::vector<Point3> result;
  for (std::uint32_t v = 0; v < vertex_count(); ++v) {
    const ExactVector p = data_->plane.spatial(data_->point(v));
    result.push_back({nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)});
  }
  return result;
}

std::size_t ReceiverMesh::vertex_count() const {
  return data_->arrangement.vertex_count();
}

const std::vector<MeshEdge>& ReceiverMesh::edges() const {
  return data_->edges;
}

const std::vector<MeshFace>& ReceiverMesh::faces() const {
  return data_->faces;
}

const std::vector<EventName>& ReceiverMesh::names() const {
  return data_->names;
}

}  // namespace gnomon
