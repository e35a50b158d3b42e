#pragma once

#include <optional>
#include <string>

#include "apps/proof/laws/visibility_cases.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// What exact_visibility ought to say by the definition: region, and fraction to a hundred digits. Nothing if it says
/// that, with the nearest double and a true bound of its error; else what differs.
std::optional<std::string> disagreement(const laws::VisibilityCase& drawn, const Visibility& got);

}  // namespace gnomon
