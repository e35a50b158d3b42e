#pragma once

#include <vtkPointSet.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

#include "viz/field_data.h"
#include "viz/shadow_result.h"

namespace gnomon::viz {

/// One leaf of the tree that is written, drawn and read back.
struct Block {
  std::vector<std::string> path;  ///< for instance {"volumes", "lamp", "table", "umbra"}
  std::string kind;               ///< light, blocker, receiver, volume, solid or extremal_planes
  Fields fields;                  ///< also in the field data of `data`
  vtkSmartPointer<vtkPointSet> data;

  bool empty() const { return data->GetNumberOfCells() == 0; }
};

/// What is known of a result as a whole: producer, version, scene, length_unit, unbounded, clip_box, and the exact
/// volumes of every supported pair, one entry per pair.
Fields result_fields(const ShadowResult& result);

/// What every leaf says of the result it belongs to: the first fields of result_fields, with its own `unbounded`.
Fields leaf_fields(const ShadowResult& result, bool unbounded);

/// Adds a block, and its fields to its data.
void append_block(std::vector<Block>& blocks, Block block);

/// The blocks of lights, blockers and receivers: `scene/...`.
void append_scene_blocks(std::vector<Block>& blocks, const ShadowResult& result);

/// All blocks of a result, empty ones too. Polygons and triangles run counterclockwise seen from outside a volume, or
/// from a polygon's front; points are doubles.
std::vector<Block> shadow_blocks(const ShadowResult& result);

}  // namespace gnomon::viz
