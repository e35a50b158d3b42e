#include "viz/block.h"

#include <algorithm>

namespace gnomon::viz {
namespace {

bool is_truncated(const PairResult& pair) {
  return pair.supported &&
         (pair.meshes.occlusion.truncated || pair.meshes.umbra.truncated || pair.meshes.penumbra.truncated);
}

/// Names and volumes of the supported pairs, list by list.
struct PairLists {
  std::vector<std::string> lights;
  std::vector<std::string> blockers;
  std::vector<double> totals[3];
  std::vector<std::string> exact_totals[3];
};

PairLists pair_lists(const ShadowResult& result) {
  PairLists lists;
  for (const PairResult& pair : result.pairs) {
    if (!pair.supported) continue;
    lists.lights.push_back(pair.light);
    lists.blockers.push_back(pair.blocker);
    const VolumeMesh* const meshes[] = {&pair.meshes.occlusion, &pair.meshes.umbra, &pair.meshes.penumbra};
    for (int i = 0; i < 3; ++i) {
      lists.totals[i].push_back(meshes[i]->volume.nearest);
      lists.exact_totals[i].push_back(meshes[i]->volume.exact);
    }
  }
  return lists;
}

}  // namespace

Fields leaf_fields(const ShadowResult& result, bool unbounded) {
  const Box3& box = result.clip_box;
  return {{"producer", std::vector<std::string>{"gnomon"}},
          {"version", std::vector<std::string>{GNOMON_VERSION}},
          {"scene", std::vector<std::string>{result.scene->source}},
          {"length_unit", std::vector<std::string>{result.scene->length_unit}},
          {"unbounded", std::vector<std::int32_t>{unbounded ? 1 : 0}},
          {"clip_box", std::vector<double>{box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z}}};
}

Fields result_fields(const ShadowResult& result) {
  Fields fields = leaf_fields(result, std::ranges::any_of(result.pairs, is_truncated));
  PairLists lists = pair_lists(result);
  fields.push_back({"pair_lights", std::move(lists.lights)});
  fields.push_back({"pair_blockers", std::move(lists.blockers)});
  const std::string names[] = {"occlusion", "umbra", "penumbra"};
  for (int i = 0; i < 3; ++i) {
    fields.push_back({names[i] + "_volume_total", std::move(lists.totals[i])});
    fields.push_back({names[i] + "_volume_exact", std::move(lists.exact_totals[i])});
  }
  return fields;
}

void append_block(std::vector<Block>& blocks, Block block) {
  add_field_data(*block.data->GetFieldData(), block.fields);
  blocks.push_back(std::move(block));
}

}  // namespace gnomon::viz
