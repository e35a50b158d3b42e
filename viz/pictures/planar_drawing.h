#pragma once

#include <string>
#include <variant>
#include <vector>

#include "gnomon/picture.h"
#include "viz/pictures/picture_camera.h"
#include "viz/pictures/picture_legend.h"
#include "viz/pictures/planar_lines.h"
#include "viz/vtk/palette.h"

namespace gnomon::viz {

/// The height of the letters of names, in pixels of the finished picture.
constexpr double letter_size = 11;

/// Filled polygons; where they overlap or are translucent they count as one area.
struct Fill {
  std::vector<Polygon> polygons;
  Color color;
  double opacity = 1;
};

/// Straight lines; lengths on paper are pixels of the finished picture.
struct Strokes {
  std::vector<Segment> segments;
  Color color;
  double width = 1;
  double dash = 0;          ///< length of a dash, and a little more than that of a gap; 0: no gaps
  bool round_ends = false;  ///< half discs beyond the ends
  std::string name = {};    ///< what a reader may call them; empty for none
};

struct Disc {
  Point3 centre;
  double diameter;  ///< pixels
  Color color;
  std::string name = {};
};

/// Words about a point, centred.
struct Words {
  Point3 at;
  std::string text;
  Color color;
};

/// Something that is painted. Layer and light as in PictureItem.
struct Mark {
  std::variant<Fill, Strokes, Disc, Words> shape;
  std::string layer = {};
  std::string light = {};
};

/// A drawing of a result of the plane, as marks in the order in which they are painted, whatever paints them.
struct PlanarDrawing {
  Box3 box;
  DrawingSize size;
  double unit_per_pixel;    ///< length in the scene of one pixel of the picture
  std::vector<Mark> marks;  ///< points are in the scene's coordinates, at z = 0
};

/// Regions filled, the umbrae above the penumbrae, extremal lines above them, receivers, blockers and lights on top;
/// the whole clip box fits the size, with a margin. What belongs to one of several lights bears its mark.
///
/// Requires: a selected source with dimension == 2; the box has an interior.
PlanarDrawing planar_drawing(const PictureSource& source, const DrawingSize& size, Shown labels);

/// What the drawing shows.
std::vector<LegendEntry> planar_legend(const PictureSource& source);

}  // namespace gnomon::viz
