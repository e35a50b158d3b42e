#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/scene/scene.h"
#include "geometry/spatial/position.h"

namespace gnomon {

/// One light and one blocker of a scene, and whether this version computes their shadow.
struct ScenePair {
  std::size_t light_index = 0;    ///< into Scene::lights (planar_lights in dimension 2)
  std::size_t blocker_index = 0;  ///< into Scene::blockers (planar_blockers in dimension 2)
  std::string light;
  std::string blocker;
  std::optional<Position> position;  ///< nothing where no position is defined: a direction, or a shape that is not flat
  std::string reason;                ///< why the pair is not supported; empty if it is

  bool supported() const { return reason.empty(); }
};

/// Which pairs are asked for, by name; an empty name asks for all.
struct PairSelection {
  std::string light;
  std::string blocker;
};

/// The pairs of a scene that are asked for: light by light, blockers in file order.
///
/// Throws: UsageError for a name that the scene does not have.
std::vector<ScenePair> scene_pairs(const Scene& scene, const PairSelection& selection);

/// Number of pairs that are supported.
std::size_t supported_count(const std::vector<ScenePair>& pairs);

}  // namespace gnomon
