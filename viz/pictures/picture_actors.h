#pragma once

#include <span>

#include "viz/pictures/label_layout.h"
#include "viz/pictures/picture_camera.h"
#include "viz/pictures/picture_items.h"

class vtkRenderer;

namespace gnomon::viz {

/// The height of a label's letters, in pixels of the finished picture.
inline constexpr double label_letter = 12;

/// Adds the items to a renderer. Lengths on screen grow with `pixel`, the pixels per pixel of the finished picture.
void add_actors(vtkRenderer& renderer, std::span<const PictureItem> items, const PictureView& view,
                const DrawingSize& size, double pixel);

/// Adds words in front of everything.
void add_labels(vtkRenderer& renderer, std::span<const PlacedLabel> labels, const DrawingSize& size, double pixel);

}  // namespace gnomon::viz
