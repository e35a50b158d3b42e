#include "geometry/spatial/split_fans.h"

#include <algorithm>
#include <map>
#include <numeric>

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
class Fans {
 public:
  explicit Fans(std::size_t corners) : parent_(corners) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  std::size_t representative(std::size_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  /// Joins two triangles along an edge that they use in opposite directions.
  void join(const EdgeUse& a, const EdgeUse& b) {
    parent_[representative(a.start())] = representative(b.end());
    parent_[representative(a.end())] = representative(b.start());
  }

 private:
  std::vector<std::size_t> parent_;
};

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

void join_triangles(Fans& fans, const std::vector<EdgeUse>& uses) {
  if (uses.size() == 2) {
    fans.join(uses[0], uses[1]);
    return;
  }
  for (const EdgeUse& outer : uses) {
    for (const EdgeUse& inner : uses) {
      if (!outer.inner && inner.inner && outer.forward != inner.forward) fans.join(outer, inner);
    }
  }
}

}  // namespace

void split_fans(ExactSpace& space, ExactSurface& surface, std::size_t first_inner) {
  const std::vector<std::array<VertexId, 3>*> triangles = all_triangles(surface);
  Fans fans(3 * triangles.size());
  for (const auto& [edge, uses] : edge_uses(surface, first_inner)) join_triangles(fans, uses);
  std::map<VertexId, std::size_t> first_fan;
  std::map<std::size_t, VertexId> copies;
  for (std::size_t corner = 0; corner < 3 * triangles.size(); ++corner) {
    VertexId& vertex = (*triangles[corner / 3])[corner % 3];
    const std::size_t fan = fans.representative(corner);
    if (first_fan.try_emplace(vertex, fan).first->second == fan) continue;
    const auto [copy, is_new] = copies.try_emplace(fan, vertex);
    if (is_new) copy->second = space.add_copy(vertex);
    vertex = copy->second;
  }
}

}  // namespace gnomon
