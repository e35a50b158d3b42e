#include "shading/illumination/triangle_integral.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "shading/vector.h"

namespace gnomon::illumination {
namespace {

using shading::Bounded;
using shading::Vector;

/// Just inside of 0 and 1.
constexpr double just_inside = 0x1p-20;

/// Lagrange's polynomials of the nodes at x.
std::vector<double> interpolation(const std::vector<double>& node, double x) {
  std::vector<double> share(node.size(), 1.0);
  for (std::size_t i = 0; i < node.size(); ++i) {
    for (std::size_t j = 0; j < node.size(); ++j) {
      if (j != i) share[i] *= (x - node[j]) / (node[i] - node[j]);
    }
  }
  return share;
}

double area_of(const Triangle& t) {
  const Vector c = cross(step(t[0], t[1]), step(t[0], t[2]));
  return shading::length(c) / 2;
}

/// Up to rounding: a piece of a triangle around a place beside it is as small as what is rounded.
bool is_in(const Triangle& t, const Point3& p) {
  const Vector n = cross(step(t[0], t[1]), step(t[0], t[2]));
  for (std::size_t k = 0; k < 3; ++k) {
    if (dot(cross(step(t[k], t[(k + 1) % 3]), step(t[k], p)), n) < -0x1p-40 * dot(n, n)) return false;
  }
  return true;
}

Point3 middle(const Point3& a, const Point3& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
}

}  // namespace

/// Nodes and weights on [0, 1], and what the values at the nodes make just inside, in the middle and just inside of the
/// other end by interpolation.
struct TriangleIntegral::Rule {
  std::vector<double> node;
  std::vector<double> weight;
  std::array<std::vector<double>, 3> near_ends;

  template <unsigned n>
  static Rule of() {
    using Gauss = boost::math::quadrature::gauss<double, n>;
    Rule rule;
    for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
      const double x = Gauss::abscissa()[k], w = Gauss::weights()[k] / 2;
      for (const double side : {-1.0, 1.0}) {
        if (x == 0 && side > 0) continue;
        rule.node.push_back(0.5 + side * x / 2);
        rule.weight.push_back(w);
      }
    }
    rule.near_ends = {interpolation(rule.node, just_inside), interpolation(rule.node, .5),
                      interpolation(rule.node, 1 - just_inside)};
    return rule;
  }
};

/// Each a good deal better than the one before.
const std::array<TriangleIntegral::Rule, 4>& TriangleIntegral::rules() {
  static const std::array<Rule, 4> made = {Rule::of<4>(), Rule::of<7>(), Rule::of<10>(), Rule::of<15>()};
  return made;
}

TriangleIntegral::TriangleIntegral(const RestingPiece& receiver, LightIrradiance& irradiance,
                                   const HiddenEffort& effort)
    : receiver_{{}, facet_front(receiver.polygon), receiver.under}, irradiance_(irradiance), effort_(effort) {
  const auto& [a, b, c] = std::get<FacetFront>(receiver_.front).corners;
  const Vector n = cross(step(a, b), step(a, c));
  normal_ = {n.x, n.y, n.z};
  for (const Point3& p : receiver.many_limits) many_limits_.try_emplace(place_key(p), p);
}

void TriangleIntegral::add(const std::vector<Triangle>& triangles) {
  double area = 0;
  for (const Triangle& t : triangles) area += area_of(t);
  if (area == 0) return;
  tolerance_per_area_ = effort_.tolerance * std::numbers::pi / area;
  for (const Triangle& t : triangles) add(t, triangles.size());
}

Bounded TriangleIntegral::value() const {
  return Bounded(sum_, error_ + 1e-15 * std::fabs(sum_)) / shading::pi(Bounded());
}

/// Halves what no rule does, nearest to its largest error first: worst cases are beside contacts and long arcs.
void TriangleIntegral::add(const Triangle& whole, std::size_t of) {
  std::vector<Triangle> waiting = with_limits_apart(whole);
  const std::size_t most = evaluations_ + std::max<std::size_t>(effort_.most_evaluations / of, 400);
  while (!waiting.empty()) {
    const Triangle t = waiting.back();
    waiting.pop_back();
    if (area_of(t) <= 0x1p-40 * area_of(whole)) {
      // What rounding alone makes of a place on an edge. Irradiance of radiance 1 is at most pi.
      error_ += std::numbers::pi * area_of(t);
      continue;
    }
    const double tolerance = tolerance_per_area_ * area_of(t);
    const Result result = integral(t, tolerance);
    if (result.off <= tolerance || evaluations_ >= most) {
      sum_ += result.value;
      // Two rules may agree by chance: an estimate is not believed to be far better than what was asked for.
      error_ += std::max(result.off, tolerance / 50) + result.bound;
      continue;
    }
    const auto [first, second] = halves(t);
    waiting.push_back(second);
    waiting.push_back(first);
  }
}

