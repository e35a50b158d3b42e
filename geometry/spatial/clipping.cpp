#include "geometry/spatial/clipping.h"

#include <algorithm>
#include <utility>

#include "geometry/spatial/half_edge_polyhedron.h"

namespace gnomon {
namespace {

using Index = HalfEdgePolyhedron::Index;
constexpr Index no_cut = HalfEdgePolyhedron::none;

/// The planes still to come, each waiting at a vertex outside of it.
class Waiting {
 public:
  Waiting(const ExactSpace& space, const HalfEdgePolyhedron& polyhedron, const std::vector<Cut>& cuts)
      : space_(space), cuts_(cuts), vertex_(cuts.size(), no_cut), next_(cuts.size(), no_cut) {
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const std::optional<Index> found =
          cuts[i].outside ? polyhedron.index_of(*cuts[i].outside) : polyhedron.vertex_outside(cuts[i].plane);
      if (found) place(static_cast<Index>(i), *found);
    }
  }

  Index vertex(std::size_t cut) const { return vertex_[cut]; }

  /// Moves those that waited at a vertex now gone to one of the new face.
  void move(const HalfEdgePolyhedron& polyhedron, std::size_t done) {
    vertex_[done] = no_cut;
    for (const Index gone : polyhedron.removed()) {
      if (gone >= first_.size()) continue;
      Index cut = std::exchange(first_[gone], no_cut);
      while (cut != no_cut) {
        const Index following = next_[cut];
        if (vertex_[cut] != no_cut) find_place(polyhedron, cut);
        cut = following;
      }
    }
  }

 private:
  void place(Index cut, Index vertex) {
    if (vertex >= first_.size()) first_.resize(vertex + 1, no_cut);
    vertex_[cut] = vertex;
    next_[cut] = std::exchange(first_[vertex], cut);
  }
  void find_place(const HalfEdgePolyhedron& polyhedron, Index cut) {
    vertex_[cut] = no_cut;
    for (const Index v : polyhedron.boundary()) {
      if (space_.side(cuts_[cut].plane, polyhedron.id(v)) > 0) return place(cut, v);
    }
  }

  const ExactSpace& space_;
  const std::vector<Cut>& cuts_;
  std::vector<Index> vertex_;  ///< where a cut waits; none: it is done or redundant
  std::vector<Index> next_;
  std::vector<Index> first_;  ///< of the cuts that wait at a vertex
};

/// A fixed shuffle: an order without regard to how the planes came, which keeps the expected cost low.
template <class Value>
void mix(std::vector<Value>& values) {
  std::uint64_t state = 0x9e3779b97f4a7c15u;
  for (std::size_t i = values.size(); i > 1; --i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    std::swap(values[i - 1], values[(state >> 33) % i]);
  }
}

}  // namespace

ConvexPolyhedron clipped(ExactSpace& space, const ConvexPolyhedron& polyhedron, std::vector<Cut> cuts,
                         std::span<const PlaneId> last) {
  if (polyhedron.empty()) return polyhedron;
  mix(cuts);
  std::stable_partition(cuts.begin(), cuts.end(), [](const Cut& cut) { return cut.first; });
  HalfEdgePolyhedron result(space, polyhedron);
  Waiting waiting(space, result, cuts);
  for (std::size_t i = 0; i < cuts.size() && !result.empty(); ++i) {
    if (waiting.vertex(i) == no_cut) continue;
    result.cut(cuts[i].plane, waiting.vertex(i));
    waiting.move(result, i);
  }
  for (const PlaneId plane : last) {
    if (result.empty()) break;
    const std::optional<Index> outside = result.vertex_outside(plane);
    if (outside) result.cut(plane, *outside);
  }
  return result.polyhedron();
}

ConvexPolyhedron clipped(ExactSpace& space, const ConvexPolyhedron& polyhedron, PlaneId plane) {
  return clipped(space, polyhedron, {}, {&plane, 1});
}

}  // namespace gnomon
