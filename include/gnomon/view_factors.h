#pragma once

/// @file
/// View factors behind all obstacles: the share of what one diffuse surface sends out that reaches another.
///
///     #include <gnomon/view_factors.h>
///     int main() {
///       using namespace gnomon;
///       const ViewSurface floor = {ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})};
///       const ViewSurface lid = {ConvexPolygon::from_points({{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}})};
///       const ViewSurface surfaces[] = {floor, lid};
///       const ViewFactors found = view_factors(surfaces, {}, {});
///       const ViewFactor& up = found.factors.front();  // from 0 to 1: 0.19982489569838746...
///       return up.is_proven && up.value > 0.199824895698 && up.value < 0.199824895699 ? 0 : 1;
///     }

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "gnomon/convex_polygon.h"
#include "gnomon/processes.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// A surface: convex pieces that do not overlap; it sends and receives with their fronts.
using ViewSurface = std::vector<ConvexPolygon>;

/// The share of what surface `from` sends out, alike in all directions, that reaches surface `to`.
///
/// Definition: 1 / (pi A) times the integral of cos cos / r² over both surfaces, where each sees the other; A is the
///             area of `from`.
struct ViewFactor {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  double value = 0;
  double error_bound = 0;  ///< at least |value - exact| if that is proven, else an estimate of it
  bool is_proven = true;
};

struct ViewFactors {
  std::vector<double> areas;        ///< of each surface, off by at most 4 ulp
  std::vector<ViewFactor> factors;  ///< by `from`, then by `to`; those that are exactly 0 are left out
  double reciprocity_residual = 0;  ///< the largest |A_i F_ij - A_j F_ji|, where both have been worked out
  std::size_t unhidden_pairs = 0;   ///< pairs of pieces between which nothing stands
  std::size_t divided_pairs = 0;    ///< pairs of which one was divided by what it sees of the other
  std::size_t evaluations = 0;      ///< how often irradiance behind obstacles was asked for
};

struct ViewFactorEffort {
  double bound = 1e-9;                   ///< wanted of every factor
  std::size_t most_evaluations = 40000;  ///< for one pair of pieces; where they do not do, error_bound says so
  unsigned threads = 1;
  std::optional<std::uint32_t> from = {};  ///< only factors from this surface
  bool twice = false;                      ///< both of A_i F_ij and A_j F_ji, each by itself
  Processes processes = {};                ///< that share the work
  std::function<void(std::size_t done, std::size_t of)> progress = {};  ///< called by any thread
};

/// The view factors between surfaces behind obstacles, blockers and enclosures.
///
/// Surfaces may be facets of blockers: nothing behind a piece hides anything from it.
/// Method:     a pair of pieces between which nothing stands exchanges what the integral of Sparrow along both
///             boundaries says, with a bound that is proven. Otherwise the smaller piece is divided by all
///             discontinuities of what it sees of the other (ReceiverDivision): lit parts as before, the rest by
///             Gauss's rule in triangles, of irradiance that is exact but for roundings; the difference of two rules is
///             the estimate of its error.
/// Requires:   no refusal by range (range_refusal) of a surface or blocker; `bound` is positive.
/// Exactness:  the result does not depend on the number of threads and of processes.
/// Throws:     PreconditionError.
ViewFactors view_factors(std::span<const ViewSurface> surfaces, const Obstacles& obstacles,
                         const ViewFactorEffort& effort);

/// Factors that fulfil reciprocity and closure: the symmetric exchange areas A_i F_ij scaled by a factor of each
/// surface until all row sums are 1. That makes a matrix consistent, not true.
///
/// Returns: the largest distance of a row sum from 1 that is left; rows without factors stay empty and do not count.
double enforce_closure(ViewFactors& matrix);

}  // namespace gnomon
