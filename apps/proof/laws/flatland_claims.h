#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// What is said of the plane but is false: F3 to F5.
std::vector<Law> flatland_claims();

}  // namespace gnomon::laws
