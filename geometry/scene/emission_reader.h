#pragma once

#include "geometry/scene/scene_elements.h"
#include "gnomon/light.h"

namespace gnomon {

/// The keys "emission", "flaps" and "shade" of a segment light.
///
/// Throws: SceneError.
Emission read_emission(const SceneElement& element, const Point3& start, const Point3& end);

}  // namespace gnomon
