#pragma once

#include "viz/picture_camera.h"
#include "viz/picture_scene.h"

class vtkRenderer;

namespace gnomon::viz {

/// Adds everything of the scene to a renderer. Lengths on screen grow with `pixel`, the pixels per pixel of the
/// finished picture.
void add_actors(vtkRenderer& renderer, const PictureScene& scene, const PictureView& view, double pixel);

}  // namespace gnomon::viz
