#include "geometry/conics/curve_map.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <set>
#include <tuple>
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

/// The own parameter of a conic at the point of another of its parameters; nothing where it is infinite.
std::optional<Rational> CurveMap::parameter_on(const FlatCurve& own, const FlatCurve& other, const Rational& at) {
  for (const LinePencil& parameter : own.parameters) {
    const auto [top, bottom] = parameter_along(parameter, other);
    const Integer t = homogeneous_value(top, at, 2), b = homogeneous_value(bottom, at, 2);
    if (b != 0) return Rational(t, b);
    if (t != 0) return std::nullopt;
    // The point about which these lines turn.
  }
  return std::nullopt;
}

/// The range of a curve's own parameter on which an arc of it lies that came with another one; nothing if it passes
/// infinity.
std::optional<Range> CurveMap::range_on(const FlatCurve& own, const FlatArc& arc) {
  if (own.is_straight) return Range{arc.from, arc.to};
  const auto from = parameter_on(own, arc.curve, arc.from), to = parameter_on(own, arc.curve, arc.to);
  if (!from || !to) return std::nullopt;
  for (const LinePencil& parameter : own.parameters) {
    auto [top, bottom] = parameter_along(parameter, arc.curve);
    const Polynomial t(std::move(top)), b(std::move(bottom));
    if (b.is_zero()) continue;
    // On one conic the two parameters are quotients of linear functions of each other.
    const Polynomial common = greatest_common_divisor(t, b);
    const Polynomial left = common.degree() > 0 ? quotient(b, common) : b;
    if (!real_roots(left, arc.from, arc.to).empty()) return std::nullopt;
    return *from < *to ? Range{*from, *to} : Range{*to, *from};
  }
  return std::nullopt;
}

/// Of an arc that passes infinity on the curve's parameter: gives the curve another one that is finite on all its
/// arcs. Nothing if these cover all of the conic.
std::optional<Range> CurveMap::range_after_moving_pole(std::uint32_t curve, const FlatArc& arc) {
  std::vector<Rational> ends{Rational(-1), Rational(0), Rational(1), Rational(2)};
  for (const Stretch& s : stretches_[curve]) ends.insert(ends.end(), {s.from, s.to});
  for (const Rational& t : {arc.from, arc.to}) {
    if (const auto there = parameter_on(curves_[curve], arc.curve, t)) ends.push_back(*there);
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    if (ends[k] == ends[k + 1]) continue;
    const Rational pole = (ends[k] + ends[k + 1]) / 2;
    const auto holds_pole = [&](const Stretch& s) { return s.from <= pole && pole <= s.to; };
    if (pole == 0 || pole == 1 || std::ranges::any_of(stretches_[curve], holds_pole)) continue;
    const FlatCurve other = with_pole(curves_[curve], pole);
    const std::optional<Range> range = range_on(other, arc);
    if (!range) continue;
    for (Stretch& s : stretches_[curve]) {
      const auto moved = [&](const Rational& t) -> Rational { return (pole - 1) * t / (pole - t); };
      std::tie(s.from, s.to) = std::minmax(Rational(moved(s.from)), Rational(moved(s.to)));
    }
    const CGAL::Protect_FPU_rounding<true> upward;
    curves_[curve] = other;
    near_[curve] = NearCurve(other);
    return range;
  }
  return std::nullopt;
}

void CurveMap::add_arc(const NamedArc& named) {
  if (named.arc.from == named.arc.to) return;
  const std::uint32_t c = curve_like(named.arc.curve);
  Range range{named.arc.from, named.arc.to};
  if (curves_[c].point != named.arc.curve.point) {
    auto found = range_on(curves_[c], named.arc);
    if (!found) found = range_after_moving_pole(c, named.arc);
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
