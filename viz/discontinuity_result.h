#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/discontinuity/discontinuity_surface.h"
#include "geometry/discontinuity/receiver_mesh.h"
#include "geometry/scene/scene.h"

namespace gnomon {

/// What one receiver, a flat piece of a receiver of the file, receives of one light.
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

/// The discontinuity surfaces of one light.
struct SurfaceResult {
  std::uint32_t light_id = 0;
  std::string light;
  std::vector<DiscontinuitySurface> surfaces;
};

/// A scene, and what one of the commands on discontinuities has made of it, ready to be written.
struct DiscontinuityResult {
  const Scene* scene = nullptr;  ///< never null when used; outlives the result
  Box3 clip_box;
  std::vector<std::string> blockers;       ///< names of the convex blockers, which events number
  std::vector<std::uint32_t> blocker_ids;  ///< of each, its index in Scene::blockers
  std::vector<ReceiverResult> receivers = {};
  std::vector<SurfaceResult> surfaces = {};
};

/// The element as messages and files call it: `light:lamp`, `blocker:vase#12`, `receiver:floor`.
///
/// Requires: the element of an event of this light (and receiver).
std::string element_text(const DiscontinuityResult& result, const std::string& light, const std::string& receiver,
                         const EventElement& element);

}  // namespace gnomon
