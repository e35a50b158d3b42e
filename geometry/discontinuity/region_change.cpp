#include "geometry/discontinuity/region_change.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/discontinuity/outline.h"

// Notation. p: a point of the piece, which looks. i, j, k: edges that may bound what is seen from there, n_i the normal
// of the plane through p and edge i. A set of signs over the piece's corners is two bits: 1 negative, 2 positive; 3 is
// both, and 0 none, where all corners see the point in the plane.
//
// Why a triple may be left out; region_change.h says what is proved by that.
//   sides      of the plane through p and an edge on which a point x lies: the sign of |a - p, b - p, x - p|, which is
//              linear in p. One sign at the three corners is the sign in all of the piece.
//   crossing   two edges cross as seen from p only if each has its ends on both sides of the other. If both ends of one
//              are on one side throughout, they never do. The way in which they cross is the sign of one such side.
//   hidden     of edge i the side that is hidden; none if faces lie on both, so that it bounds nothing.
//   up, down   which way one turns from what edge i leaves open to what edge j does: the product of both hidden sides
//              and the way of crossing. If one turns both ways among the three pairs, the three share a direction.
//   in line    where the three meet in one line of sight, |n_i, n_j, n_k| is zero. It is quadratic in p: its Bernstein
//              coefficients are its values at the corners and, of the side from p to q with middle m, half of
//              4 f(m) - f(p) - f(q). Of one sign, they let it vanish at most on the border.

