#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "gnomon/scene.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// What a point of a scene receives of each light.
struct RegionFinder {
  std::vector<std::string> lights;  ///< names, in file order
  unsigned threads = 1;
  /// One answer per light for the point of these coordinates; z is not looked at in the plane. Workers are those of
  /// for_all with that many threads.
  std::function<std::vector<Visibility>(std::size_t worker, const std::array<double, 3>&)> at;
  /// The same for a receiver's point with this normal; none in the plane.
  std::function<std::vector<Visibility>(std::size_t worker, const std::array<double, 3>&, const std::array<double, 3>&)>
      received;
  /// Whether rounding may have put a point on the wrong side of a blocker; none in the plane.
  std::function<bool(const std::array<double, 3>&)> is_within_rounding;
};

/// The finder of a scene, for all lights or, if a name is given, for that one; for that many threads, 0: one per
/// processor. `search` is how occluders of linear lights are found in space.
///
/// Requires: the scene outlives the result.
/// Throws:   UsageError for a name that the scene does not have.
RegionFinder region_finder(const Scene& scene, const std::string& light, unsigned threads,
                           const LinearSearch& search = {});

}  // namespace gnomon
