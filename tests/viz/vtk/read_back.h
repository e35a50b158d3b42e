#pragma once

#include <vtkPointSet.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

class vtkFieldData;

namespace gnomon {

/// The leaves of a file as VTK reads them, by their names joined with '/'.
using ReadBlocks = std::map<std::string, vtkSmartPointer<vtkPointSet>>;

/// A tree file as VTK's own readers see it.
struct ReadTree {
  ReadBlocks blocks;
  vtkSmartPointer<vtkFieldData> fields;  ///< of the root
};

ReadTree read_multiblock(const std::filesystem::path& file);

/// Here the names are those of the partitioned data sets.
ReadTree read_partitioned(const std::filesystem::path& file);

nlohmann::json read_json(const std::filesystem::path& file);

/// The first value of a field array as text; "none" where there is no such array.
std::string field_text(vtkFieldData* fields, const std::string& name);

/// The volume inside a closed triangle surface, positive where its normals point outward.
double enclosed_volume(vtkPointSet& triangles);

/// The volume of all cells, positive where their faces run counterclockwise seen from outside.
double filled_volume(vtkPointSet& cells);

/// True if every directed edge of the triangles occurs once and its opposite too.
bool is_closed_surface(vtkPointSet& triangles);

}  // namespace gnomon
