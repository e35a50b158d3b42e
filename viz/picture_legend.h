#pragma once

#include <string>

#include "viz/picture_scene.h"

class vtkRenderer;

namespace gnomon::viz {

/// Adds the legend of what the scene shows to a renderer of its own.
///
/// Units: `width` and `height` of the renderer's part of the window in pixels, `pixel` as in add_actors.
void add_legend(vtkRenderer& renderer, const PictureScene& scene, double width, double height, double pixel);

}  // namespace gnomon::viz
