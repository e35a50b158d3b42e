#include "gnomon/view_factors.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/bodies/closed_surface.h"
#include "geometry/bodies/own_blockers.h"
#include "geometry/parallel.h"
#include "geometry/shared_work.h"
#include "gnomon/errors.h"
#include "gnomon/irradiance.h"
#include "gnomon/receiver_mesh.h"
#include "shading/illumination/hidden_exchange.h"
#include "shading/illumination/standing_between.h"
#include "shading/illumination/surface_pieces.h"
#include "shading/illumination/touching_places.h"

namespace gnomon {
namespace {

using illumination::Exchange;
using illumination::part_before;
using illumination::Piece;
using shading::Bounded;

/// What a piece exchanges with another, worked out on the first.
struct PairExchange {
  std::uint32_t outer = 0;
  std::uint32_t light = 0;
  Exchange exchange;
  bool is_divided = false;
};

/// What is known of each piece before any pair is asked for.
struct PieceFacts {
  std::vector<bool> is_enclosed;
  std::vector<std::vector<std::uint32_t>> own;  ///< the thin solids that it is a facet of: they hide nothing from it
};

/// All that is asked of one piece as a light.
class RowOfLight {
 public:
  RowOfLight(std::span<const Piece> pieces, const Obstacles& obstacles, const illumination::StandingBetween& between,
             const PieceFacts& facts, const ViewFactorEffort& effort)
      : pieces_(pieces), obstacles_(obstacles), between_(between), facts_(facts), effort_(effort) {}

  std::vector<PairExchange> found(std::uint32_t light) {
    std::vector<PairExchange> row;
    std::vector<std::uint32_t> hidden;
    std::set<std::uint32_t> blockers;
    for (std::uint32_t outer = 0; outer < pieces_.size(); ++outer) {
      if (!is_asked(outer, light)) continue;
      const auto before_light = part_before(pieces_[outer].polygon, pieces_[light].polygon);
      const auto before_outer = part_before(pieces_[light].polygon, pieces_[outer].polygon);
      if (before_light.loops.empty() || before_outer.loops.empty()) continue;
      if (facts_.is_enclosed[outer] || facts_.is_enclosed[light]) continue;
      between_.find(pieces_[outer].polygon, pieces_[light].polygon, near_);
      std::erase_if(near_, [&](std::uint32_t b) { return is_own(outer, b) || is_own(light, b); });
      if (near_.empty()) {
        const Bounded area = illumination::exchange_area(before_light.loops, before_outer.loops);
        row.push_back({outer, light, {widened(area, before_light.rounding + before_outer.rounding), true, 0}, false});
      } else {
        hidden.push_back(outer);
        blockers.insert(near_.begin(), near_.end());
      }
    }
    append_hidden(light, hidden, blockers, row);
    return row;
  }

 private:
  /// Of two pieces the smaller one is divided.
  bool is_asked(std::uint32_t outer, std::uint32_t light) const {
    if (outer == light || are_of_one_plate(pieces_[outer], pieces_[light])) return false;
    const std::uint32_t a = pieces_[outer].surface, b = pieces_[light].surface;
    if (effort_.from && a != *effort_.from && (effort_.twice || b != *effort_.from)) return false;
    if (effort_.twice) return true;
    return std::pair(pieces_[outer].area, outer) < std::pair(pieces_[light].area, light);
  }

  bool is_own(std::uint32_t piece, std::uint32_t blocker) const {
    return std::ranges::binary_search(facts_.own[piece], blocker);
  }

  double tolerance(std::uint32_t outer, std::uint32_t light) const {
    return effort_.bound * std::min(pieces_[outer].area, pieces_[light].area) / 4;
  }

  void append_hidden(std::uint32_t light, const std::vector<std::uint32_t>& outers,
                     const std::set<std::uint32_t>& blockers, std::vector<PairExchange>& row) {
    if (outers.empty()) return;
    Obstacles near;
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t b : blockers) {
      if (is_own(light, b)) continue;
      near.blockers.push_back(obstacles_.blockers[b]);
      numbers.push_back(b);
    }
    const AreaLight source{pieces_[light].polygon};
    std::vector<ConvexPolygon> receivers;
    for (const std::uint32_t outer : outers) receivers.push_back(pieces_[outer].polygon);
    const ReceiverDivision division(source, near.blockers, receivers);
    const Light lights[] = {source};
    const std::vector<Body> bodies = illumination::touching_bodies(lights, near.blockers);
    LightIrradiance irradiance(source, 1, PreparedObstacles(near));
    for (std::uint32_t r = 0; r < outers.size(); ++r) {
      const ReceiverMesh mesh = division.mesh(r);
      const auto before = part_before(pieces_[light].polygon, receivers[r]);
      std::vector<std::uint32_t> under;
      for (std::uint32_t k = 0; k < numbers.size(); ++k) {
        if (is_own(outers[r], numbers[k])) under.push_back(k);
      }
      std::vector<Point3> many_limits = illumination::corners_of_jumps(mesh);
      for (const ExactVector& p : illumination::touching_places(bodies, receivers[r])) {
        many_limits.push_back(illumination::nearest_point(p));
      }
      Exchange exchange =
          illumination::hidden_exchange(mesh, {receivers[r], under, many_limits}, before.loops, irradiance,
                                        {tolerance(outers[r], light), effort_.most_evaluations});
      if (!shading::is_exact_zero(exchange.area)) exchange.area = widened(exchange.area, before.rounding);
      row.push_back({outers[r], light, exchange, true});
    }
  }

