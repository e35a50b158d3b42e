#pragma once

#include "geometry/length_unit.h"
#include "geometry/spatial/light.h"
#include "shading/irradiance.h"

namespace gnomon {

/// The irradiance in W/m² of a light whose scene measures lengths in another unit.
///
/// Definition: `e` is worked out as if the unit were the metre, from the strength as the scene file has it [W/(m² sr),
///             W/(sr m), W/sr, W/m²]. With a unit of u metres that of a point light is 1/u² times as large, that of a
///             linear light 1/u; radiance and a sun's irradiance know no distance.
/// Exactness:  the bound grows by that of the conversion.
Irradiance per_square_metre(const Irradiance& e, const Light& light, const LengthUnit& unit);

}  // namespace gnomon
