#pragma once

#include "viz/pictures/planar_drawing.h"

class vtkRenderer;

namespace gnomon::viz {

/// Paints a drawing, and sets the renderer's camera so that all of it is seen.
void add_planar_drawing(vtkRenderer& renderer, const PlanarDrawing& drawing);

}  // namespace gnomon::viz
