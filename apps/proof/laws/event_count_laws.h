#pragma once

#include <vector>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// E6: how many discontinuities a pair has.
std::vector<Law> event_count_laws();

}  // namespace gnomon::laws
