#pragma once

#include <vector>

#include "viz/picture_legend.h"
#include "viz/picture_scene.h"

class vtkRenderer;

namespace gnomon::viz {

/// The part of a window that a drawing fills, in pixels of the finished picture.
struct DrawingSize {
  double width;
  double height;
};

/// Draws a result of the plane: regions filled, the umbrae above the penumbrae, extremal lines above them, light and
/// blocker on top. Sets the renderer's camera, so that the whole clip box is seen.
///
/// Requires: source.dimension == 2, the box has an interior.
void add_planar_drawing(vtkRenderer& renderer, const PictureSource& source, const DrawingSize& size);

/// What the drawing shows.
std::vector<LegendEntry> planar_legend(const PictureSource& source);

}  // namespace gnomon::viz
