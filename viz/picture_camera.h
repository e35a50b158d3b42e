#pragma once

#include "viz/picture_scene.h"

namespace gnomon::viz {

/// Where a picture is seen from.
struct PictureView {
  Point3 position;
  Point3 focus;
  Point3 up;
  double angle = 26;  ///< of the whole picture's height, degrees
};

/// A three-quarter view from above that shows as much of the receivers as possible and frames every visible point.
/// "Above" is where the lights are: the axis of space that leads there from the blockers, z where it is close.
PictureView three_quarter_view(const PictureScene& scene, double width_to_height);

/// False for a wall between the camera and the scene.
bool is_seen_from_inside(const PictureReceiver& receiver, const PictureView& view);

}  // namespace gnomon::viz
