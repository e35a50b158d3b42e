#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/flatland_pair.h"
#include "gnomon/scene.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon {

/// One light and one blocker of a scene, and whether this version computes their shadow.
struct ScenePair {
  std::size_t light_index = 0;    ///< into the scene's lights
  std::size_t blocker_index = 0;  ///< into the scene's blockers
  std::size_t part = 0;  ///< of the blocker: a convex part, or a polyline's segment from vertex `part` to the next
  std::string light;
  std::string blocker;                       ///< part k of a polyline is named `fence#k`, of a mesh `vase#k`
  std::optional<ShadowPair> shadow;          ///< in space: the light and the convex part
  std::vector<std::uint32_t> part_vertices;  ///< of each point of a part, its index among the blocker's; else empty
  Position position = Position::standard;
  std::string reason;  ///< why the pair is not supported; empty if it is

  bool supported() const { return reason.empty(); }
};

/// Which pairs are asked for, by name; an empty name asks for all.
struct PairSelection {
  std::string light;
  std::string blocker;
};

/// The pairs of a scene that are asked for: light by light, blockers in file order, each part by part. A blocker is
/// chosen as a whole.
///
/// Throws: UsageError for a name that the scene does not have.
std::vector<ScenePair> scene_pairs(const Scene& scene, const PairSelection& selection);

/// The light and the segment of a pair of a scene of the plane.
planar::Pair planar_pair(const PlaneScene& scene, const ScenePair& pair);

/// Number of pairs that are supported.
std::size_t supported_count(const std::vector<ScenePair>& pairs);

}  // namespace gnomon
