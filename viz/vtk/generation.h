#pragma once

#include <span>
#include <string>

#include "viz/vtk/block.h"

namespace gnomon::viz {

/// What tells the files of one result from those of another: every leaf carries it in the field array `generation`, and
/// `manifest.json`, which takes its place last, names it. A folder in which a run was stopped half way thus gives
/// itself away.
///
/// Returns: 16 hexadecimal digits that follow from what is written of the scene's elements, the clip box and the
/// version:
///          the same for every result of one scene and box, so that the results of several commands share these leaves.
std::string generation(std::span<const Block> blocks);

/// Writes it into the data of every block.
void mark_generation(std::span<const Block> blocks, const std::string& generation);

/// result_fields, with the generation: what the root of a tree says.
Fields root_fields(const ShadowResult& result, const std::string& generation);

/// What a leaf that has been read says; empty if it says nothing.
std::string generation_of(vtkPointSet& leaf);

}  // namespace gnomon::viz
