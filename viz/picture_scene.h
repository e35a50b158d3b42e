#pragma once

#include <string>
#include <vector>

#include "viz/picture_geometry.h"
#include "viz/picture_source.h"

namespace gnomon::viz {

struct PictureReceiver {
  std::string name;
  Polygon polygon;     ///< counterclockwise seen from the side of the plane's normal
  PicturePlane plane;  ///< the normal points to the scene, if all of it lies on one side
  bool ends_scene;     ///< all of the scene lies on one side
};

/// A shadow on a receiver.
struct PaintedShadow {
  std::size_t receiver;
  bool umbra;
  Polygon polygon;
};

/// What is drawn.
struct PictureScene {
  std::string title;
  bool complete = true;
  double size = 1;  ///< diagonal of lights, blockers and receivers
  std::vector<PictureBlock> lights;
  std::vector<PictureBlock> blockers;
  std::vector<PictureReceiver> receivers;
  std::vector<PictureBlock> umbras;
  std::vector<PictureBlock> penumbras;          ///< without the boundary they share with umbras
  std::vector<PaintedShadow> shadows;           ///< penumbrae first; none where receivers are divided
  std::vector<PictureBlock> divided_receivers;  ///< faces with their regions, edges with their orders
  std::vector<PictureBlock> discontinuities;    ///< surfaces with their orders
};

PictureScene picture_scene(const PictureSource& source);

/// Every point that is to be seen.
std::vector<Point3> visible_points(const PictureScene& scene);

}  // namespace gnomon::viz
