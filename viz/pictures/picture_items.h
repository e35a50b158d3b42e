#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viz/pictures/picture_scene.h"
#include "viz/vtk/colour_map.h"
#include "viz/vtk/palette.h"

namespace gnomon::viz {

/// Of the ball that stands for a point, as a share of the scene's size.
inline constexpr double ball_radius = 0.012;

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
  std::string layer;       ///< of the legend's row that it belongs to
  std::string light = {};  ///< where several lights can be shown: the one with which it is
  /// Surfaces are seen from the side of this normal only, and lines are faint from the other one.
  std::optional<PicturePlane> front = {};
  std::vector<std::string> cell_names = {};  ///< of the cells one by one, where they have names
  std::vector<Color> point_colors = {};      ///< of the points one by one, in place of the look's, where they differ
  /// It has no place: an arrow of length 1 about the origin, to be drawn in the picture's upper right corner.
  bool in_corner = false;
};

/// The words at an element.
struct PictureLabel {
  std::string text;
  std::vector<Point3> places;  ///< on the element, the best first; the label stands at the first that is seen
  std::string layer;
  std::string light = {};
  std::optional<PicturePlane> front = {};  ///< seen from the side of this normal only
  bool in_corner = false;                  ///< below the arrow in the corner
};

/// Everything of the scene, opaque things first. A point light is a ball, a linear one a rod, one without a place an
/// arrow.
///
/// Layers on a receiver lie a little above one another, less than a pixel of a picture. What is painted on a receiver
/// belongs to its front; the back of one inside the scene has the colour of no region.
std::vector<PictureItem> picture_items(const PictureScene& scene);

/// The names of lights, which are shown one at a time, and of blockers and receivers, each kind only where it has at
/// most eight. Places are the better the more they lie on the side of the viewer.
std::vector<PictureLabel> picture_labels(const PictureScene& scene, const Point3& viewer);

/// The mark of what is shown with one of several lights; empty where only one is shown.
std::string light_mark(const PictureScene& scene, const std::string& light);

/// The scale of the irradiances that receivers are painted with under a light; the scales of lights differ.
RoundScale irradiance_scale(const PictureScene& scene, const std::string& light);

/// True of the block of a divided receiver in whose place irradiance is painted.
bool is_painted(const PictureScene& scene, const PictureBlock& block);

/// True if the receiver bears the regions of the light, or its irradiance.
bool is_divided(const PictureScene& scene, const std::string& receiver, const std::string& light);

}  // namespace gnomon::viz
