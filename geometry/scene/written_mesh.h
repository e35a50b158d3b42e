#pragma once

#include "geometry/scene/mesh_formats.h"
#include "geometry/scene/scene_elements.h"

namespace gnomon {

/// The mesh that stands in the scene itself: "vertices", and "facets" as lists of their indices.
///
/// Throws: SceneError.
PolygonSoup written_soup(const SceneElement& element);

}  // namespace gnomon
