#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <utility>

#include "geometry/conics/curve_map.h"
#include "geometry/numbers/rounding.h"

// The cells between the pieces of a map: cuts that join what hangs together, the order around nodes, a point inside.

namespace gnomon::conic {

bool CurveMap::add_cuts() {
  boost::disjoint_sets_with_storage<> sets(nodes_.size());
  for (const Piece& p : pieces_) sets.union_set(p.start, p.end);
  // The polygon's rightmost vertex is one of the outer boundary, and vertices are nodes of the same number.
  Rational right = sides_.front().from.x;
  std::uint32_t rightmost = sides_.front().from_vertex;
  for (const Side& s : sides_) {
    if (s.from.x <= right) continue;
    right = s.from.x;
    rightmost = s.from_vertex;
  }
  std::set<unsigned long> joined{sets.find_set(rightmost)};
  bool is_any = false;
  for (Piece& p : pieces_) {
    if (!joined.insert(sets.find_set(p.start)).second) continue;
    const FlatPoint start = *curves_[p.curve].at(number_between(p.from, p.to));
    const FlatPoint end{Rational(right + 1), start.y};
    const std::uint32_t c = curve_like(straight_curve(line_through(start, end)));
    stretches_[c].push_back({start.x, end.x, nowhere, true, std::nullopt});
    is_any = true;
  }
  return is_any;
}

/// A point of the curve just beyond a node, before it meets the other curve again.
FlatPoint CurveMap::point_near(const End& end, int way, const FlatCurve& other) const {
  const Piece& piece = pieces_[end.piece];
  const FlatCurve& curve = curves_[piece.curve];
  RealRoot root = end.way > 0 ? piece.from : piece.to;
  const Polynomial form = form_along(other, curve);
  const Polynomial infinity(curve.point[0]);
  // Of the piece itself no other curve is met inside, nor infinity; the other way a place is looked for.
  RealRoot far = way == end.way ? (end.way > 0 ? piece.to : piece.from)
                                : rational_root(way > 0 ? Rational(root.high + 1) : Rational(root.low - 1));
  const RootCounter meetings(form);
  const RootCounter poles(infinity);
  while (true) {
    const Rational at = way > 0 ? number_between(root, far) : number_between(far, root);
    // Between the root, which lies in (low, high], and `at` there is no other one.
    const auto others = [&](const RootCounter& counter) {
      if (counter.square_free()->degree() <= 0) return 0;
      const Rational low = way > 0 ? root.low : at, high = way > 0 ? at : root.high;
      return counter.count(low, high) + (counter.square_free()->sign_at(low) == 0 ? 1 : 0);
    };
    if (others(meetings) <= 1 && others(poles) == 0) return *curve.at(at);
    far = rational_root(at);
    refine(root);
  }
}

/// +1 if the other curve, as it leaves the node in some direction, lies on the left of the first as that one does.
int CurveMap::side_of(const End& line, const End& other, int other_way) const {
  const Piece& piece = pieces_[line.piece];
  const FlatCurve& curve = curves_[piece.curve];
  RealRoot from = piece.from, to = piece.to;
  const int positive = positive_side(curve, number_between(from, to));
  return side(curve, point_near(other, other_way, curve)) * positive * line.way;
}

/// Counterclockwise.
std::vector<CurveMap::End> CurveMap::ordered(std::vector<End> ends) const {
  if (ends.size() < 3) return ends;
  const auto curve_of = [&](const End& e) { return pieces_[e.piece].curve; };
  const End first = ends.front();
  std::vector<End> left, right, result{first};
  std::optional<End> opposite;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    if (curve_of(ends[k]) == curve_of(first)) {
      opposite = ends[k];
    } else {
      (side_of(first, ends[k], ends[k].way) > 0 ? left : right).push_back(ends[k]);
    }
  }
  // Which of two comes first as one turns from a half of the first curve to its other half, with both between. A curve
  // that crosses leaves on one side only; one that touches does so twice, near the one half and near the other.
  enum class Kind : std::uint8_t { near_start, crossing, near_end };
  const auto comes_before = [&](int reference_way) {
    return [&, reference_way](const End& b, const End& c) {
      const auto kind = [&](const End& e) {
        const bool has_start = side_of(e, first, reference_way) > 0;
        const bool has_end = side_of(e, first, -reference_way) > 0;
        return !has_end ? Kind::near_start : has_start ? Kind::near_end : Kind::crossing;
      };
      const Kind of_b = kind(b), of_c = kind(c);
      if (curve_of(b) == curve_of(c)) return of_b < of_c;
      if (of_b != Kind::crossing && of_c == Kind::crossing) return side_of(c, b, b.way) < 0;
      if (of_b != of_c && of_b != Kind::crossing) return of_b < of_c;
      return side_of(b, c, c.way) > 0;
    };
  };
  std::sort(left.begin(), left.end(), comes_before(first.way));
  std::sort(right.begin(), right.end(), comes_before(-first.way));
  result.insert(result.end(), left.begin(), left.end());
  if (opposite) result.push_back(*opposite);
  result.insert(result.end(), right.begin(), right.end());
  return result;
}

