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

/// The surfaces of all blocks but solids as the text of a glTF 2.0 file that needs no other file.
std::string gltf_text(std::span<const Block> blocks, const Box3& clip_box);

}  // namespace gnomon::viz
