#include "geometry/conics/curve_map.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <set>
#include <utility>

#include "geometry/numbers/rounding.h"

namespace gnomon::conic {
namespace {

/// A form that is the same for the same curve.
std::vector<Integer> normal_form(const FlatCurve& curve) {
  std::vector<Integer> form(curve.form.begin(), curve.form.end());
  Integer common = 0;
  for (const Integer& c : form) common = gcd(common, c);
  const auto first = std::find_if(form.begin(), form.end(), [](const Integer& c) { return c != 0; });
  if (*first < 0) common = -common;
  for (Integer& c : form) c /= common;
  return form;
}

bool is_by_x(const FlatCurve& straight) {
  return straight.parameters.front().start[1] != 0;
}

const Rational& coordinate_on(const FlatCurve& straight, const FlatPoint& p) {
  return is_by_x(straight) ? p.x : p.y;
}

/// The parameter of a curve as a quotient of polynomials in that of another that it meets.
struct ParameterAlong {
  Coefficients numerator;
  Coefficients denominator;
};

ParameterAlong parameter_along(const LinePencil& parameter, const FlatCurve& other) {
  const Coefficients start = along(parameter.start, other);
  return {start, start - along(parameter.end, other)};
}

/// The sign of numerator / denominator - x at a root, given the sign of the denominator there.
int compare_at(const ParameterAlong& s, const Rational& x, RealRoot& root, int denominator_sign) {
  const Polynomial difference(denominator(x) * s.numerator - Integer(numerator(x)) * s.denominator);
  return sign_at(difference, root) * denominator_sign;
}

}  // namespace

CurveMap::CurveMap(std::span<const Side> sides, std::span<const NamedArc> arcs) : sides_(sides.begin(), sides.end()) {
  std::uint32_t vertices = 0;
  for (const Side& s : sides_) vertices = std::max({vertices, s.from_vertex + 1, s.to_vertex + 1});
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    for (const Side& s : sides_) {
      near_vertices_.push_back({enclosure(s.from.x), enclosure(s.from.y)});
      near_vertices_.push_back({enclosure(s.to.x), enclosure(s.to.y)});
    }
  }
  for (std::uint32_t k = 0; k < sides_.size(); ++k) add_side(sides_[k], k);
  for (const NamedArc& arc : arcs) add_arc(arc);
  if (!is_complete_) return;
  do {
    nodes_.clear();
    pieces_.clear();
    for (std::uint32_t v = 0; v < vertices; ++v) nodes_.push_back({v, nowhere, {}});
    find_breaks();
    unite_equal_breaks();
    make_pieces();
    drop_loose_ends();
  } while (add_cuts());
  make_cells();
}

std::uint32_t CurveMap::curve_like(const FlatCurve& curve) {
  const auto [found, is_new] =
      curve_of_form_.try_emplace(normal_form(curve), static_cast<std::uint32_t>(curves_.size()));
  if (is_new) {
    const CGAL::Protect_FPU_rounding<true> upward;
    curves_.push_back(curve);
    near_.emplace_back(curve);
    stretches_.emplace_back();
  }
  return found->second;
}

void CurveMap::add_side(const Side& side, std::uint32_t index) {
  const std::uint32_t c = curve_like(straight_curve(line_through(side.from, side.to)));
  Rational from = coordinate_on(curves_[c], side.from), to = coordinate_on(curves_[c], side.to);
  const bool runs_as_side = from < to;
  if (!runs_as_side) std::swap(from, to);
  stretches_[c].push_back({std::move(from), std::move(to), index, runs_as_side, std::nullopt});
}

/// The range of a curve's own parameter on which an arc of it lies that came with another one; nothing if it passes
/// infinity.
std::optional<Range> CurveMap::range_on(std::uint32_t curve, const FlatArc& arc) const {
  const FlatCurve& own = curves_[curve];
  if (own.is_straight) return Range{arc.from, arc.to};
  for (const LinePencil& parameter : own.parameters) {
    auto [top, bottom] = parameter_along(parameter, arc.curve);
    const Polynomial t(std::move(top)), b(std::move(bottom));
    if (b.is_zero()) continue;
    // On one conic the two parameters are quotients of linear functions of each other.
    const Polynomial common = greatest_common_divisor(t, b);
    const Polynomial left = common.degree() > 0 ? quotient(b, common) : b;
    if (!real_roots(left, arc.from, arc.to).empty()) return std::nullopt;
    const auto value = [&](const Rational& at) -> std::optional<Rational> {
      const auto p = arc.curve.at(at);
      if (!p) return std::nullopt;
      const auto at_p = [&](const Covector& c) -> Rational {
        return Rational(c[0]) + Rational(c[1]) * p->x + Rational(c[2]) * p->y;
      };
      const Rational start = at_p(parameter.start), way = start - at_p(parameter.end);
      if (way == 0) return std::nullopt;
      return Rational(start / way);
    };
    const auto from = value(arc.from), to = value(arc.to);
    if (!from || !to) continue;
    return *from < *to ? Range{*from, *to} : Range{*to, *from};
  }
  return std::nullopt;
}

