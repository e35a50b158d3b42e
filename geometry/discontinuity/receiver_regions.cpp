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
    put_outer_cycle_first(*data_, region.cycles);
  }
  return result;
}

namespace {

using RegionAreas = std::array<FlatArea, receiver_region_count>;

RegionAreas doubled_areas(const ReceiverMesh& mesh, std::span<const RegionPolygon> regions, unsigned bits) {
  RegionAreas areas{};
  for (const RegionPolygon& region : regions) {
    FlatArea& sum = areas[static_cast<std::size_t>(region.region)];
    const FlatArea area = doubled_flat_area(mesh.data(), region.cycles, bits);
    sum.exact += area.exact;
    sum.rest = sum.rest + area.rest;
    sum.is_exact = sum.is_exact && area.is_exact;
  }
  return areas;
}

/// From the border alone, before arcs divided it.
Rational doubled_receiver_area(const ReceiverMesh& mesh) {
  const event::ReceiverArrangement& arrangement = mesh.data().arrangement;
  Rational area = 0;
  for (const event::ReceiverArrangement::Edge& edge : arrangement.edges()) {
    if (edge.right != event::outside && edge.left != event::outside) continue;
    const event::FlatPoint p = arrangement.point(edge.source), q = arrangement.point(edge.target);
    const Rational part = p.x * q.y - p.y * q.x;
    area += edge.right == event::outside ? part : Rational(-part);
  }
  return area;
}

/// Off by at most an ulp: both ends of the interval round alike, or to neighbours once it is narrow.
std::optional<RegionArea> stretched_if_known(const RationalInterval& doubled, const Rational& squared_stretch,
                                             bool is_last) {
  const Rational zero = 0;
  const RegionArea low = stretched(std::max(doubled.low, zero), squared_stretch),
                   high = stretched(std::max(doubled.high, zero), squared_stretch);
  if (low.nearest != high.nearest && !is_last) return std::nullopt;
  return RegionArea{high.nearest, std::nullopt};
}

}  // namespace

std::array<RegionArea, receiver_region_count> ReceiverMesh::areas() const {
  const Rational stretch = data_->plane.squared_stretch();
  std::array<RegionArea, receiver_region_count> result;
  const std::vector<RegionPolygon> polygons = regions();
  constexpr unsigned first_bits = 80, last_bits = 640;
  std::array<bool, receiver_region_count> is_known{};
  for (unsigned bits = first_bits; bits <= last_bits; bits *= 2) {
    const RegionAreas doubled = doubled_areas(*this, polygons, bits);
    for (std::size_t k = 0; k < result.size(); ++k) {
      if (is_known[k]) continue;
      const auto area = doubled[k].is_exact ? stretched(doubled[k].exact, stretch)
                                            : stretched_if_known(doubled[k].sum(), stretch, bits == last_bits);
      if (area) result[k] = *area;
      is_known[k] = area.has_value();
    }
    if (std::all_of(is_known.begin(), is_known.end(), [](bool known) { return known; })) break;
  }
  return result;
}

RegionArea ReceiverMesh::area() const {
  return stretched(doubled_receiver_area(*this), data_->plane.squared_stretch());
}

bool ReceiverMesh::areas_add_up() const {
  FlatArea sum;
  for (const FlatArea& area : doubled_areas(*this, regions(), 80)) {
    sum.exact += area.exact;
    sum.rest = sum.rest + area.rest;
    sum.is_exact = sum.is_exact && area.is_exact;
  }
  const Rational whole = doubled_receiver_area(*this);
  return sum.is_exact ? sum.exact == whole : sum.sum().low <= whole && whole <= sum.sum().high;
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
  return data_->vertex_count();
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
