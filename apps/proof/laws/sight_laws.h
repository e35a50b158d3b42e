#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// The laws about many blockers in space.
std::vector<Law> sight_laws();

}  // namespace gnomon::laws
