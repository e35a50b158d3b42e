#pragma once

#include <vector>

#include "apps/proof/report/targets.h"

namespace gnomon::report {

/// The time that plain doubles take for all extremal planes of 4 by 4 vertices on the machine for which times of planes
/// and meshes are wanted. On another machine they are scaled by what it takes there.
inline constexpr double plain_planes_there = 136e-9;

/// That time on this machine, divided by the one above. 1 where it was not measured.
double machine_scale(const Report& report);

/// What is wanted of the timings.
std::vector<Finding> timing_findings(const Report& report);

}  // namespace gnomon::report