/// Rules take the first corner for a point that has a limit in each direction. Pieces without another such point.
std::vector<Triangle> TriangleIntegral::with_limits_apart(const Triangle& whole) const {
  for (const auto& [key, p] : many_limits_) {
    if (std::ranges::count(whole, p) != 0 || !is_in(whole, p)) continue;
    std::vector<Triangle> pieces;
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle part{p, whole[k], whole[(k + 1) % 3]};
      if (area_of(part) == 0) continue;
      const std::vector<Triangle> more = with_limits_apart(part);
      pieces.insert(pieces.end(), more.begin(), more.end());
    }
    return pieces;
  }
  const auto count = std::ranges::count_if(whole, [&](const Point3& p) { return has_many_limits(p); });
  if (count < 2) return {with_limits_first(whole)};
  const auto& [a, b, c] = whole;
  const Point3 ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
  return {{ab, bc, ca}, {a, ab, ca}, {b, bc, ab}, {c, ca, bc}};
}

Triangle TriangleIntegral::with_limits_first(const Triangle& t) const {
  if (has_many_limits(t[1])) return {t[1], t[2], t[0]};
  if (has_many_limits(t[2])) return {t[2], t[0], t[1]};
  return t;
}

/// Of the longest side; the corner across it is first in both, but where another has many limits.
std::array<Triangle, 2> TriangleIntegral::halves(const Triangle& t) const {
  std::size_t longest = 0;
  const auto squared = [&](std::size_t k) {
    const Vector side = step(t[k], t[(k + 1) % 3]);
    return dot(side, side);
  };
  for (std::size_t k = 1; k < 3; ++k) longest = squared(k) > squared(longest) ? k : longest;
  const Point3 &a = t[longest], &b = t[(longest + 1) % 3], &across = t[(longest + 2) % 3];
  const Point3 m = middle(a, b);
  return {with_limits_first({across, a, m}), with_limits_first({across, m, b})};
}

/// The error of the second rule is estimated by its difference from the first. Rules of n nodes err about as q^n, so
/// the last two differences tell q each; the larger one makes the estimate from then on, sixteen times for safety.
/// What is missed at the corners counts, too.
TriangleIntegral::Result TriangleIntegral::integral(const Triangle& t, double tolerance) {
  Result last;
  double step = HUGE_VAL;
  for (std::size_t k = 0; k < rules().size(); ++k) {
    Result next = by_rule(t, rules()[k]);
    if (k > 0) {
      const double change = std::fabs(next.value - last.value), scale = std::fabs(next.value) + change;
      next.off =
          k == 1 ? change : 16 * std::max(error_after(k, k - 2, step, scale), error_after(k, k - 1, change, scale));
      // Where the last change is not what a power q^n would leave, the change itself is all that is known.
      if (k > 1 && change > error_after(k - 1, k - 2, step, scale)) next.off = std::max(next.off, 8 * change);
      if (next.off <= tolerance) next.off = std::max(next.off, missed_by(t, rules()[k], next.value));
      step = change;
    }
    last = next;
    if (last.off <= tolerance) break;
  }
  return last;
}

/// The error of a rule if that of an earlier one is known.
double TriangleIntegral::error_after(std::size_t rule, std::size_t earlier, double error, double scale) {
  const auto n = [](std::size_t k) { return static_cast<double>(rules()[k].node.size()); };
  return scale > 0 ? scale * std::pow(std::min(1.0, error / scale), n(rule) / n(earlier)) : 0;
}

/// In coordinates that shrink to a point at the first corner (Duffy).
Irradiance TriangleIntegral::at(const Triangle& t, double r, double q) {
  const double b = r * (1 - q), c = r * q;
  const auto along = [&](double Point3::*x) { return t[0].*x + b * (t[1].*x - t[0].*x) + c * (t[2].*x - t[0].*x); };
  ++evaluations_;
  receiver_.point = {along(&Point3::x), along(&Point3::y), along(&Point3::z)};
  return irradiance_.received(receiver_, normal_);
}

TriangleIntegral::Result TriangleIntegral::by_rule(const Triangle& t, const Rule& rule) {
  const double doubled = 2 * area_of(t);
  const std::size_t n = rule.node.size();
  Result result;
  values_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const Irradiance e = at(t, rule.node[i], rule.node[j]);
      const double share = rule.weight[i] * rule.weight[j] * rule.node[i] * doubled;
      values_[i * n + j] = e.value;
      result.value += share * e.value;
      result.bound += share * e.error_bound;
    }
  }
  return result;
}

/// What a peak at a corner that lies between all nodes may add: the polynomial through their values differs from the
/// irradiance there. An interpolation of n nodes errs about as the root of what the rule does, so it is squared.
double TriangleIntegral::missed_by(const Triangle& t, const Rule& rule, double value) {
  struct Corner {
    double r, q;
    const std::vector<double>&along_r, &along_q;
  };
  const auto& [low, half, high] = rule.near_ends;
  const std::size_t n = rule.node.size();
  double missed = 0;
  for (const Corner& c : {Corner{just_inside, .5, low, half}, Corner{1 - just_inside, just_inside, high, low},
                          Corner{1 - just_inside, 1 - just_inside, high, high}}) {
    double sum = 0;
    for (std::size_t k = 0; k < values_.size(); ++k) sum += c.along_r[k / n] * c.along_q[k % n] * values_[k];
    missed = std::max(missed, std::fabs(sum - at(t, c.r, c.q).value));
  }
  const double area = area_of(t);
  return missed == 0 ? 0 : area * missed * missed / std::max(value / area, 0x1p-40 * missed);
}

}  // namespace gnomon::illumination
