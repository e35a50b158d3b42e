#pragma once

#include <cstddef>
#include <vector>

#include "apps/proof/report/visibility_tasks.h"

namespace gnomon::report {

/// How far answers move when a scene is turned and its coordinates are rounded again.
struct RotationResult {
  double distance = 0;  ///< of the scene from the centre of the turn
  std::size_t points = 0;
  double rms = 0;  ///< of the movement of the exact visible fraction: what rounding the input does
  double most = 0;
  std::size_t regions_changed = 0;
  std::size_t wrong_gnomon =
      0;                  ///< turned points whose region gnomon gets wrong, or whose fraction is outside its bound
  double embree_rms = 0;  ///< of the movement of the fraction by 256 shadow rays
  double embree_most = 0;
};

/// A triangular light behind 16 triangles, turned many times about an axis through the origin, with the scene at
/// several distances from it.
std::vector<RotationResult> rotation_results(Effort effort);

}  // namespace gnomon::report
