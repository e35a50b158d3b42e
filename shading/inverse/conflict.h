#pragma once

#include <functional>
#include <span>

#include "gnomon/light_design.h"
#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// Goals of which none can be left out without leaving a position, found by leaving out one after the other.
///
/// Requires: all goals together leave nothing.
/// Returns:  a minimal set, perhaps not the only one; where all its goals are convex also Farkas' multipliers: planes
///           n x + d <= 0 times these sum up to 1 <= 0. Where only boundaries that belong to neither meet, there are
///           none.
DesignConflict conflict(DesignSpace& space, const DesignDomain& domain, std::span<const GoalSets> goals, double margin);

/// The same, `is_feasible` telling whether some goals, by their numbers, leave a position: goals may ask for more than
/// their sets. `is_polyhedral`: they do not.
DesignConflict conflict(DesignSpace& space, const DesignDomain& domain, std::span<const GoalSets> goals,
                        const std::function<bool(const std::vector<std::uint32_t>&)>& is_feasible, bool is_polyhedral);

/// The goals of some numbers.
std::vector<GoalSets> chosen_goals(std::span<const GoalSets> goals, const std::vector<std::uint32_t>& numbers);

}  // namespace gnomon::inverse
