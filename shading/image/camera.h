#pragma once

#include "gnomon/scene.h"
#include "shading/image/first_hit.h"

namespace gnomon::image {

/// The rays of a pinhole camera.
///
/// Definition: a pixel's place (x, y) runs from (0, 0) in the upper left corner of the picture to (width, height); its
///             middle is (i + 1/2, j + 1/2). A ray goes from the eye through the place on the plane across the way to
///             look_at, at the distance of look_at.
/// Exactness:  the point that a ray goes through is rounded; from there on it is what it is.
class Camera {
 public:
  /// Requires: a camera as scenes have it.
  explicit Camera(const SceneCamera& camera);

  Ray ray(double x, double y) const;

 private:
  Point3 eye_;
  Point3 corner_;        ///< of the picture, upper left, relative to the eye
  Point3 right_, down_;  ///< by one pixel
};

}  // namespace gnomon::image
