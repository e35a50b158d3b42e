#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "viz/picture_geometry.h"

namespace gnomon::viz {

/// A block as a picture takes it, from memory or from a file.
struct PictureBlock {
  std::vector<std::string> path;
  std::string kind;
  vtkSmartPointer<vtkPolyData> data;
};

/// A result as a picture takes it.
struct PictureSource {
  std::string title;
  bool complete = true;  ///< false if the shadows of some pairs are not known
  int dimension = 3;
  Box3 clip_box;
  std::vector<PictureBlock> blocks;
};

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

/// What a receiver receives, as triangles of one region, or as lines.
struct PaintedMesh {
  std::size_t receiver;
  int region;  ///< number of the region; -1 for lines
  vtkSmartPointer<vtkPolyData> data;
};

/// What is drawn.
struct PictureScene {
  std::string title;
  bool complete = true;
  double size = 1;  ///< diagonal of lights, blockers and receivers
  std::vector<PictureBlock> lights;
  std::vector<PictureBlock> blockers;
  std::vector<PictureReceiver> receivers;
  std::vector<vtkSmartPointer<vtkPolyData>> umbras;
  std::vector<vtkSmartPointer<vtkPolyData>> penumbras;  ///< without the boundary they share with umbras
  std::vector<PaintedShadow> shadows;                   ///< penumbrae first
  std::vector<PaintedMesh> meshes;                      ///< of receivers divided by discontinuities
  std::vector<PictureBlock> discontinuities;            ///< surfaces, one block for each order
};

PictureScene picture_scene(const PictureSource& source);

/// Every point that is to be seen.
std::vector<Point3> visible_points(const PictureScene& scene);

}  // namespace gnomon::viz
