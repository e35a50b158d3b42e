#pragma once

#include <string>

#include "viz/picture_scene.h"

class vtkRenderer;

namespace gnomon::viz {

/// Adds the legend of what the scene shows to a renderer of its own, which has its place in a window.
///
/// Units: `pixel` as in add_actors.
void add_legend(vtkRenderer& renderer, const PictureScene& scene, double pixel);

}  // namespace gnomon::viz
