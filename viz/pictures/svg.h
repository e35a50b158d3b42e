#pragma once

#include <string>

#include "viz/pictures/picture_legend.h"
#include "viz/pictures/planar_drawing.h"

namespace gnomon::viz {

/// A drawing of the plane with its legend beside it, as the text of an SVG file. Names are titles, which viewers show
/// under the mouse; numbers are rounded to a thousandth of a pixel. An empty legend takes no room.
std::string svg_text(const PlanarDrawing& drawing, const Legend& legend);

/// The drawing alone as an element of a page: the marks in groups that bear their layer and light.
std::string svg_in_page(const PlanarDrawing& drawing);

}  // namespace gnomon::viz
