#include "geometry/discontinuity/closing_triples.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

// Notation. p: a point of the face, which looks. i, j, k: edges that may bound what is seen from there. A set of signs
// over the face's corners is two bits: 1 negative, 2 positive; 3 is both, and 0 none, where all corners see the point
// in the plane.
//
// Why a triple may be left out; closing_arcs.h says what is proved by that.
//   sides      of the plane through p and an edge on which a point x lies: the sign of |a - p, b - p, x - p|, which is
//              linear in p. One sign at all corners is the sign in all of their hull.
//   crossing   two edges cross as seen from p only if each has its ends on both sides of the other. If both ends of one
//              are on one side throughout, they never do. The way in which they cross is the sign of one such side.
//   hidden     of edge i the side that is hidden; none if faces lie on both, so that it bounds nothing.
//   up, down   which way one turns from what edge i leaves open to what edge j does: the product of both hidden sides
//              and the way of crossing. If one turns both ways among the three pairs, the three share a direction.

namespace gnomon::event {
namespace {

/// Signs that occur, as bits: 1 negative, 2 positive.
unsigned bit(int sign) {
  return sign < 0 ? 1U : sign > 0 ? 2U : 0U;
}

/// How two edges cross as seen from the points of a face.
enum class Crossing : std::int8_t { never = 2, unknown = 0, rising = 1, falling = -1 };

/// The side of an edge that is hidden, as seen from the points of a face.
enum class Hidden : std::int8_t { none = 2, unknown = 0, positive = 1, negative = -1 };

/// A plane through three points with whole coordinates.
class WholePlane {
 public:
  WholePlane(const Quadruple<Integer>& a, const Quadruple<Integer>& b, const Quadruple<Integer>& c) {
    const auto vector = [](const Quadruple<Integer>& p) { return Vector3<Integer>{p[0], p[1], p[2]}; };
    const Vector3<Integer> bc = cross(vector(b), vector(c));
    normal_ = c[3] * cross(vector(a), vector(b)) + a[3] * bc + b[3] * cross(vector(c), vector(a));
    offset_ = -dot(vector(a), bc);
  }

  /// Positive where the three run counterclockwise.
  int side(const Quadruple<Integer>& p) const {
    return Integer(normal_.x * p[0] + normal_.y * p[1] + normal_.z * p[2] + offset_ * p[3]).sign();
  }

 private:
  Vector3<Integer> normal_;
  Integer offset_;
};

/// A face and the edges that may matter to it.
class EdgesOfFace {
 public:
  EdgesOfFace(const NumberedSilhouettes& numbered, std::span<const Place> corners)
      : numbered_(numbered),
        edges_(numbered.edges),
        corners_(corners),
        known_sides_(numbered.edges.size() * numbered.points.size(), unknown_sides) {
    normals_.reserve(edges_.size() * corners.size());
    for (const SilhouetteEdge& e : edges_) {
      for (const Place& p : corners) normals_.push_back(cross(e.a.near - p.near, e.b.near - p.near));
      whole_ends_.push_back({whole_coordinates(e.a.exact), whole_coordinates(e.b.exact)});
    }
    for (const Place& p : corners) whole_corners_.push_back(whole_coordinates(p.exact));
  }

  Crossing crossing(std::uint32_t i, std::uint32_t j) const {
    const auto [a, b] = sides_of_ends(i, j);
    if ((a | b) != 3U || a == 0U || b == 0U) return Crossing::never;
    const auto [c, d] = sides_of_ends(j, i);
    if ((c | d) != 3U || c == 0U || d == 0U) return Crossing::never;
    // One end on one side throughout tells on which side the other is wherever they cross.
    if (b == 2U || a == 1U) return Crossing::rising;
    if (b == 1U || a == 2U) return Crossing::falling;
    if (c == 2U || d == 1U) return Crossing::rising;
    if (c == 1U || d == 2U) return Crossing::falling;
    return Crossing::unknown;
  }

  Hidden hidden(std::uint32_t i) const {
    if (edges_[i].hidden.empty()) return Hidden::unknown;
    bool positive = false, negative = false;
    for (const Place& x : edges_[i].hidden) {
      const unsigned sides = sides_of(i, x);
      if (sides == 3U) return Hidden::unknown;
      positive = positive || sides == 2U;
      negative = negative || sides == 1U;
    }
    if (positive && negative) return Hidden::none;
    return positive ? Hidden::positive : negative ? Hidden::negative : Hidden::unknown;
  }

  /// True if an edge of the light parts it from this one, as seen from all of the face.
  bool is_beside_light(std::uint32_t i) const {
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (!edges_[e].is_of_light || edges_[e].hidden.empty()) break;
      const unsigned beyond = sides_of(e, edges_[e].hidden.front());
      if (beyond == 3U || beyond == 0U) continue;
      const auto [a, b] = sides_of_ends(e, i);
      if ((a | b | beyond) == beyond && !edges_[i].is_of_light) return true;
    }
    return false;
  }

