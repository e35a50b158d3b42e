#pragma once

#include <span>

#include "viz/picture_camera.h"
#include "viz/picture_items.h"

class vtkRenderer;

namespace gnomon::viz {

/// Adds the items to a renderer. Lengths on screen grow with `pixel`, the pixels per pixel of the finished picture.
void add_actors(vtkRenderer& renderer, std::span<const PictureItem> items, const PictureView& view, double pixel);

/// Adds words of one size, whatever their distance; those of walls that are seen from behind are left out.
void add_labels(vtkRenderer& renderer, std::span<const PictureLabel> labels, const PictureView& view, double pixel);

}  // namespace gnomon::viz
