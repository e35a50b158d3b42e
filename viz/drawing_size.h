#pragma once

namespace gnomon::viz {

/// The part of a window or page that a drawing fills, in pixels of the finished picture.
struct DrawingSize {
  double width;
  double height;
};

}  // namespace gnomon::viz
