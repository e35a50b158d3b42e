#pragma once

#include <cstddef>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::report {

/// A square light of side 1 at height 4, points below it, and triangles in between.
struct TriangleScene {
  AreaLight light;
  std::vector<ConvexBlocker> blockers;
  std::vector<Point3> points;  ///< in [-1,1]² at height 0; the receiver's normal is (0, 0, 1)
};

/// The scene with n triangles of circumradius 0.9 / sqrt(n) + 0.02, each in a random plane, their centres spread
/// evenly over [-1,1]² and the heights from 1 to 3. Always the same for an n.
TriangleScene triangle_scene(std::size_t n, std::size_t points = 512);

/// 512 points in all, of one scene or, where a few triangles may happen to stand aside, of sixteen.
std::vector<TriangleScene> triangle_scenes(std::size_t n);

}  // namespace gnomon::report
