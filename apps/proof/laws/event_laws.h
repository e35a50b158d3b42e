#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// E2 to E6: the order of discontinuities in space, and how many there are.
std::vector<Law> event_laws();

}  // namespace gnomon::laws
