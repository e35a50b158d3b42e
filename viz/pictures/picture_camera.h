#pragma once

#include <variant>

#include "gnomon/picture.h"
#include "viz/pictures/picture_scene.h"

namespace gnomon::viz {

/// The part of a window or page that a drawing fills, in pixels of the finished picture.
struct DrawingSize {
  double width;
  double height;
};

/// Where a picture is seen from.
struct PictureView {
  Point3 position;
  Point3 focus;
  Point3 up;
  double angle = 26;  ///< of the whole picture's height, degrees
};

/// Presets frame every visible point. The three-quarter view is one from above that shows as much of the receivers as
/// possible.
///
/// Requires: a place that is not at its focus; an up direction that is not along the view.
PictureView picture_view(const PictureScene& scene, const std::variant<CameraPreset, CameraPlace>& camera,
                         const DrawingSize& size);

}  // namespace gnomon::viz
