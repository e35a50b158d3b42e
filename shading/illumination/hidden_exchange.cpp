#include "shading/illumination/hidden_exchange.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "shading/vector.h"

namespace gnomon::illumination {
namespace {

using shading::Bounded;
using shading::Vector;

/// Just inside of 0 and 1.
constexpr double just_inside = 0x1p-20;

/// Nodes and weights on [0, 1], and what the values at the nodes make just inside, in the middle and just inside of the
/// other end by interpolation.
struct Rule {
  std::vector<double> node;
  std::vector<double> weight;
  std::array<std::vector<double>, 3> near_ends;
};

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

template <unsigned n>
Rule made_rule() {
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

/// Each a good deal better than the one before.
const std::array<Rule, 4>& rules() {
  static const std::array<Rule, 4> made = {made_rule<4>(), made_rule<7>(), made_rule<10>(), made_rule<15>()};
  return made;
}

using Triangle = std::array<Point3, 3>;

double area_of(const Triangle& t) {
  const Vector c = cross(step(t[0], t[1]), step(t[0], t[2]));
  return shading::length(c) / 2;
}

/// The integral of irradiance over triangles of a receiver.
class TriangleIntegral {
 public:
  TriangleIntegral(const RestingPiece& receiver, LightIrradiance& irradiance, const HiddenEffort& effort)
      : receiver_{{}, facet_front(receiver.polygon), receiver.under}, irradiance_(irradiance), effort_(effort) {
    const auto& [a, b, c] = std::get<FacetFront>(receiver_.front).corners;
    const Vector n = cross(step(a, b), step(a, c));
    normal_ = {n.x, n.y, n.z};
  }

  /// The triangles together may be off by the tolerance, each by its share of the area.
  void add(const std::vector<Triangle>& triangles) {
    double area = 0;
    for (const Triangle& t : triangles) area += area_of(t);
    if (area == 0) return;
    tolerance_per_area_ = effort_.tolerance * std::numbers::pi / area;
    for (const Triangle& t : triangles) add(t, triangles.size());
  }

  /// Divided by pi.
  Bounded value() const { return Bounded(sum_, error_ + 1e-15 * std::fabs(sum_)) / shading::pi(Bounded()); }
  std::size_t evaluations() const { return evaluations_; }

 private:
  /// Halves what no rule does, nearest to its largest error first: worst cases are beside contacts and long arcs.
  void add(const Triangle& whole, std::size_t of) {
    std::vector<Triangle> waiting = {whole};
    const std::size_t most = evaluations_ + std::max<std::size_t>(effort_.most_evaluations / of, 400);
    while (!waiting.empty()) {
      const Triangle t = waiting.back();
      waiting.pop_back();
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

  struct Result {
    double value = 0;
    double off = HUGE_VAL;  ///< estimated error of the rule
    double bound = 0;       ///< sum of the errors at its nodes
  };

  /// The error of the second rule is estimated by its difference from the first. Rules of n nodes err about as q^n, so
  /// the last two differences tell q each; the larger one makes the estimate from then on, sixteen times for safety.
  /// What is missed at the corners counts, too.
  Result integral(const Triangle& t, double tolerance) {
    Result last;
    double step = HUGE_VAL;
    for (std::size_t k = 0; k < rules().size(); ++k) {
      Result next = by_rule(t, rules()[k]);
      if (k > 0) {
        const double change = std::fabs(next.value - last.value), scale = std::fabs(next.value) + change;
        next.off =
            k == 1 ? change : 16 * std::max(error_after(k, k - 2, step, scale), error_after(k, k - 1, change, scale));
        if (next.off <= tolerance) next.off = std::max(next.off, missed_by(t, rules()[k], next.value));
        step = change;
      }
      last = next;
      if (last.off <= tolerance) break;
    }
    return last;
  }

  /// The error of a rule if that of an earlier one is known.
  static double error_after(std::size_t rule, std::size_t earlier, double error, double scale) {
    const auto n = [](std::size_t k) { return static_cast<double>(rules()[k].node.size()); };
    return scale > 0 ? scale * std::pow(std::min(1.0, error / scale), n(rule) / n(earlier)) : 0;
  }

  /// In coordinates that shrink to a point at the first corner (Duffy).
  Irradiance at(const Triangle& t, double r, double q) {
    const double b = r * (1 - q), c = r * q;
    const auto along = [&](double Point3::*x) { return t[0].*x + b * (t[1].*x - t[0].*x) + c * (t[2].*x - t[0].*x); };
    ++evaluations_;
    receiver_.point = {along(&Point3::x), along(&Point3::y), along(&Point3::z)};
    return irradiance_.received(receiver_, normal_);
  }

  Result by_rule(const Triangle& t, const Rule& rule) {
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
  double missed_by(const Triangle& t, const Rule& rule, double value) {
    struct Corner {
      double r, q;
      const std::vector<double>&along_r, &along_q;
    };
    const auto& [low, middle, high] = rule.near_ends;
    const std::size_t n = rule.node.size();
    double missed = 0;
    for (const Corner& c : {Corner{just_inside, .5, low, middle}, Corner{1 - just_inside, just_inside, high, low},
                            Corner{1 - just_inside, 1 - just_inside, high, high}}) {
      double sum = 0;
      for (std::size_t k = 0; k < values_.size(); ++k) sum += c.along_r[k / n] * c.along_q[k % n] * values_[k];
      missed = std::max(missed, std::fabs(sum - at(t, c.r, c.q).value));
    }
    const double area = area_of(t);
    return missed == 0 ? 0 : area * missed * missed / std::max(value / area, 0x1p-40 * missed);
  }

  /// Of the longest side, the corner across it first in both.
  static std::array<Triangle, 2> halves(const Triangle& t) {
    std::size_t longest = 0;
    const auto squared = [&](std::size_t k) {
      const Vector side = step(t[k], t[(k + 1) % 3]);
      return dot(side, side);
    };
    for (std::size_t k = 1; k < 3; ++k) longest = squared(k) > squared(longest) ? k : longest;
    const Point3 &a = t[longest], &b = t[(longest + 1) % 3], &across = t[(longest + 2) % 3];
    const Point3 middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    return {Triangle{across, a, middle}, Triangle{across, middle, b}};
  }

  ReceiverPoint receiver_;  ///< at the place that was asked last
  Point3 normal_;
  LightIrradiance& irradiance_;
  HiddenEffort effort_;
  double tolerance_per_area_ = 0;
  double sum_ = 0;
  double error_ = 0;
  std::size_t evaluations_ = 0;
  std::vector<double> values_;  ///< at the nodes of the last rule
};

bool has_arcs(const ReceiverMesh& mesh, const RegionPolygon& region) {
  for (const auto& cycle : region.cycles) {
    for (const MeshEdgeUse use : cycle) {
      if (mesh.edges()[use / 2].arc != MeshEdge::nowhere) return true;
    }
  }
  return false;
}

Loops loops_of(const ReceiverMesh& mesh, const RegionPolygon& region, const std::vector<Point3>& vertices) {
  Loops loops;
  for (const auto& cycle : region.cycles) {
    loops.emplace_back();
    for (const MeshEdgeUse use : cycle) {
      const MeshEdge& edge = mesh.edges()[use / 2];
      loops.back().push_back(vertices[use % 2 == 0 ? edge.source : edge.target]);
    }
  }
  return loops;
}

/// At most what an exchange area changes by when each vertex is rounded: the area passed over, as a factor is at
/// most 1.
double rounding_of(const Loops& loops) {
  double sum = 0;
  for (const auto& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point3 &p = loop[k], &q = loop[(k + 1) % loop.size()];
      sum += sum_norm(step(p, q)) * 0x1p-51 * (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
    }
  }
  return sum;
}

}  // namespace

Exchange hidden_exchange(const ReceiverMesh& mesh, const RestingPiece& receiver, const Loops& light,
                         LightIrradiance& irradiance, const HiddenEffort& effort) {
  Exchange result;
  const std::vector<Point3> vertices = mesh.vertices();
  std::vector<bool> is_done(mesh.faces().size(), false);
  for (const RegionPolygon& region : mesh.regions()) {
    if (region.region != ReceiverRegion::lit || has_arcs(mesh, region)) continue;
    for (const std::uint32_t face : region.faces) is_done[face] = true;
    const Loops loops = loops_of(mesh, region, vertices);
    result.area = result.area + widened(exchange_area(loops, light), rounding_of(loops));
  }
  const MeshDrawing drawing = mesh.drawing();
  std::vector<Triangle> triangles;
  for (const ReceiverTriangle& t : drawing.triangles) {
    const ReceiverRegion region = mesh.faces()[t.face].region;
    const bool is_dark = region == ReceiverRegion::umbra || region == ReceiverRegion::unlit;
    if (is_done[t.face] || (is_dark && !t.is_at_arc)) continue;
    const auto& [a, b, c] = t.vertices;
    triangles.push_back({drawing.points[a], drawing.points[b], drawing.points[c]});
  }
  if (triangles.empty()) return result;
  TriangleIntegral integral(receiver, irradiance, effort);
  integral.add(triangles);
  result.area = result.area + integral.value();
  result.is_proven = false;
  result.evaluations = integral.evaluations();
  return result;
}

}  // namespace gnomon::illumination
