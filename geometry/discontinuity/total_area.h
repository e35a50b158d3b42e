#pragma once

#include <span>

#include "gnomon/receiver_mesh.h"

namespace gnomon {

/// The sum of areas: exact and correctly rounded where all of them are, else the sum of the rounded ones.
RegionArea total_area(std::span<const RegionArea> areas);

}  // namespace gnomon