void CurveMap::add_arc(const NamedArc& named) {
  if (named.arc.from == named.arc.to) return;
  const std::uint32_t c = curve_like(named.arc.curve);
  Range range{named.arc.from, named.arc.to};
  if (curves_[c].point != named.arc.curve.point) {
    const auto found = range_on(c, named.arc);
    if (!found) {
      is_complete_ = false;
      return;
    }
    range = *found;
  }
  stretches_[c].push_back({range.from, range.to, nowhere, true, named.name});
}

std::uint32_t CurveMap::new_node() {
  nodes_.push_back({});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void CurveMap::find_breaks() {
  breaks_.assign(curves_.size(), {});
  for (std::uint32_t c = 0; c < curves_.size(); ++c) {
    for (const Stretch& s : stretches_[c]) {
      std::uint32_t from = 0, to = 0;
      if (s.side != nowhere) {
        const Side& side = sides_[s.side];
        from = s.runs_as_side ? side.from_vertex : side.to_vertex;
        to = s.runs_as_side ? side.to_vertex : side.from_vertex;
      } else {
        from = new_node();
        to = new_node();
      }
      breaks_[c].push_back({rational_root(s.from), from});
      breaks_[c].push_back({rational_root(s.to), to});
    }
  }
  const auto is_of_sides = [&](std::uint32_t c) {
    return std::all_of(stretches_[c].begin(), stretches_[c].end(), [](const Stretch& s) { return s.side != nowhere; });
  };
  for (std::uint32_t a = 0; a < curves_.size(); ++a) {
    for (std::uint32_t b = a + 1; b < curves_.size(); ++b) {
      if (!is_of_sides(a) || !is_of_sides(b)) find_meetings(a, b);
    }
  }
}

bool CurveMap::is_on_stretch(std::uint32_t curve, RealRoot& root) const {
  return std::any_of(stretches_[curve].begin(), stretches_[curve].end(),
                     [&](const Stretch& s) { return compare(root, s.from) >= 0 && compare(root, s.to) <= 0; });
}

Range CurveMap::hull(std::uint32_t curve) const {
  Range all{stretches_[curve].front().from, stretches_[curve].front().to};
  for (const Stretch& s : stretches_[curve]) all = {std::min(all.from, s.from), std::max(all.to, s.to)};
  return all;
}

/// False only if intervals tell that some stretches of the one curve lie off the other.
bool CurveMap::may_meet(std::uint32_t a, std::uint32_t b) const {
  const CGAL::Protect_FPU_rounding<true> upward;
  return std::any_of(stretches_[a].begin(), stretches_[a].end(), [&](const Stretch& s) {
    return !certainly_avoids(near_[b], near_[a], enclosure(s.from), enclosure(s.to));
  });
}

void CurveMap::find_meetings(std::uint32_t a, std::uint32_t b) {
  if (!may_meet(a, b) || !may_meet(b, a)) return;
  const auto roots_on = [&](std::uint32_t c, std::uint32_t other) {
    const Range range = hull(c);
    return real_roots(form_along(curves_[other], curves_[c]), range.from, range.to);
  };
  std::vector<RealRoot> on_a = roots_on(a, b);
  std::erase_if(on_a, [&](RealRoot& root) { return !is_on_stretch(a, root); });
  if (on_a.empty()) return;
  std::vector<RealRoot> on_b = roots_on(b, a);
  if (on_b.empty()) return;
  const Range range = hull(b);
  for (RealRoot& root : on_a) {
    for (const LinePencil& parameter : curves_[b].parameters) {
      const ParameterAlong s = parameter_along(parameter, curves_[a]);
      const int below = sign_at(Polynomial(s.denominator), root);
      if (below == 0) continue;
      if (compare_at(s, range.from, root, below) < 0 || compare_at(s, range.to, root, below) > 0) break;
      std::size_t k = 0;
      while (k + 1 < on_b.size() && compare_at(s, number_between(on_b[k], on_b[k + 1]), root, below) > 0) ++k;
      if (!is_on_stretch(b, on_b[k])) break;
      const std::uint32_t node = new_node();
      breaks_[a].push_back({root, node});
      breaks_[b].push_back({on_b[k], node});
      break;
    }
  }
}

/// Sorts the breaks of each curve, and makes one node of those that are met at one place.
void CurveMap::unite_equal_breaks() {
  boost::disjoint_sets_with_storage<> sets(nodes_.size());
  for (std::vector<Break>& breaks : breaks_) {
    std::vector<Break> sorted;
    for (Break& added : breaks) {
      std::size_t place = sorted.size();
      bool is_known = false;
      while (place > 0 && !is_known) {
        const int order = compare(added.root, sorted[place - 1].root);
        if (order > 0) break;
        is_known = order == 0;
        if (!is_known) --place;
      }
      if (is_known) {
        sets.union_set(added.node, sorted[place - 1].node);
        if (added.root.is_rational()) sorted[place - 1].root = added.root;
      } else {
        sorted.insert(sorted.begin() + static_cast<std::ptrdiff_t>(place), std::move(added));
      }
    }
    breaks = std::move(sorted);
  }
  // The polygon's vertices keep their numbers: no two of them are one.
  std::vector<std::uint32_t> name(nodes_.size(), nowhere);
  std::vector<Node> nodes;
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    std::uint32_t& of_set = name[sets.find_set(n)];
    if (of_set == nowhere) {
      of_set = static_cast<std::uint32_t>(nodes.size());
      nodes.push_back(nodes_[n]);
    }
  }
  for (std::uint32_t c = 0; c < breaks_.size(); ++c) {
    for (Break& b : breaks_[c]) {
      b.node = name[sets.find_set(b.node)];
      Node& node = nodes[b.node];
      if (node.vertex != nowhere || (node.curve != nowhere && node.root.is_rational())) continue;
      node.curve = c;
      node.root = b.root;
    }
  }
  nodes_ = std::move(nodes);
}

