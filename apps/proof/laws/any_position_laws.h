#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// The laws of one light and one blocker, of any kind and in any position, and of concave blockers.
std::vector<Law> any_position_laws();

}  // namespace gnomon::laws
