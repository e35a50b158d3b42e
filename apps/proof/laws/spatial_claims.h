#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// What is said of space but is false: F1, F2, F6 and F7.
std::vector<Law> spatial_claims();

}  // namespace gnomon::laws
