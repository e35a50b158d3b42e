#pragma once

#include <string>

#include "viz/vtk/palette.h"

class vtkRenderer;

namespace gnomon::viz {

/// Words about a point of a renderer, white around their letters so that they are read on anything.
///
/// Units: pixels of the renderer's window from its lower left corner.
struct HaloedWords {
  std::string text;
  double x = 0;
  double y = 0;
  double letter = 12;
  Color color = palette.edge;
};

void add_words(vtkRenderer& renderer, const HaloedWords& words);

/// A thin line between two points of the same pixels.
void add_leader(vtkRenderer& renderer, double x, double y, double to_x, double to_y, double width);

}  // namespace gnomon::viz
