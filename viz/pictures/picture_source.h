#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

#include "gnomon/point.h"
#include "gnomon/result.h"

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
  UpAxis up = UpAxis::z;
  std::string length_unit = "m";
  Box3 clip_box;
  std::vector<PictureBlock> blocks;
  std::vector<std::string> lights = {};  ///< those that are shown, one at a time; set by `selected`
  std::size_t light_count = 0;           ///< of the whole scene
};

/// Requires: result.scene is not null.
PictureSource picture_source(const ShadowResult& result);

/// What a folder that a command has written as vtm or vtpc holds.
///
/// Throws: std::runtime_error naming the file that could not be read.
PictureSource picture_source(const std::filesystem::path& directory);

}  // namespace gnomon::viz
