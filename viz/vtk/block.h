#pragma once

#include <vtkPointSet.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

#include "gnomon/result.h"
#include "viz/vtk/field_data.h"

namespace gnomon::viz {

/// One leaf of the tree that is written, drawn and read back.
struct Block {
  std::vector<std::string> path;  ///< for instance {"volumes", "lamp", "table", "umbra"}
  std::string kind;               ///< light, blocker, receiver, volume, solid, extremal_planes, region,
                                  ///< boundaries, receiver_faces, receiver_edges, receiver_irradiance or
                                  ///< discontinuities
  Fields fields;                  ///< also in the field data of `data`
  vtkSmartPointer<vtkPointSet> data;

  bool empty() const { return data->GetNumberOfCells() == 0; }
};

/// What is known of a result as a whole: producer, version, scene, length_unit, unbounded, clip_box, and the exact
/// volumes (areas in the plane) of every supported pair, one entry per pair, if there is one.
Fields result_fields(const ShadowResult& result);

/// What every leaf says of the result it belongs to: the first fields of result_fields, with its own `unbounded`.
Fields leaf_fields(const ShadowResult& result, bool unbounded);

/// What the leaf of a light, blocker or receiver says.
Fields element_fields(const ShadowResult& result, const std::string& name, const std::string& shape);

/// What the leaves of a pair say.
Fields pair_fields(const ShadowResult& result, const std::string& light, const std::string& blocker, bool unbounded);

/// Adds a block, and its fields to its data.
void append_block(std::vector<Block>& blocks, Block block);

/// The blocks of lights, blockers and receivers: `scene/...`.
void append_scene_blocks(std::vector<Block>& blocks, const ShadowResult& result);

/// All blocks of a result, empty ones too. Polygons and triangles run counterclockwise seen from outside a volume, or
/// from a polygon's front; points are doubles. A scene of the plane gives planar_shadow_blocks.
std::vector<Block> shadow_blocks(const ShadowResult& result);

/// All blocks of a result of dimension 2, empty ones too, named as in space and lying at z = 0: regions are convex
/// polygons, counterclockwise, in the place of volumes, extremal lines stand for planes, segments are lines. There are
/// no solids.
std::vector<Block> planar_shadow_blocks(const ShadowResult& result);

/// Adds, for every light of a result of dimension 2 that is behind several segments, its regions as triangles and the
/// lines between them: `regions/LIGHT/{lit,penumbra,umbra}` and `boundaries/LIGHT`.
void append_partition_blocks(std::vector<Block>& blocks, const ShadowResult& result);

/// A block's path as one text: "volumes/lamp/table/umbra".
inline std::string joined(const std::vector<std::string>& path) {
  std::string text;
  for (const std::string& part : path) {
    if (!text.empty()) text += '/';
    text += part;
  }
  return text;
}

}  // namespace gnomon::viz
