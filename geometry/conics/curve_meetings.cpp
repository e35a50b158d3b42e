#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <utility>

#include "geometry/conics/curve_map.h"
#include "geometry/numbers/rounding.h"

// Where the curves of a map meet: breaks, at roots on both of their parameters.

namespace gnomon::conic {
namespace {

/// The sign of numerator / denominator - x at a root, given the sign of the denominator there.
int compare_at(const ParameterAlong& s, const Rational& x, RealRoot& root, int denominator_sign) {
  const Polynomial difference(denominator(x) * s.numerator - Integer(numerator(x)) * s.denominator);
  return sign_at(difference, root) * denominator_sign;
}

}  // namespace

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

}  // namespace gnomon::conic