void CurveMap::make_cells() {
  std::vector<std::vector<End>> ends(nodes_.size());
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    ends[pieces_[p].start].push_back({p, 1});
    ends[pieces_[p].end].push_back({p, -1});
  }
  std::vector<PieceUse> next(2 * pieces_.size());
  const auto leaving = [](const End& e) -> PieceUse { return 2 * e.piece + (e.way > 0 ? 0 : 1); };
  for (std::vector<End>& around : ends) {
    if (around.empty()) continue;
    around = ordered(std::move(around));
    for (std::size_t k = 0; k < around.size(); ++k) {
      next[leaving(around[k]) ^ 1U] = leaving(around[(k + around.size() - 1) % around.size()]);
    }
  }
  const auto is_outside = [&](PieceUse use) {
    const Piece& p = pieces_[use / 2];
    return p.side != nowhere && !sides_[p.side].is_inside && (use % 2 == 0) != p.runs_as_side;
  };
  std::vector<bool> done(next.size(), false);
  for (PieceUse first = 0; first < next.size(); ++first) {
    Cell cell;
    for (PieceUse use = first; !done[use]; use = next[use]) {
      done[use] = true;
      cell.push_back(use);
    }
    if (!cell.empty() && !is_outside(cell.front())) cells_.push_back(std::move(cell));
  }
}

namespace {

/// True if the form has no zero at p + s d for 0 < s <= 1.
bool has_no_zero(const std::array<Rational, 3>& form) {
  const auto& [a, b, c] = form;
  if (a == 0) {
    const int at_start = b.sign(), at_end = Rational(b + c).sign();
    return at_start == 0 ? c != 0 : at_start == at_end;
  }
  // Bernstein coefficients.
  const int sign = a.sign();
  return Rational(a + b / 2).sign() == sign && Rational(a + b + c).sign() == sign;
}

/// The same where intervals tell that it has none.
bool certainly_has_no_zero(const std::array<Interval, 3>& form) {
  const auto& [a, b, c] = form;
  const Interval middle = a + b / Interval(2), end = a + b + c;
  return (a.inf() > 0 && middle.inf() > 0 && end.inf() > 0) || (a.sup() < 0 && middle.sup() < 0 && end.sup() < 0);
}

}  // namespace

/// True if no curve is met on the way from a point, but where it starts.
bool CurveMap::is_clear(const FlatPoint& start, const FlatPoint& way) const {
  const CGAL::Protect_FPU_rounding<true> upward;
  const NearPoint p{enclosure(start.x), enclosure(start.y)}, d{enclosure(way.x), enclosure(way.y)};
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    if (certainly_has_no_zero(form_on_line(near_[c], p, d))) continue;
    if (!has_no_zero(form_on_line(curves_[c], start, way))) return false;
  }
  return true;
}

FlatPoint CurveMap::inner_point(std::size_t cell) const {
  // From the middle of a side rather than of an arc: its numbers are shorter.
  const auto& uses = cells_[cell];
  const auto on_side =
      std::find_if(uses.begin(), uses.end(), [&](PieceUse u) { return pieces_[u / 2].side != nowhere; });
  const PieceUse use = on_side == uses.end() ? uses.front() : *on_side;
  const Piece& piece = pieces_[use / 2];
  const FlatCurve& curve = curves_[piece.curve];
  RealRoot from = piece.from, to = piece.to;
  const Rational t = number_between(from, to);
  const FlatPoint start = *curve.at(t), along = direction(curve, t);
  const Rational size = Rational(std::max(Rational(abs(along.x)), Rational(abs(along.y)))) * (use % 2 == 0 ? 1 : -1);
  const Rational x(nearest_double(Rational(along.x / size))), y(nearest_double(Rational(along.y / size)));
  Rational length = 0;
  for (const Side& s : sides_) {
    length = std::max({length, Rational(abs(s.from.x - start.x)), Rational(abs(s.from.y - start.y))});
  }
  length = Rational(nearest_double(length));
  // Roughly across, to the left, at another slant each time: along a line through the start no way is clear.
  FlatPoint way;
  for (int trial = 0;; ++trial, length /= 2) {
    const Rational slant(trial % 8, 16);
    way = {Rational(length * (slant * x - y)), Rational(length * (x + slant * y))};
    if (is_clear(start, way)) break;
  }
  const FlatPoint inside{Rational(start.x + way.x / 2), Rational(start.y + way.y / 2)};
  // A point of doubles, if the way there is clear, too.
  const FlatPoint rounded{Rational(nearest_double(inside.x)), Rational(nearest_double(inside.y))};
  return is_clear(inside, {Rational(rounded.x - inside.x), Rational(rounded.y - inside.y)}) ? rounded : inside;
}

}  // namespace gnomon::conic