  std::span<const Piece> pieces_;
  const Obstacles& obstacles_;
  const illumination::StandingBetween& between_;
  const PieceFacts& facts_;
  const ViewFactorEffort& effort_;
  std::vector<std::uint32_t> near_;
};

/// Whether all corners lie strictly inside of what a closed mesh encloses: such a piece sees nothing.
bool is_enclosed(const Piece& piece, const Obstacles& obstacles) {
  return std::ranges::any_of(obstacles.enclosures, [&](const ClosedSurface& surface) {
    return std::ranges::all_of(piece.polygon.points(), [&](const Point3& p) { return is_strictly_inside(p, surface); });
  });
}

std::vector<PairExchange> all_exchanges(std::span<const Piece> pieces, const Obstacles& obstacles,
                                        const ViewFactorEffort& effort) {
  const illumination::StandingBetween between(obstacles.blockers);
  const OwnBlockers own(obstacles.blockers);
  PieceFacts facts;
  for (const Piece& piece : pieces) {
    facts.is_enclosed.push_back(is_enclosed(piece, obstacles));
    facts.own.push_back(own.of(piece.polygon));
  }
  std::vector<std::vector<PairExchange>> rows(pieces.size());
  std::atomic<std::size_t> done = 0;
  share_results(effort.processes, rows, [&] {
    for_all(pieces.size(), effort.threads, [&](std::size_t light, std::size_t) {
      if (effort.processes.is_mine(light)) {
        RowOfLight row(pieces, obstacles, between, facts, effort);
        rows[light] = row.found(static_cast<std::uint32_t>(light));
      }
      ++done;
      if (effort.progress) effort.progress(done, pieces.size());
    });
  });
  std::vector<PairExchange> all;
  for (auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

std::vector<Point3> all_points(std::span<const Piece> pieces, const Obstacles& obstacles) {
  std::vector<Point3> all;
  const auto add = [&](const auto& shape) { all.insert(all.end(), shape.points().begin(), shape.points().end()); };
  for (const Piece& piece : pieces) add(piece.polygon);
  for (const ConvexBlocker& blocker : obstacles.blockers) std::visit(add, blocker);
  return all;
}

/// A_i F_ij of surfaces.
using ExchangeAreas = std::map<std::pair<std::uint32_t, std::uint32_t>, Exchange>;

void add(ExchangeAreas& areas, std::uint32_t from, std::uint32_t to, const Exchange& exchange) {
  Exchange& sum = areas[{from, to}];
  sum.area = sum.area + exchange.area;
  sum.is_proven = sum.is_proven && exchange.is_proven;
}

double reciprocity_residual(const ExchangeAreas& areas) {
  double largest = 0;
  for (const auto& [pair, exchange] : areas) {
    const auto back = areas.find({pair.second, pair.first});
    if (back == areas.end()) continue;
    largest = std::max(largest, std::fabs(exchange.area.value - back->second.area.value));
  }
  return largest;
}

ViewFactor factor_of(std::uint32_t from, std::uint32_t to, double area, const Exchange& exchange) {
  const Bounded value = exchange.area / Bounded(area, 8 * shading::unit * area);
  // Neither below 0 nor above 1 is a better guess, and none is farther off than the other end.
  const double clamped = std::clamp(value.value, 0.0, 1.0);
  return {from, to, clamped, std::min(final_bound(value), std::max(clamped, 1 - clamped)), exchange.is_proven};
}

}  // namespace

ViewFactors view_factors(std::span<const ViewSurface> surfaces, const Obstacles& obstacles,
                         const ViewFactorEffort& effort) {
  if (!(effort.bound > 0)) throw PreconditionError("the bound of view factors is not positive");
  const std::vector<Piece> pieces = illumination::flat_pieces(surfaces);
  require_same_points(effort.processes, all_points(pieces, obstacles));
  ViewFactors result;
  result.areas.assign(surfaces.size(), 0);
  for (const Piece& piece : pieces) result.areas[piece.surface] += piece.area;
  ExchangeAreas areas;
  for (const PairExchange& pair : all_exchanges(pieces, obstacles, effort)) {
    const std::uint32_t outer = pieces[pair.outer].surface, light = pieces[pair.light].surface;
    add(areas, outer, light, pair.exchange);
    if (!effort.twice) add(areas, light, outer, pair.exchange);
    ++(pair.is_divided ? result.divided_pairs : result.unhidden_pairs);
    result.evaluations += pair.exchange.evaluations;
  }
  if (effort.twice) result.reciprocity_residual = reciprocity_residual(areas);
  for (const auto& [pair, exchange] : areas) {
    const auto [from, to] = pair;
    if ((effort.from && from != *effort.from) || shading::is_exact_zero(exchange.area)) continue;
    result.factors.push_back(factor_of(from, to, result.areas[from], exchange));
  }
  return result;
}

double enforce_closure(ViewFactors& matrix) {
  const std::size_t n = matrix.areas.size();
  std::vector<double> scale(n, 1), sums(n);
  const auto sum_rows = [&] {
    std::ranges::fill(sums, 0.0);
    for (const ViewFactor& f : matrix.factors) sums[f.from] += scale[f.from] * f.value * scale[f.to];
  };
  double residual = 0;
  for (int round = 0; round < 1000; ++round) {
    sum_rows();
    residual = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (sums[i] > 0) residual = std::max(residual, std::fabs(sums[i] - 1));
    }
    if (residual < 1e-15) break;
    // A square root, so that what both of a pair gain does not overshoot.
    for (std::size_t i = 0; i < n; ++i) scale[i] /= sums[i] > 0 ? std::sqrt(sums[i]) : 1;
  }
  for (ViewFactor& f : matrix.factors) f.value *= scale[f.from] * scale[f.to];
  return residual;
}

}  // namespace gnomon
