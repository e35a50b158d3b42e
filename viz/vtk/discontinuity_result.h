#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gnomon/discontinuity.h"
#include "gnomon/result.h"
#include "gnomon/scene.h"

namespace gnomon {

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
  std::vector<std::uint32_t> blocker_ids;  ///< of each, its index in SpaceScene::blockers
  std::vector<ReceiverResult> receivers = {};
  std::vector<SurfaceResult> surfaces = {};
};

/// The element as messages and files call it: `light:lamp`, `blocker:vase#12`, `receiver:floor`.
///
/// Requires: the element of an event of this light (and receiver).
std::string element_text(const DiscontinuityResult& result, const std::string& light, const std::string& receiver,
                         const EventElement& element);

}  // namespace gnomon
