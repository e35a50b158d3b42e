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

}  // namespace gnomon::conic
