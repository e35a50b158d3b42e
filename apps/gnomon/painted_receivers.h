#pragma once

#include <span>
#include <vector>

#include "apps/gnomon/computed_shadows.h"
#include "gnomon/result.h"

namespace gnomon {

/// The sides of divided receivers, fine enough to be painted by what they receive of their light behind all blockers.
///
/// Exactness: that of image::IrradianceMesh; how fine is told by the largest irradiance of each light.
std::vector<PaintedReceiver> painted_receivers(const SpaceScene& scene, std::span<const ReceiverResult> divided,
                                               const Effort& effort);

}  // namespace gnomon
