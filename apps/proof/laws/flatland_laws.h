#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// The laws of one light and many blockers in the plane: Q1 to Q6.
std::vector<Law> flatland_laws();

}  // namespace gnomon::laws
