#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// The laws of one light and one segment blocker in the plane: P1 to P10.
std::vector<Law> planar_laws();

}  // namespace gnomon::laws
