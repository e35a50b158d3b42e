#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viz/palette.h"
#include "viz/picture_scene.h"

namespace gnomon::viz {

/// How a surface or line looks.
struct Look {
  Color color;
  double opacity = 1;
  double ambient = 0.55;  ///< share of the light that comes from everywhere
  double line_width = 1;  ///< pixels of the finished picture
};

/// One thing that is drawn: surfaces or lines of one look.
struct PictureItem {
  std::string name;  ///< what a reader of the picture may call it; empty for what only sets off something else
  vtkSmartPointer<vtkPolyData> data;
  Look look;
  /// Surfaces are seen from the side of this normal only, and lines are faint from the other one.
  std::optional<PicturePlane> front = {};
  std::vector<std::string> cell_names = {};  ///< of the cells one by one, where they have names
};

/// The words at an element.
struct PictureLabel {
  Point3 at;
  std::string text;
  std::optional<PicturePlane> front = {};  ///< seen from the side of this normal only
};

/// Everything of the scene, opaque things first. A point light is a ball, a linear one a rod.
///
/// Layers on a receiver lie a little above one another, less than a pixel of a picture.
std::vector<PictureItem> picture_items(const PictureScene& scene);

/// The names of lights, blockers and receivers, each kind only where it has at most eight. `up` is where the labels of
/// lights and blockers stand above them.
std::vector<PictureLabel> picture_labels(const PictureScene& scene, const Point3& up);

}  // namespace gnomon::viz
