#pragma once

#include <string>
#include <vector>

#include "viz/pictures/picture_geometry.h"
#include "viz/pictures/picture_source.h"

namespace gnomon::viz {

struct PictureReceiver {
  std::string name;
  Polygon polygon;     ///< counterclockwise seen from the side of the plane's normal
  PicturePlane plane;  ///< the normal points to the scene, if all of it lies on one side, else out of the front
  bool ends_scene;     ///< all of the scene lies on one side
  bool turned_away;    ///< its front is not the side of the normal
  bool has_twin;       ///< another receiver is its other side
};

/// A light without a place.
struct PictureSun {
  std::string name;
  Point3 direction;  ///< of length 1
};

/// What is drawn.
struct PictureScene {
  std::string title;
  double size = 1;  ///< diagonal of what has a place
  Point3 up = {0, 0, 1};
  std::vector<std::string> light_names;  ///< those that are shown, one at a time
  std::size_t light_count = 0;           ///< of the whole scene
  std::vector<PictureBlock> lights;      ///< those that have a place
  std::vector<PictureSun> suns;
  std::vector<PictureBlock> blockers;
  std::vector<PictureReceiver> receivers;
  std::vector<PictureBlock> receiver_meshes;  ///< receivers of several facets
  std::vector<PictureBlock> umbras;
  std::vector<PictureBlock> penumbras;          ///< without the boundary they share with umbras
  std::vector<PictureBlock> divided_receivers;  ///< faces with their regions, edges with their orders
  std::vector<PictureBlock> painted_receivers;  ///< triangles with their irradiance, in the place of regions
  std::vector<PictureBlock> discontinuities;    ///< surfaces with their orders
};

/// Requires: a selected source.
PictureScene picture_scene(const PictureSource& source);

/// Every point that is to be seen.
std::vector<Point3> visible_points(const PictureScene& scene);

}  // namespace gnomon::viz
