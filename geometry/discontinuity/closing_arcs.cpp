#include "geometry/discontinuity/closing_arcs.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include "geometry/discontinuity/open_lines.h"
#include "geometry/discontinuity/outline.h"

// Notation. p: a point of the piece, which looks. i, j, k: edges that may bound what is seen from there, n_i the normal
// of the plane through p and edge i. A set of signs over the piece's corners is two bits: 1 negative, 2 positive; 3 is
// both, and 0 none, where all corners see the point in the plane.
//
// Why a triple may be left out; closing_arcs.h says what is proved by that.
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
//
// How the others are traced. l(t): the point of one of the three, the base, at the share t of its length. The planes
// through l(t) and either of the other two, j and k, meet the receiver's plane in lines that turn about points as t
// grows, and p(t), where the two cross, is what sees all three in line at l(t). The line meets j between its ends a and
// b where |l(t), k, a| and |l(t), k, b|, linear functions of t, differ in sign.

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
struct EdgeTriple {
  std::uint32_t edges[3];
};

struct Piece {
  std::array<Corner, 3> corners;
  std::array<bool, 3> is_border{};
  int halvings = 0;
  std::vector<EdgeTriple> triples;
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
  bool are_never_in_line(const EdgeTriple& t) const {
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

  static Interval near_determinant(const std::vector<Outline>& edges, const EdgeTriple& t, const Place& p) {
    NearVector n[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Outline& e = edges[t.edges[k]];
      n[k] = cross(e.a.near - p.near, e.b.near - p.near);
    }
    return dot(cross(n[0], n[1]), n[2]);
  }

  Rational exact_determinant(const EdgeTriple& t, const Place& p) const {
    ExactVector n[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Outline& e = edges_[t.edges[k]];
      n[k] = gnomon::cross(e.a.exact - p.exact, e.b.exact - p.exact);
    }
    return gnomon::dot(gnomon::cross(n[0], n[1]), n[2]);
  }

  Value determinant(const EdgeTriple& t, const Place& p) const {
    const Interval near = near_determinant(edges_, t, p);
    if (const auto known = certain_sign(near)) return {near, *known};
    return {near, exact_determinant(t, p).sign()};
  }

  /// Sign of the coefficient that belongs to a side.
  int middle_sign(const EdgeTriple& t, std::size_t k) const {
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

struct EdgeTripleOrder {
  bool operator()(const EdgeTriple& a, const EdgeTriple& b) const {
    return std::ranges::lexicographical_compare(a.edges, b.edges);
  }
};

using EdgeTriples = std::set<EdgeTriple, EdgeTripleOrder>;

/// Clears pieces of triples, halving them, until none is left or so much was done that tracing the rest costs less.
class TripleSearch {
 public:
  TripleSearch(const NumberedOutlines& outlines, bool is_linear) : outlines_(outlines), is_linear_(is_linear) {}

  /// Adds the triples of which a piece was not cleared.
  void append_triples(Piece piece, EdgeTriples& found) {
    piece.triples = crossing_triples(piece);
    std::vector<Piece> stack{std::move(piece)};
    while (!stack.empty()) {
      Piece top = std::move(stack.back());
      stack.pop_back();
      const bool is_last = ++pieces_ > most_pieces || top.halvings == most_halvings;
      clear(top);
      if (is_last) {
        found.insert(top.triples.begin(), top.triples.end());
      } else if (!top.triples.empty()) {
        halve(top, stack);
      }
    }
  }

 private:
  /// All triples that cross pairwise.
  std::vector<EdgeTriple> crossing_triples(const Piece& piece) const {
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
    std::vector<EdgeTriple> triples;
    for (const std::uint32_t i : near) {
      if (is_linear_ && !outlines_.edges[i].is_of_light) break;
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
    std::erase_if(piece.triples, [&](const EdgeTriple& t) {
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

  static constexpr int most_halvings = 10;
  static constexpr int most_pieces = 400;

  const NumberedOutlines& outlines_;
  bool is_linear_;
  int pieces_ = 0;
};

/// The ranges of 0 <= t <= 1 on which the product of two functions is not positive, each linear between its values at
/// 0 and 1.
std::vector<conic::Range> ranges_of_difference(const std::array<Rational, 2>& u, const std::array<Rational, 2>& w) {
  std::vector<Rational> ends{Rational(0), Rational(1)};
  for (const auto* f : {&u, &w}) {
    if ((*f)[0].sign() * (*f)[1].sign() < 0) ends.emplace_back((*f)[0] / ((*f)[0] - (*f)[1]));
  }
  std::sort(ends.begin(), ends.end());
  std::vector<conic::Range> found;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    if (ends[k] == ends[k + 1]) continue;
    const Rational t = (ends[k] + ends[k + 1]) / 2;
    const auto sign = [&](const std::array<Rational, 2>& f) { return Rational(f[0] + t * (f[1] - f[0])).sign(); };
    if (sign(u) * sign(w) <= 0) found.push_back({ends[k], ends[k + 1]});
  }
  return found;
}

std::vector<conic::Range> common_ranges(std::span<const conic::Range> a, std::span<const conic::Range> b) {
  std::vector<conic::Range> found;
  for (const conic::Range& p : a) {
    for (const conic::Range& q : b) {
      conic::Range both{std::max(p.from, q.from), std::min(p.to, q.to)};
      if (both.from < both.to) found.push_back(std::move(both));
    }
  }
  return found;
}

/// Traces triples on a receiver's plane.
class TripleTracer {
 public:
  TripleTracer(const std::vector<Outline>& edges, const ReceiverPlane& plane, Rational half_width)
      : edges_(edges), half_width_(std::move(half_width)) {
    origin_ = plane.spatial(FlatPoint{0, 0});
    along_x_ = plane.spatial(FlatPoint{1, 0}) - origin_;
    along_y_ = plane.spatial(FlatPoint{0, 1}) - origin_;
  }

  /// Those of three edges no two of which lie in one plane are given with their lines, to be looked at.
  void append_traces(const EdgeTriple& t, std::uint32_t name, std::vector<conic::NamedArc>& found,
                     std::vector<ArcOfLines>& with_lines) const {
    bool is_general = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = t.edges[k], j = t.edges[(k + 1) % 3], other = t.edges[(k + 2) % 3];
      if (!are_coplanar(edges_[i], edges_[j])) continue;
      is_general = false;
      append_traces_of_coplanar(edges_[i], edges_[j], edges_[other], name, found);
    }
    if (is_general) append_arcs(edges_[t.edges[0]], edges_[t.edges[1]], edges_[t.edges[2]], with_lines);
  }

 private:
  static Rational volume(const ExactVector& p, const ExactVector& a, const ExactVector& b, const ExactVector& c) {
    return dot(cross(a - p, b - p), c - p);
  }

  static bool are_coplanar(const Outline& i, const Outline& j) {
    const auto near = certain_sign(dot(cross(i.b.near - i.a.near, j.a.near - i.a.near), j.b.near - i.a.near));
    if (near) return *near == 0;
    return volume(i.a.exact, i.b.exact, j.a.exact, j.b.exact) == 0;
  }

  /// The trace of the plane through three points.
  std::array<Rational, 3> trace(const ExactVector& p, const ExactVector& a, const ExactVector& b) const {
    const ExactVector normal = cross(a - p, b - p);
    return {dot(normal, origin_ - p), dot(normal, along_x_), dot(normal, along_y_)};
  }

  conic::LinePencil pencil(const Outline& base, const Outline& edge) const {
    return conic::line_pencil(trace(base.a.exact, edge.a.exact, edge.b.exact),
                              trace(base.b.exact, edge.a.exact, edge.b.exact));
  }

  void append_arcs(const Outline& base, const Outline& j, const Outline& k, std::vector<ArcOfLines>& found) const {
    const auto sides = [&](const Outline& edge, const ExactVector& x) -> std::array<Rational, 2> {
      return {volume(base.a.exact, edge.a.exact, edge.b.exact, x), volume(base.b.exact, edge.a.exact, edge.b.exact, x)};
    };
    const auto meets_j = ranges_of_difference(sides(k, j.a.exact), sides(k, j.b.exact));
    const auto meets_k = ranges_of_difference(sides(j, k.a.exact), sides(j, k.b.exact));
    const auto ranges = common_ranges(meets_j, meets_k);
    if (ranges.empty()) return;
    const conic::LinePencil of_j = pencil(base, j), of_k = pencil(base, k);
    for (const conic::Range& range : ranges) {
      for (conic::FlatArc& arc : conic::arcs(of_j, of_k, range, half_width_)) {
        found.push_back({std::move(arc), of_j, {&base, &j, &k}});
      }
    }
  }

  void append_trace(const std::array<Rational, 3>& line, std::uint32_t name,
                    std::vector<conic::NamedArc>& found) const {
    if (line[1] == 0 && line[2] == 0) return;
    const conic::LinePencil both = conic::line_pencil(line, line);
    found.push_back({{conic::straight_curve(both.start), Rational(-half_width_), half_width_}, name});
  }

  /// The lines in the edges' common plane are traced with wedges (coplanar_pairs). Left are those through the point
  /// where the two cross.
  void append_traces_of_coplanar(const Outline& i, const Outline& j, const Outline& other, std::uint32_t name,
                                 std::vector<conic::NamedArc>& found) const {
    const ExactVector &a = i.a.exact, &b = i.b.exact, &c = j.a.exact, &d = j.b.exact;
    // Share of the way from a to b at which j's line is met, by areas in the plane of the two.
    const ExactVector of_a = cross(c - a, d - a), of_b = cross(c - b, d - b);
    if (is_zero(of_a) || is_zero(of_b) || dot(of_a, of_b) >= 0) return;
    const ExactVector difference = of_a - of_b;
    const Rational share = dot(of_a, difference) / dot(difference, difference);
    const ExactVector meeting = a + share * (b - a);
    if (dot(c - meeting, d - meeting) >= 0) return;  // at an end of j, or beyond
    append_trace(trace(meeting, other.a.exact, other.b.exact), name, found);
  }

  const std::vector<Outline>& edges_;
  Rational half_width_;
  ExactVector origin_, along_x_, along_y_;
};

/// A triangle of the face on the receiver's plane.
class FlatTriangle {
 public:
  FlatTriangle(const FacePiece& piece, const ReceiverPlane& plane) {
    for (std::size_t k = 0; k < 3; ++k) corners_[k] = plane.flat(piece.corners[k]);
    for (std::size_t k = 0; k < 3; ++k) sides_[k] = conic::line_through(corners_[k], corners_[(k + 1) % 3]);
    const FlatPoint &a = corners_[0], &b = corners_[1], &c = corners_[2];
    inside_ = Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).sign();
  }

  /// False only if the arc lies beyond one side.
  bool may_meet(const conic::FlatArc& arc) const {
    const auto end = [](const Rational& t) {
      const auto [low, high] = CGAL::to_interval(t);
      return Interval(low, high);
    };
    const Interval from = end(arc.from), to = end(arc.to);
    const Polynomial w(arc.curve.point[0]);
    if (!w.is_certainly_signed(from, to)) return true;
    const int sign = w.sign_at(arc.from) * inside_;
    return std::none_of(sides_.begin(), sides_.end(), [&](const conic::Covector& side) {
      const Polynomial height(conic::along(side, arc.curve));
      return height.is_certainly_signed(from, to) && height.sign_at(arc.from) * sign < 0;
    });
  }

  std::span<const FlatPoint> corners() const { return corners_; }

 private:
  std::array<FlatPoint, 3> corners_;
  std::array<conic::Covector, 3> sides_;
  int inside_ = 1;
};

Rational half_width_of(std::span<const FlatTriangle> triangles) {
  Rational most = 1;
  for (const FlatTriangle& t : triangles) {
    for (const FlatPoint& p : t.corners()) most = std::max({most, Rational(abs(p.x)), Rational(abs(p.y))});
  }
  return 2 * most;
}

std::vector<FlatEnclosure> boxes_around(std::span<const FlatTriangle> triangles) {
  std::vector<FlatEnclosure> boxes;
  for (const FlatTriangle& t : triangles) {
    const FlatPoint &a = t.corners()[0], &b = t.corners()[1], &c = t.corners()[2];
    const auto span = [](const Rational& p, const Rational& q, const Rational& r) {
      return Interval(CGAL::to_interval(std::min({p, q, r})).first, CGAL::to_interval(std::max({p, q, r})).second);
    };
    boxes.push_back({span(a.x, b.x, c.x), span(a.y, b.y, c.y)});
  }
  return boxes;
}

EdgeTriples closing_triples(const NumberedOutlines& outlines, std::span<const FacePiece> pieces, bool is_linear) {
  EdgeTriples triples;
  TripleSearch search(outlines, is_linear);
  for (const FacePiece& piece : pieces) {
    const auto corner = [&](std::size_t k) { return Corner{Place(piece.corners[k]), true}; };
    search.append_triples({{corner(0), corner(1), corner(2)}, piece.is_border, 0, {}}, triples);
  }
  return triples;
}

}  // namespace

ClosingArcs closing_arcs(const EventScene& scene, std::span<const ShapeId> shapes, std::span<const FacePiece> pieces,
                         const ReceiverPlane& plane) {
  const CGAL::Protect_FPU_rounding<true> upward;
  const NumberedOutlines outlines(event::outlines(scene, shapes));
  const bool is_linear = scene.kind == LightKind::linear;
  const EdgeTriples triples = closing_triples(outlines, pieces, is_linear);
  std::vector<FlatTriangle> triangles;
  for (const FacePiece& piece : pieces) triangles.emplace_back(piece, plane);
  ClosingArcs found;
  if (triples.empty()) return found;
  const TripleTracer tracer(outlines.edges, plane, half_width_of(triangles));
  OpenLines open_lines(scene, shapes, plane, boxes_around(triangles));
  for (const EdgeTriple& triple : triples) {
    std::vector<conic::NamedArc> traced;
    std::vector<ArcOfLines> with_lines;
    const auto name = static_cast<std::uint32_t>(found.names.size());
    tracer.append_traces(triple, name, traced, with_lines);
    for (const ArcOfLines& arc : with_lines) {
      for (const conic::Range& range : open_lines.ranges(arc)) {
        traced.push_back({{arc.arc.curve, range.from, range.to}, name});
      }
    }
    std::erase_if(traced, [&](const conic::NamedArc& arc) {
      return std::none_of(triangles.begin(), triangles.end(),
                          [&](const FlatTriangle& t) { return t.may_meet(arc.arc); });
    });
    if (traced.empty()) continue;
    found.arcs.insert(found.arcs.end(), std::make_move_iterator(traced.begin()), std::make_move_iterator(traced.end()));
    found.names.push_back({outlines.edges[triple.edges[0]].name, outlines.edges[triple.edges[1]].name,
                           outlines.edges[triple.edges[2]].name});
  }
  return found;
}

}  // namespace gnomon::event