namespace gnomon::event {
namespace {

/// Signs that occur, as bits: 1 negative, 2 positive.
unsigned bit(int sign) {
  return sign < 0 ? 1U : sign > 0 ? 2U : 0U;
}

struct Corner {
  Place place;
  bool is_border = false;
};

/// Three edges, by their indices.
struct Triple {
  std::uint32_t edges[3];
};

struct Piece {
  std::array<Corner, 3> corners;
  std::array<bool, 3> is_border{};
  int halvings = 0;
  std::vector<Triple> triples;
};

/// How two edges cross as seen from the points of a piece.
enum class Crossing : std::int8_t { never = 2, unknown = 0, rising = 1, falling = -1 };

/// The side of an edge that is hidden, as seen from the points of a piece.
enum class Hidden : std::int8_t { none = 2, unknown = 0, positive = 1, negative = -1 };

/// One piece and the edges that matter to it.
class PieceTest {
 public:
  PieceTest(const NumberedOutlines& numbered, const Piece& piece)
      : numbered_(numbered),
        edges_(numbered.edges),
        piece_(piece),
        known_sides_(numbered.edges.size() * numbered.points.size(), unknown_sides) {
    const std::vector<Outline>& edges = numbered.edges;
    normals_.reserve(edges.size());
    for (const Outline& e : edges) {
      normals_.push_back(
          {normal(e, piece.corners[0].place), normal(e, piece.corners[1].place), normal(e, piece.corners[2].place)});
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const ExactVector &p = piece.corners[k].place.exact, &q = piece.corners[(k + 1) % 3].place.exact;
      middles_[k] = Place(Rational(1, 2) * (p + q));
    }
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

  /// True if the three edges' lines meet no line through any point inside the face that belongs to the piece.
  bool are_never_in_line(const Triple& t) const {
    std::array<int, 3> at_corner, between;
    unsigned signs = 0;
    for (std::size_t k = 0; k < 3; ++k) signs |= bit(at_corner[k] = determinant(t, piece_.corners[k].place).sign);
    if (signs == 3U) return false;
    for (std::size_t k = 0; k < 3; ++k) signs |= bit(between[k] = middle_sign(t, k));
    if (signs == 3U || signs == 0U) return false;
    // Inside it vanishes nowhere; on sides and at corners where coefficients do.
    for (std::size_t k = 0; k < 3; ++k) {
      if (at_corner[k] == 0 && !piece_.corners[k].is_border) return false;
      const bool vanishes = at_corner[k] == 0 && between[k] == 0 && at_corner[(k + 1) % 3] == 0;
      if (vanishes && !piece_.is_border[k]) return false;
    }
    return true;
  }

  /// True if an edge of the light parts it from this one, as seen from all of the piece.
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
  static NearVector normal(const Outline& edge, const Place& p) {
    return cross(edge.a.near - p.near, edge.b.near - p.near);
  }

  /// The sides on which a point lies as seen from the corners; exact ones only where intervals do not tell enough.
  unsigned sides_of(std::uint32_t edge, const Place& x) const {
    unsigned sides = 0;
    bool is_known[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto sign = certain_sign(dot(normals_[edge][k], x.near - piece_.corners[k].place.near));
      is_known[k] = sign.has_value();
      if (sign) sides |= bit(*sign);
    }
    for (std::size_t k = 0; k < 3 && sides != 3U; ++k) {
      if (!is_known[k]) sides |= bit(exact_side(edges_[edge], piece_.corners[k].place, x));
    }
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

  struct Value {
    Interval near = 0;
    int sign = 0;
  };

  static Interval near_determinant(const std::vector<Outline>& edges, const Triple& t, const Place& p) {
    NearVector n[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Outline& e = edges[t.edges[k]];
      n[k] = cross(e.a.near - p.near, e.b.near - p.near);
    }
    return dot(cross(n[0], n[1]), n[2]);
  }

  Rational exact_determinant(const Triple& t, const Place& p) const {
    ExactVector n[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Outline& e = edges_[t.edges[k]];
      n[k] = gnomon::cross(e.a.exact - p.exact, e.b.exact - p.exact);
    }
    return gnomon::dot(gnomon::cross(n[0], n[1]), n[2]);
  }

  Value determinant(const Triple& t, const Place& p) const {
    const Interval near = near_determinant(edges_, t, p);
    if (const auto known = certain_sign(near)) return {near, *known};
    return {near, exact_determinant(t, p).sign()};
  }

  /// Sign of the coefficient that belongs to a side.
  int middle_sign(const Triple& t, std::size_t k) const {
    const Place &p = piece_.corners[k].place, &q = piece_.corners[(k + 1) % 3].place;
    const Interval near = Interval(4) * near_determinant(edges_, t, middles_[k]) - near_determinant(edges_, t, p) -
                          near_determinant(edges_, t, q);
    if (const auto known = certain_sign(near)) return *known;
    const Rational exact = 4 * exact_determinant(t, middles_[k]) - exact_determinant(t, p) - exact_determinant(t, q);
    return exact.sign();
  }

  static constexpr std::uint8_t unknown_sides = 4;

  const NumberedOutlines& numbered_;
  const std::vector<Outline>& edges_;
  const Piece& piece_;
  mutable std::vector<std::uint8_t> known_sides_;  ///< edge by edge, of all ends
  std::array<Place, 3> middles_;
  std::vector<std::array<NearVector, 3>> normals_;  ///< of each edge's plane through each corner
};

/// Clears pieces of triples until none is left or the budget is spent.
class ChangeSearch {
 public:
  explicit ChangeSearch(std::vector<Outline> edges) : outlines_(std::move(edges)) {}

  /// Returns: false if the piece is clear.
  bool may_change(Piece piece) {
    piece.triples = crossing_triples(piece);
    std::vector<Piece> stack{std::move(piece)};
    while (!stack.empty()) {
      Piece top = std::move(stack.back());
      stack.pop_back();
      if (++pieces_ > most_pieces) return true;
      clear(top);
      if (top.triples.empty()) continue;
      if (top.halvings == most_halvings) return true;
      halve(top, stack);
    }
    return false;
  }

 private:
  /// All triples that cross pairwise.
  std::vector<Triple> crossing_triples(const Piece& piece) const {
    const PieceTest test(outlines_, piece);
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < outlines_.edges.size(); ++i) {
      if (test.hidden(i) != Hidden::none && !test.is_beside_light(i)) near.push_back(i);
    }
    const auto n = static_cast<std::uint32_t>(near.size());
    std::vector<std::vector<std::uint32_t>> crossed(outlines_.edges.size());
    for (std::uint32_t x = 0; x < n; ++x) {
      for (std::uint32_t y = x + 1; y < n; ++y) {
        const std::uint32_t i = near[x], j = near[y];
        if (!belong_together(outlines_.edges[i], outlines_.edges[j]) && test.crossing(i, j) != Crossing::never)
          crossed[i].push_back(j);
      }
    }
    std::vector<Triple> triples;
    for (const std::uint32_t i : near) {
      for (const std::uint32_t j : crossed[i]) {
        for (const std::uint32_t k : crossed[j]) {
          if (std::binary_search(crossed[i].begin(), crossed[i].end(), k)) triples.push_back({{i, j, k}});
        }
      }
    }
    return triples;
  }

  void clear(Piece& piece) {
    const PieceTest test(outlines_, piece);
    std::vector<std::optional<Crossing>> crossings(outlines_.edges.size() * outlines_.edges.size());
    std::vector<std::optional<Hidden>> hidden(outlines_.edges.size());
    const auto crossing = [&](std::uint32_t i, std::uint32_t j) {
      auto& known = crossings[i * outlines_.edges.size() + j];
      if (!known) known = test.crossing(i, j);
      return *known;
    };
    const auto hidden_side = [&](std::uint32_t i) {
      if (!hidden[i]) hidden[i] = test.hidden(i);
      return *hidden[i];
    };
    std::erase_if(piece.triples, [&](const Triple& t) {
      const auto [i, j, k] = t.edges;
      const Crossing c[] = {crossing(i, j), crossing(j, k), crossing(i, k)};
      if (std::find(std::begin(c), std::end(c), Crossing::never) != std::end(c)) return true;
      const Hidden h[] = {hidden_side(i), hidden_side(j), hidden_side(k)};
      if (std::find(std::begin(h), std::end(h), Hidden::none) != std::end(h)) return true;
      const int s[] = {int(h[0]) * int(h[1]) * int(c[0]), int(h[1]) * int(h[2]) * int(c[1]),
                       -int(h[0]) * int(h[2]) * int(c[2])};
      const bool up = s[0] > 0 || s[1] > 0 || s[2] > 0, down = s[0] < 0 || s[1] < 0 || s[2] < 0;
      if (up && down) return true;
      return test.are_never_in_line(t);
    });
  }

  static void halve(const Piece& piece, std::vector<Piece>& pieces) {
    const auto length = [&](std::size_t k) {
      const NearVector way = piece.corners[(k + 1) % 3].place.near - piece.corners[k].place.near;
      return dot(way, way).sup();
    };
    std::size_t k = 0;
    for (std::size_t other = 1; other < 3; ++other) {
      if (length(other) > length(k)) k = other;
    }
    const Corner &p = piece.corners[k], &q = piece.corners[(k + 1) % 3], &r = piece.corners[(k + 2) % 3];
    const Corner m{Place(Rational(1, 2) * (p.place.exact + q.place.exact)), piece.is_border[k]};
    const bool pq = piece.is_border[k], qr = piece.is_border[(k + 1) % 3], rp = piece.is_border[(k + 2) % 3];
    pieces.push_back({{p, m, r}, {pq, false, rp}, piece.halvings + 1, piece.triples});
    pieces.push_back({{m, q, r}, {pq, qr, false}, piece.halvings + 1, piece.triples});
  }

  NumberedOutlines outlines_;
  int pieces_ = 0;
};

}  // namespace

bool region_may_change(const EventScene& scene, std::span<const ShapeId> shapes, std::span<const FacePiece> face) {
  const CGAL::Protect_FPU_rounding<true> upward;
  std::vector<Outline> edges = outlines(scene, shapes);
  if (edges.size() > most_outlines) return true;
  ChangeSearch search(std::move(edges));
  return std::any_of(face.begin(), face.end(), [&](const FacePiece& piece) {
    const auto corner = [&](std::size_t k) { return Corner{Place(piece.corners[k]), true}; };
    return search.may_change({{corner(0), corner(1), corner(2)}, piece.is_border, 0, {}});
  });
}

}  // namespace gnomon::event
