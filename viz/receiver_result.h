#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/discontinuity/receiver_mesh.h"

namespace gnomon {

/// What one receiver, a flat piece of a receiver of the file, receives of one light behind all blockers together.
struct ReceiverResult {
  std::uint32_t light_id = 0;     ///< index into Scene::lights
  std::uint32_t receiver_id = 0;  ///< index into Scene::receivers
  std::string light;
  std::string receiver;
  ReceiverMesh mesh;
  std::vector<double> visible_fractions = {};  ///< of each vertex, if it was asked for
  std::string side = receiver;                 ///< the receiver, or its side, that the piece belongs to
};

/// The pieces of one side of a receiver, one after the other, that receive of one light.
using SideResult = std::span<const ReceiverResult>;

/// The results, side by side in their order.
std::vector<SideResult> sides_of(std::span<const ReceiverResult> receivers);

/// The areas of a side's regions, summed up over its pieces.
std::array<RegionArea, receiver_region_count> areas_of(SideResult side);

}  // namespace gnomon
