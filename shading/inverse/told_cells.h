#pragma once

#include "gnomon/light_design.h"
#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// A cell as it is told: corners rounded to nearest, faces as loops. With `may_be_far` corners on a wall of the domain,
/// which is everywhere then, are directions in truth.
FeasibleCell told(const DesignSpace& space, const Cell& cell, bool may_be_far);

/// True for corners on walls of the domain.
bool is_far(const DesignSpace& space, const Corner& corner);

}  // namespace gnomon::inverse
