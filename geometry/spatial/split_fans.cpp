#include "geometry/spatial/split_fans.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <numeric>

#include "gnomon/errors.h"

namespace gnomon {
namespace {

/// The use of an edge by a triangle: from its corner i to the next one.
struct EdgeUse {
  std::size_t triangle;
  std::size_t corner;
  bool forward;  ///< from the lower to the higher vertex
  bool inner;

  std::size_t start() const { return 3 * triangle + corner; }
  std::size_t end() const { return 3 * triangle + (corner + 1) % 3; }
};

using EdgeUses = std::map<std::array<VertexId, 2>, std::vector<EdgeUse>>;

/// Sets of corners of triangles that are one vertex of the surface.
using Fans = boost::disjoint_sets_with_storage<>;

/// Joins two triangles along an edge that they use in opposite directions.
void join(Fans& fans, const EdgeUse& a, const EdgeUse& b) {
  fans.union_set(a.start(), b.end());
  fans.union_set(a.end(), b.start());
}

std::vector<std::array<VertexId, 3>*> all_triangles(ExactSurface& surface) {
  std::vector<std::array<VertexId, 3>*> triangles;
  for (auto& facet : surface.facets) {
    for (auto& triangle : facet.triangles) triangles.push_back(&triangle);
  }
  return triangles;
}

EdgeUses edge_uses(const ExactSurface& surface, std::size_t first_inner) {
  EdgeUses uses;
  std::size_t triangle = 0;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    for (const auto& t : surface.facets[f].triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId a = t[i];
        const VertexId b = t[(i + 1) % 3];
        uses[{std::min(a, b), std::max(a, b)}].push_back({triangle, i, a < b, f >= first_inner});
      }
      ++triangle;
    }
  }
  return uses;
}

/// The four uses of an edge at which two sheets touch, those of one wedge between outer and inner sheet beside each
/// other: a triangle of the outer sheet and the inward one that it meets head on.
std::array<EdgeUse, 4> wedges(const std::vector<EdgeUse>& uses) {
  std::vector<EdgeUse> outer;
  std::vector<EdgeUse> inner;
  for (const EdgeUse& use : uses) (use.inner ? inner : outer).push_back(use);
  if (inner.size() != 2 || outer.size() != 2) throw PreconditionError("the surface touches itself where it cannot");
  if (inner[0].forward == outer[0].forward) std::swap(inner[0], inner[1]);
  return {outer[0], inner[0], outer[1], inner[1]};
}

/// Joins the four triangles at an edge where the umbra touches the occlusion's surface. If the outer sheet already goes
/// round one end of the edge, the umbra only touches it there, and each sheet is joined to itself; otherwise the umbra
/// divides the volume into two wedges, and an outer triangle belongs to the inward one that it meets head on.
void join_touching_sheets(Fans& fans, const std::vector<EdgeUse>& uses) {
  const auto [outer, inner, other_outer, other_inner] = wedges(uses);
  const bool goes_round = fans.find_set(outer.start()) == fans.find_set(other_outer.end()) ||
                          fans.find_set(outer.end()) == fans.find_set(other_outer.start());
  join(fans, outer, goes_round ? other_outer : inner);
  join(fans, other_inner, goes_round ? inner : other_outer);
}

/// The corners of all triangles, joined where they are one vertex.
Fans joined_fans(const EdgeUses& edges, std::size_t corners) {
  Fans fans(corners);
  for (const auto& [edge, uses] : edges) {
    if (uses.size() == 2) join(fans, uses[0], uses[1]);
  }
  for (const auto& [edge, uses] : edges) {
    if (uses.size() == 4) join_touching_sheets(fans, uses);
  }
  return fans;
}

/// Divides a triangle at a vertex inside the edge that starts at its corner i.
void divide(Triangles& triangles, std::size_t index, std::size_t i, VertexId middle) {
  const std::array<VertexId, 3> t = triangles[index];
  const VertexId a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
  triangles[index] = {a, middle, c};
  triangles.push_back({middle, b, c});
}

/// The facet of a triangle, and its place there.
std::array<std::size_t, 2> place(const ExactSurface& surface, std::size_t triangle) {
  std::size_t facet = 0;
  for (; triangle >= surface.facets[facet].triangles.size(); ++facet)
    triangle -= surface.facets[facet].triangles.size();
  return {facet, triangle};
}

/// Divides one edge that still has two sheets, each at a vertex of its own in the middle. False if there is none.
bool divide_shared_edge(ExactSpace& space, ExactSurface& surface, std::size_t first_inner) {
  for (const auto& [edge, uses] : edge_uses(surface, first_inner)) {
    if (uses.size() != 4) continue;
    const std::array<EdgeUse, 4> pairs = wedges(uses);
    std::array<std::array<std::size_t, 2>, 4> places;
    for (std::size_t k = 0; k < 4; ++k) places[k] = place(surface, pairs[k].triangle);
    for (std::size_t k = 0; k < 4; k += 2) {
      const VertexId middle = space.add_middle(edge[0], edge[1]);
      for (const std::size_t use : {k, k + 1}) {
        divide(surface.facets[places[use][0]].triangles, places[use][1], pairs[use].corner, middle);
      }
    }
    return true;
  }
  return false;
}

}  // namespace

void split_fans(ExactSpace& space, ExactSurface& surface, std::size_t first_inner) {
  const std::vector<std::array<VertexId, 3>*> triangles = all_triangles(surface);
  Fans fans = joined_fans(edge_uses(surface, first_inner), 3 * triangles.size());
  std::map<VertexId, std::size_t> first_fan;
  std::map<std::size_t, VertexId> copies;
  for (std::size_t corner = 0; corner < 3 * triangles.size(); ++corner) {
    VertexId& vertex = (*triangles[corner / 3])[corner % 3];
    const std::size_t fan = fans.find_set(corner);
    if (first_fan.try_emplace(vertex, fan).first->second == fan) continue;
    const auto [copy, is_new] = copies.try_emplace(fan, vertex);
    if (is_new) copy->second = space.add_copy(vertex);
    vertex = copy->second;
  }
  while (divide_shared_edge(space, surface, first_inner)) {
  }
}

}  // namespace gnomon
