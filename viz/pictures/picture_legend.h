#pragma once

#include <string>
#include <vector>

#include "viz/pictures/picture_scene.h"
#include "viz/vtk/palette.h"

class vtkRenderer;

namespace gnomon::viz {

/// What stands before the words of an entry.
enum class LegendMark { filled, line, dashed };

struct LegendEntry {
  std::string text;
  Color color;
  LegendMark mark = LegendMark::filled;
  std::string layer = {};  ///< what it stands for, as PictureItem::layer
  std::string light = {};  ///< where several lights can be shown: the one with which it stands there
};

struct Legend {
  std::string title;
  std::vector<LegendEntry> entries;
};

/// A light by name, and where the scene has several, that it is one of them.
std::string light_text(const std::string& name, std::size_t light_count);

/// What a picture of the scene shows.
std::vector<LegendEntry> legend_entries(const PictureScene& scene);

/// Adds a legend to a renderer of its own, which has its place in a window.
///
/// Units: `pixel` as in add_actors.
void add_legend(vtkRenderer& renderer, const Legend& legend, double pixel);

}  // namespace gnomon::viz
