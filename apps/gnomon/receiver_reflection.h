#pragma once

#include <string>

#include "apps/gnomon/computed_shadows.h"
#include "apps/gnomon/scene_discontinuities.h"

namespace gnomon {

/// Who looks at receivers, and what they are made of: as options have it. See eye_named and chosen_material; without a
/// material each receiver has its own.
struct ReceiverViews {
  std::string eye;
  std::string material;
};

/// Adds to every divided receiver what its light gives to the points of its mesh's drawing, and what these reflect.
///
/// Exactness: of the points as doubles, on the facet that was divided.
/// Throws:    UsageError.
void add_reflection(DiscontinuityResult& result, const DivisionPlan& plan, const ReceiverViews& seen,
                    const Effort& effort);

}  // namespace gnomon