void CurveMap::make_pieces() {
  for (std::uint32_t c = 0; c < curves_.size(); ++c) make_pieces_of(c);
}

void CurveMap::make_pieces_of(std::uint32_t c) {
  std::vector<Break>& breaks = breaks_[c];
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const Rational middle = number_between(breaks[k].root, breaks[k + 1].root);
    Piece piece{c, breaks[k].root, breaks[k + 1].root, breaks[k].node, breaks[k + 1].node, nowhere, true, {}};
    bool is_covered = false;
    for (const Stretch& s : stretches_[c]) {
      if (middle < s.from || middle > s.to) continue;
      is_covered = true;
      if (s.side != nowhere) {
        piece.side = s.side;
        piece.runs_as_side = s.runs_as_side;
      } else if (s.name) {
        piece.names.push_back(*s.name);
      }
    }
    if (!is_covered) continue;
    if (piece.side == nowhere) {
      const auto point = curves_[c].at(middle);
      if (!point || !is_in_polygon(*point)) continue;
    }
    std::sort(piece.names.begin(), piece.names.end());
    piece.names.erase(std::unique(piece.names.begin(), piece.names.end()), piece.names.end());
    pieces_.push_back(std::move(piece));
  }
}

/// The same as below, where intervals tell.
std::optional<bool> CurveMap::is_certainly_in_polygon(const FlatPoint& p) const {
  const CGAL::Protect_FPU_rounding<true> upward;
  const Interval x = enclosure(p.x), y = enclosure(p.y);
  bool is_inside = false;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    if (sides_[k].is_inside) continue;
    const NearPoint &from = near_vertices_[2 * k], &to = near_vertices_[2 * k + 1];
    const Interval at_from = from.y - y, at_to = to.y - y;
    if ((at_from.inf() <= 0 && at_from.sup() >= 0) || (at_to.inf() <= 0 && at_to.sup() >= 0)) return std::nullopt;
    if ((at_from.inf() > 0) == (at_to.inf() > 0)) continue;
    const Interval turn = (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
    if (turn.inf() <= 0 && turn.sup() >= 0) return std::nullopt;
    if ((turn.inf() > 0) == (at_to.inf() > 0)) is_inside = !is_inside;
  }
  return is_inside;
}

/// By the sides that a ray along x crosses. Requires: a point on none of them.
bool CurveMap::is_in_polygon(const FlatPoint& p) const {
  if (const auto known = is_certainly_in_polygon(p)) return *known;
  bool is_inside = false;
  for (const Side& s : sides_) {
    if (s.is_inside || (s.from.y > p.y) == (s.to.y > p.y)) continue;
    const Rational turn = (s.to.x - s.from.x) * (p.y - s.from.y) - (s.to.y - s.from.y) * (p.x - s.from.x);
    if ((turn > 0) == (s.to.y > s.from.y)) is_inside = !is_inside;
  }
  return is_inside;
}

void CurveMap::drop_loose_ends() {
  while (true) {
    std::vector<std::uint32_t> ends(nodes_.size(), 0);
    for (const Piece& p : pieces_) ++ends[p.start], ++ends[p.end];
    const auto is_loose = [&](const Piece& p) { return p.side == nowhere && (ends[p.start] < 2 || ends[p.end] < 2); };
    if (std::erase_if(pieces_, is_loose) == 0) return;
  }
}

/// Joins what is apart from the outer boundary by straight cuts along x, towards it. Returns: false if nothing was
/// apart.
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
