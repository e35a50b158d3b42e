#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// The laws of one light and one blocker in space: S1 to S14.
std::vector<Law> spatial_laws();

}  // namespace gnomon::laws