 private:
  /// The sides on which a point lies as seen from the corners; exact ones only where intervals do not tell enough.
  unsigned sides_of(std::uint32_t edge, const Place& x) const {
    unsigned sides = 0;
    std::vector<std::uint32_t> unknown;
    for (std::uint32_t k = 0; k < corners_.size() && sides != 3U; ++k) {
      const auto sign = certain_sign(dot(normals_[edge * corners_.size() + k], x.near - corners_[k].near));
      if (sign) {
        sides |= bit(*sign);
      } else {
        unknown.push_back(k);
      }
    }
    if (sides == 3U || unknown.empty()) return sides;
    const WholePlane plane(whole_ends_[edge][0], whole_ends_[edge][1], whole_coordinates(x.exact));
    for (const std::uint32_t k : unknown) sides |= bit(-plane.side(whole_corners_[k]));
    return sides;
  }

  /// Of the ends of another edge. Many edges share an end, so what was found is kept.
  std::pair<unsigned, unsigned> sides_of_ends(std::uint32_t edge, std::uint32_t other) const {
    const auto sides = [&](std::uint32_t point, const Place& x) -> unsigned {
      std::uint8_t& known = known_sides_[edge * numbered_.points.size() + point];
      if (known == unknown_sides) known = static_cast<std::uint8_t>(sides_of(edge, x));
      return known;
    };
    const auto& [a, b] = numbered_.ends[other];
    return {sides(a, edges_[other].a), sides(b, edges_[other].b)};
  }

  static constexpr std::uint8_t unknown_sides = 4;

  const NumberedSilhouettes& numbered_;
  const std::vector<SilhouetteEdge>& edges_;
  std::span<const Place> corners_;
  std::vector<Quadruple<Integer>> whole_corners_;
  std::vector<std::array<Quadruple<Integer>, 2>> whole_ends_;  ///< of edges
  mutable std::vector<std::uint8_t> known_sides_;              ///< edge by edge, of all ends
  std::vector<NearVector> normals_;                            ///< edge by edge, of its planes through the corners
};

/// Finds triples that cross pairwise, by ascending indices.
class TripleSearch {
 public:
  TripleSearch(const NumberedSilhouettes& silhouette_edges, std::span<const Place> corners)
      : silhouette_edges_(silhouette_edges),
        edges_(silhouette_edges, corners),
        crossed_(silhouette_edges.edges.size()) {
    const std::size_t n = silhouette_edges.edges.size();
    hidden_.assign(n, Hidden::none);
    for (std::uint32_t i = 0; i < n; ++i) {
      if (edges_.is_beside_light(i)) continue;
      hidden_[i] = edges_.hidden(i);
      if (hidden_[i] != Hidden::none) near_.push_back(i);
    }
    for (std::size_t x = 0; x < near_.size(); ++x) {
      for (std::size_t y = x + 1; y < near_.size(); ++y) find_crossing(near_[x], near_[y]);
    }
  }

  std::vector<EdgeTriple> triples(bool is_linear) const {
    std::vector<EdgeTriple> found;
    for (const std::uint32_t i : near_) {
      if (is_linear && !silhouette_edges_.edges[i].is_of_light) break;
      for (const Crossed& ij : crossed_[i]) append(i, ij, found);
    }
    return found;
  }

 private:
  struct Crossed {
    std::uint32_t edge = 0;
    Crossing way = Crossing::unknown;
  };

  void find_crossing(std::uint32_t i, std::uint32_t j) {
    if (belong_together(silhouette_edges_.edges[i], silhouette_edges_.edges[j])) return;
    const Crossing way = edges_.crossing(i, j);
    if (way != Crossing::never) crossed_[i].push_back({j, way});
  }

  /// Those of two edges and a third one that both cross.
  void append(std::uint32_t i, const Crossed& ij, std::vector<EdgeTriple>& found) const {
    auto ik = crossed_[i].begin();
    for (const Crossed& jk : crossed_[ij.edge]) {
      while (ik != crossed_[i].end() && ik->edge < jk.edge) ++ik;
      if (ik == crossed_[i].end()) return;
      if (ik->edge == jk.edge && may_close(i, ij, jk, *ik)) found.push_back({i, ij.edge, jk.edge});
    }
  }

  bool may_close(std::uint32_t i, const Crossed& ij, const Crossed& jk, const Crossed& ik) const {
    const int h[] = {int(hidden_[i]), int(hidden_[ij.edge]), int(hidden_[jk.edge])};
    const int turns[] = {h[0] * h[1] * int(ij.way), h[1] * h[2] * int(jk.way), -h[0] * h[2] * int(ik.way)};
    const auto is_up = [](int turn) { return turn > 0; };
    const auto is_down = [](int turn) { return turn < 0; };
    return std::none_of(std::begin(turns), std::end(turns), is_up) ||
           std::none_of(std::begin(turns), std::end(turns), is_down);
  }

  const NumberedSilhouettes& silhouette_edges_;
  EdgesOfFace edges_;
  std::vector<Hidden> hidden_;                 ///< of each edge; none of those that do not matter
  std::vector<std::uint32_t> near_;            ///< edges that may matter
  std::vector<std::vector<Crossed>> crossed_;  ///< of each edge those after it
};

}  // namespace

std::vector<EdgeTriple> closing_triples(const NumberedSilhouettes& silhouette_edges, std::span<const Place> corners,
                                        bool is_linear) {
  return TripleSearch(silhouette_edges, corners).triples(is_linear);
}

}  // namespace gnomon::event
