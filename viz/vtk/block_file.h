#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

#include "viz/vtk/block.h"
#include "viz/vtk/staged_folder.h"

namespace gnomon::viz {

/// Where a block's file lies in the result's folder: `shadow/volumes/lamp/table/umbra.vtp`.
std::string block_file_name(const Block& block);

/// Writes a data set as .vtp or .vtu, whichever it is. Throws: std::runtime_error naming the file.
void write_data(vtkPointSet& data, const StagedFile& file);

/// Reads a .vtp file whose cells are made of its points, and whose arrays have a number per cell or point. Links and
/// what is no regular file are not followed.
///
/// Throws: ResultError naming the file.
vtkSmartPointer<vtkPolyData> read_surface(const std::filesystem::path& file);

/// Reads a .vtu file, to be asked for its fields alone: its cells may be wrong. Throws: as read_surface.
vtkSmartPointer<vtkPointSet> read_solid(const std::filesystem::path& file);

}  // namespace gnomon::viz
