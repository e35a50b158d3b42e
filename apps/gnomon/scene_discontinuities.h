#pragma once

#include <string>
#include <vector>

#include "apps/gnomon/computed_shadows.h"
#include "apps/gnomon/division_plan.h"
#include "viz/vtk/discontinuity_result.h"

namespace gnomon {

/// Whether the visible fraction is worked out at every vertex.
enum class VertexFractions { left_out, worked_out };

/// Warns of what is left out. Throws: UnsupportedError if nothing can be made.
void tell_left_out(const DivisionPlan& plan);

/// The receivers of a plan, divided by what they receive of its lights; light by light.
///
/// Requires: the plan of receivers has no refusal; the scene outlives the result.
DiscontinuityResult divided_receivers(const DivisionPlan& plan, VertexFractions fractions, const Effort& effort);

/// The same for pictures and beside volumes: whatever is not supported is left out, with a warning beforehand.
///
/// Throws: UsageError for a name that the scene does not have.
std::vector<ReceiverResult> receivers_beside_volumes(const Scene& scene, const ReceiverSelection& selection,
                                                     const Effort& effort);

/// The discontinuity surfaces of a plan's lights, cut by a box.
///
/// Requires: the plan of surfaces has no refusal; the scene outlives the result.
DiscontinuityResult scene_surfaces(const DivisionPlan& plan, const Box3& box, const Effort& effort);

}  // namespace gnomon
