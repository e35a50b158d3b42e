#include "viz/vtk/block.h"

#include <algorithm>
#include <array>

namespace gnomon::viz {
namespace {

bool is_truncated(const PairResult& pair) {
  return pair.supported &&
         (pair.meshes.occlusion.truncated || pair.meshes.umbra.truncated || pair.meshes.penumbra.truncated);
}

bool is_truncated_in_plane(const PlanarPairResult& pair) {
  return pair.in_box.occlusion.truncated || pair.in_box.umbra.truncated || pair.in_box.penumbra.truncated;
}

/// Names and volumes of the supported pairs, list by list.
struct PairLists {
  std::vector<std::string> lights;
  std::vector<std::string> blockers;
  std::vector<double> totals[3];
  std::vector<std::string> exact_totals[3];

  void add(const std::string& light, const std::string& blocker, const std::array<const ExactNumber*, 3>& sizes) {
    lights.push_back(light);
    blockers.push_back(blocker);
    for (std::size_t i = 0; i < 3; ++i) {
      totals[i].push_back(sizes[i]->nearest);
      exact_totals[i].push_back(sizes[i]->exact);
    }
  }
};

PairLists pair_lists(const ShadowResult& result) {
  PairLists lists;
  for (const PairResult& pair : result.pairs) {
    const ShadowMeshes& meshes = pair.meshes;
    if (!pair.supported) continue;
    lists.add(pair.light, pair.blocker, {&meshes.occlusion.volume, &meshes.umbra.volume, &meshes.penumbra.volume});
  }
  for (const PlanarPairResult& pair : result.planar_pairs) {
    const planar::ShadowRegionsInBox& regions = pair.in_box;
    lists.add(pair.light, pair.blocker, {&regions.occlusion.area, &regions.umbra.area, &regions.penumbra.area});
  }
  return lists;
}

}  // namespace

Fields leaf_fields(const ShadowResult& result, bool unbounded) {
  const Box3& box = result.clip_box;
  return {{"producer", std::vector<std::string>{"gnomon"}},
          {"version", std::vector<std::string>{GNOMON_VERSION}},
          {"scene", std::vector<std::string>{facts(*result.scene).source}},
          {"length_unit", std::vector<std::string>{facts(*result.scene).length_unit}},
          {"unbounded", std::vector<std::int32_t>{unbounded ? 1 : 0}},
          {"clip_box", std::vector<double>{box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z}}};
}

Fields result_fields(const ShadowResult& result) {
  const bool unbounded = std::ranges::any_of(result.pairs, is_truncated) ||
                         std::ranges::any_of(result.planar_pairs, is_truncated_in_plane);
  Fields fields = leaf_fields(result, unbounded);
  PairLists lists = pair_lists(result);
  if (lists.lights.empty()) return fields;
  fields.push_back({"pair_lights", std::move(lists.lights)});
  fields.push_back({"pair_blockers", std::move(lists.blockers)});
  const std::string names[] = {"occlusion", "umbra", "penumbra"};
  for (int i = 0; i < 3; ++i) {
    fields.push_back({names[i] + "_volume_total", std::move(lists.totals[i])});
    fields.push_back({names[i] + "_volume_exact", std::move(lists.exact_totals[i])});
  }
  return fields;
}

Fields element_fields(const ShadowResult& result, const std::string& name, const std::string& shape) {
  Fields fields = leaf_fields(result, false);
  fields.push_back({"name", std::vector<std::string>{name}});
  fields.push_back({"shape", std::vector<std::string>{shape}});
  return fields;
}

Fields pair_fields(const ShadowResult& result, const std::string& light, const std::string& blocker, bool unbounded) {
  Fields fields = leaf_fields(result, unbounded);
  fields.push_back({"light", std::vector<std::string>{light}});
  fields.push_back({"blocker", std::vector<std::string>{blocker}});
  return fields;
}

void append_block(std::vector<Block>& blocks, Block block) {
  add_field_data(*block.data->GetFieldData(), block.fields);
  blocks.push_back(std::move(block));
}

}  // namespace gnomon::viz
