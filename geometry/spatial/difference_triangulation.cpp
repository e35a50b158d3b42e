#include "geometry/spatial/difference_triangulation.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace gnomon {
namespace {

/// Fills the band between two convex chains, the inner one seen from the outer one. At every step the current inner
/// vertex sees the current outer one. If the outer vertex sees the next inner edge from its right side, that edge
/// closes a triangle; otherwise the inner vertex is the right tangent point of the outer one, and the next outer edge
/// closes a triangle that no inner vertex enters.
void fill_band(const ExactSpace& space, PlaneId plane, const Loop& outer, const Loop& inner, Triangles& triangles) {
  std::size_t a = 0;
  std::size_t b = 0;
  while (a + 1 < outer.size() || b + 1 < inner.size()) {
    const bool inner_left = b + 1 < inner.size();
    const bool outer_left = a + 1 < outer.size();
    if (inner_left && (!outer_left || space.turn(plane, inner[b], inner[b + 1], outer[a]) < 0)) {
      triangles.push_back({outer[a], inner[b + 1], inner[b]});
      ++b;
    } else {
      triangles.push_back({outer[a], outer[a + 1], inner[b]});
      ++a;
    }
  }
}

/// The loop from one position to another, both included, going forward at least one step.
Loop chain(const Loop& loop, std::size_t from, std::size_t to) {
  Loop result = {loop[from]};
  do {
    from = from + 1 == loop.size() ? 0 : from + 1;
    result.push_back(loop[from]);
  } while (from != to);
  return result;
}

/// The inner vertex right of which the outer vertex sees no more of the inner polygon; nothing if it sees no side of
/// it at all, which happens in line with an edge that stands for the polygon.
std::optional<std::size_t> right_tangent(const ExactSpace& space, PlaneId plane, const Loop& inner, VertexId outer) {
  const auto sees = [&](std::size_t b) {
    return space.turn(plane, inner[b], inner[(b + 1) % inner.size()], outer) < 0;
  };
  for (std::size_t b = 0; b < inner.size(); ++b) {
    const std::size_t next = (b + 1) % inner.size();
    if (sees(b) && !sees(next)) return next;
  }
  return std::nullopt;
}

/// Triangles between an outer polygon and an inner one (or an edge, or a point) in its interior.
Triangles ring_triangles(const ExactSpace& space, PlaneId plane, const Loop& outer, const Loop& inner) {
  Triangles triangles;
  if (inner.size() == 1) {
    fill_band(space, plane, chain(outer, 0, 0), inner, triangles);
    return triangles;
  }
  for (std::size_t a = 0; a < outer.size(); ++a) {
    const std::optional<std::size_t> b = right_tangent(space, plane, inner, outer[a]);
    if (!b) continue;
    fill_band(space, plane, chain(outer, a, a), chain(inner, *b, *b), triangles);
    break;
  }
  return triangles;
}

using Positions = std::unordered_map<VertexId, std::size_t>;

/// Triangles between the chains that run from each shared vertex to the next, `shared` being positions on the outer
/// polygon.
Triangles chain_triangles(const ExactSpace& space, PlaneId plane, const Loop& outer, const Loop& inner,
                          const Positions& inner_position, const std::vector<std::size_t>& shared) {
  Triangles triangles;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    const std::size_t from = shared[i];
    const std::size_t to = shared[(i + 1) % shared.size()];
    Loop outer_chain = chain(outer, from, to);
    if (outer_chain.size() == 2) continue;  // a common edge: a convex polygon has no other way between its ends
    outer_chain = Loop(outer_chain.begin() + 1, outer_chain.end() - 1);
    const Loop inner_chain = chain(inner, inner_position.at(outer[from]), inner_position.at(outer[to]));
    fill_band(space, plane, outer_chain, inner_chain, triangles);
  }
  return triangles;
}

}  // namespace

Triangles convex_triangles(const ExactSpace& space, PlaneId plane, Loop loop) {
  Triangles triangles;
  const auto at = [&](std::size_t i) { return loop[i % loop.size()]; };
  const auto is_straight = [&](std::size_t i) {
    const std::size_t n = loop.size();
    return space.turn(plane, at(i + n - 1), at(i), at(i + 1)) == 0;
  };
  // A corner before a straight vertex is cut off first: the straight vertex becomes a corner, and what remains keeps
  // its area. Without straight vertices a fan does.
  for (std::size_t i = 0; i < loop.size() && loop.size() > 3;) {
    const std::size_t n = loop.size();
    if (is_straight(i + 1) && !is_straight(i)) {
      triangles.push_back({at(i + n - 1), at(i), at(i + 1)});
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i % n));
      i = 0;
    } else {
      ++i;
    }
  }
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) triangles.push_back({loop[0], loop[i], loop[i + 1]});
  return triangles;
}

Triangles difference_triangles(const ExactSpace& space, PlaneId plane, const Loop& outer, const Loop& inner) {
  Positions inner_position;
  for (std::size_t b = 0; b < inner.size(); ++b) inner_position[inner[b]] = b;
  std::vector<std::size_t> shared;
  for (std::size_t a = 0; a < outer.size(); ++a) {
    if (inner_position.count(outer[a])) shared.push_back(a);
  }
  if (shared.empty()) return ring_triangles(space, plane, outer, inner);
  if (inner.size() == 1) return convex_triangles(space, plane, outer);
  return chain_triangles(space, plane, outer, inner, inner_position, shared);
}

}  // namespace gnomon
