#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>
#include <string>

#include "viz/vtk/block.h"

namespace gnomon::viz {

/// The surfaces of all blocks but solids in one data set, with the cell array `block_id` and the field array
/// `block_names`, whose entry of that number is the block's path.
vtkSmartPointer<vtkPolyData> merged_surfaces(std::span<const Block> blocks, const Fields& fields);

/// The same as the text of a Wavefront OBJ file: one group per block, named by its path as in file names.
std::string obj_text(std::span<const Block> blocks);

/// One surface as the text of an STL file; convex polygons become fans of triangles.
std::string stl_text(vtkPolyData& surface, const std::string& name);

/// How a scene stands in glTF, which is in metres with y up.
struct ModelFrame {
  Box3 clip_box;
  bool is_z_up = true;
  double metres = 1;  ///< of the scene's unit of length
};

/// That of a scene of the plane is seen from its front.
ModelFrame model_frame(const Box3& clip_box, int dimension, UpAxis up, const std::string& length_unit);

/// The surfaces of all blocks but solids as the text of a glTF 2.0 file that needs no other file. Its root node turns
/// and scales them.
std::string gltf_text(std::span<const Block> blocks, const ModelFrame& frame);

}  // namespace gnomon::viz
