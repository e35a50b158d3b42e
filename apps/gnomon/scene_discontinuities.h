#pragma once

#include <string>
#include <vector>

#include "apps/gnomon/computed_shadows.h"
#include "viz/vtk/discontinuity_result.h"

namespace gnomon {

/// Which lights and receivers are asked for, by name; an empty name asks for all.
struct ReceiverSelection {
  std::string light;
  std::string receiver;
};

/// Whether the visible fraction is worked out at every vertex.
enum class VertexFractions { left_out, worked_out };

/// Every receiver asked for, divided by what it receives of every light asked for; light by light.
///
/// Requires: the scene outlives the result.
/// Throws:   UsageError for a name that the scene does not have; UnsupportedError if nothing of it is supported. What
///           is not supported beside others is warned of.
DiscontinuityResult divided_receivers(const Scene& scene, const ReceiverSelection& selection, VertexFractions fractions,
                                      const Effort& effort);

/// The same for pictures and beside volumes: whatever is not supported is left out, with a warning.
///
/// Throws: UsageError for a name that the scene does not have.
std::vector<ReceiverResult> receivers_beside_volumes(const Scene& scene, const ReceiverSelection& selection,
                                                     const Effort& effort);

/// The discontinuity surfaces of every light asked for, cut by a box.
///
/// Throws: as divided_receivers.
DiscontinuityResult scene_surfaces(const Scene& scene, const std::string& light, const Box3& box, const Effort& effort);

}  // namespace gnomon
