#pragma once

#include <span>
#include <string>
#include <vector>

#include "viz/pictures/picture_camera.h"
#include "viz/pictures/picture_items.h"

namespace gnomon::viz {

/// Words on a picture: their middle and size, in pixels from the upper left corner.
struct LabelBox {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// The size of words in letters of that height.
LabelBox label_box(const std::string& text, double letter, double x, double y);

bool overlap(const LabelBox& a, const LabelBox& b);

/// Pushes overlapping boxes apart, each pair along its shorter way, and keeps them inside of the frame.
///
/// Returns: the indices of boxes that overlap none before them; the others are better left out.
std::vector<std::size_t> pushed_apart(std::vector<LabelBox>& boxes, const DrawingSize& frame);

/// A label that is to be drawn.
struct PlacedLabel {
  std::string text;
  LabelBox box;
  double from_x = 0;  ///< the place on the element
  double from_y = 0;
  bool is_led = false;  ///< it was pushed off that place: a line leads there
};

/// Every label at the first of its places that nothing opaque hides, pushed apart from the others; those of which no
/// place is seen, or that find no room, are left out.
std::vector<PlacedLabel> placed_labels(std::span<const PictureLabel> labels, std::span<const PictureItem> items,
                                       const PictureScene& scene, const PictureView& view, const DrawingSize& size,
                                       double letter);

}  // namespace gnomon::viz
