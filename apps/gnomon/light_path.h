#pragma once

#include <string>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {

/// A place to which a light moves, and the line of the file that says so.
struct PathPlace {
  std::size_t line = 0;
  Point3 position;  ///< z is 0 in the plane
};

/// Reads a path: CSV with the header x,y,z (x,y in the plane), one position a line, as PointTable reads points.
///
/// Throws: SceneError naming file and line, what was found and what was expected; also for a path without positions.
std::vector<PathPlace> read_light_path(const std::string& file, int dimension);

/// The scene with one light moved, without turning it, so that its first vertex lies at the place. Moved vertices are
/// rounded to doubles.
///
/// Requires: the scene has the light.
/// Throws:   SceneError naming file and line if the vertices, so rounded, are no light any more; UnsupportedError for a
///           directional light, which is nowhere.
Scene with_light_at(const Scene& scene, const std::string& light, const PathPlace& place, const std::string& file);

}  // namespace gnomon
