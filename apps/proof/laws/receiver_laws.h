#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// E1, E7 and M5: the discontinuities that a receiver shows.
std::vector<Law> receiver_laws();

}  // namespace gnomon::laws
