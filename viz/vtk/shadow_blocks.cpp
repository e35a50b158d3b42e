#include <algorithm>
#include <span>

#include "viz/vtk/block.h"
#include "viz/vtk/receiver_blocks.h"
#include "viz/vtk/shadow_data.h"

namespace gnomon::viz {
namespace {

/// Of a blocker with more parts than this all parts share the blocks of `vase#parts`: thousands of files would help
/// nobody.
constexpr std::size_t most_parts_of_their_own = 100;

/// Pairs of one light that share their blocks: one, or all parts of a blocker.
using Group = std::span<const PairResult* const>;

std::string blocker_of(const ShadowResult& result, Group group) {
  if (group.size() == 1) return group.front()->blocker;
  return std::get<SpaceScene>(*result.scene).blockers[group.front()->blocker_id].name + "#parts";
}

/// Fields of a volume; where parts share it, the double of every part in the order of `part_id`. The exact numbers of
/// all pairs are in the fields of the whole result.
Fields volume_fields(const ShadowResult& result, Group group, VolumeMesh ShadowMeshes::*volume) {
  bool is_truncated = false;
  std::vector<double> totals;
  std::vector<std::string> exact, names;
  for (const PairResult* pair : group) {
    const VolumeMesh& mesh = pair->meshes.*volume;
    is_truncated = is_truncated || mesh.truncated;
    totals.push_back(mesh.volume.nearest);
    exact.push_back(mesh.volume.exact);
    names.push_back(pair->blocker);
  }
  Fields fields = pair_fields(result, group.front()->light, blocker_of(result, group), is_truncated);
  fields.push_back({"volume_total", std::move(totals)});
  if (group.size() > 1) {
    fields.push_back({"part_names", std::move(names)});
  } else {
    fields.push_back({"volume_exact", std::move(exact)});
  }
  return fields;
}

void append_volumes(std::vector<Block>& blocks, const ShadowResult& result, Group group) {
  const auto append = [&](const std::string& name, VolumeMesh ShadowMeshes::*volume) {
    ShadowSurface surface;
    for (const PairResult* pair : group) surface.add(pair->meshes.*volume, volume_cell(*pair, name));
    append_block(blocks, {{"volumes", group.front()->light, blocker_of(result, group), name},
                          "volume",
                          volume_fields(result, group, volume),
                          surface.data()});
  };
  append("occlusion", &ShadowMeshes::occlusion);
  append("umbra", &ShadowMeshes::umbra);
  append("penumbra", &ShadowMeshes::penumbra);
  const auto is_solid = [](const PairResult* pair) { return pair->is_solid; };
  if (std::ranges::any_of(group, is_solid)) append("umbra_pockets", &ShadowMeshes::umbra_pockets);
}

/// For every `facet_id` the field `facet_part` has the number of the part that the facet comes from.
void append_merged(std::vector<Block>& blocks, const ShadowResult& result, const MergedResult& merged) {
  CellName common;
  common.light_id = static_cast<std::int32_t>(merged.light_id);
  common.blocker_id = static_cast<std::int32_t>(merged.blocker_id);
  const VolumeMesh& mesh = merged.occlusion.mesh;
  std::vector<std::uint32_t> facet_blockers;
  if (!merged.part_blockers.empty()) {
    for (const std::uint32_t part : merged.occlusion.facet_part) {
      facet_blockers.push_back(merged.part_blockers[part]);
    }
  }
  ShadowSurface surface;
  surface.add(mesh, common, facet_blockers);
  Fields fields = pair_fields(result, merged.light, merged.blocker, mesh.truncated);
  fields.push_back({"volume_total", std::vector<double>{mesh.volume.nearest}});
  fields.push_back({"volume_exact", std::vector<std::string>{mesh.volume.exact}});
  const auto& parts = merged.occlusion.facet_part;
  fields.push_back({"facet_part", std::vector<std::int32_t>(parts.begin(), parts.end())});
  fields.push_back({"part_names", merged.part_names});
  append_block(
      blocks,
      {{"volumes", merged.light, merged.blocker, "occlusion_merged"}, "volume", std::move(fields), surface.data()});
}

void append_solids(std::vector<Block>& blocks, const ShadowResult& result, Group group) {
  const auto append = [&](const std::string& name, VolumeMesh ShadowMeshes::*volume, VolumeCells ShadowMeshes::*cells) {
    ShadowSolid solid;
    for (const PairResult* pair : group) solid.add(pair->meshes.*cells, volume_cell(*pair, name));
    append_block(blocks, {{"solids", group.front()->light, blocker_of(result, group), name},
                          "solid",
                          volume_fields(result, group, volume),
                          solid.data()});
  };
  append("umbra", &ShadowMeshes::umbra, &ShadowMeshes::umbra_cells);
  append("penumbra", &ShadowMeshes::penumbra, &ShadowMeshes::penumbra_cells);
}

void append_planes(std::vector<Block>& blocks, const ShadowResult& result, Group group) {
  ShadowSurface surface;
  for (const PairResult* pair : group) surface.add(pair->meshes.extremal_planes, volume_cell(*pair, ""));
  const std::string blocker = blocker_of(result, group);
  append_block(blocks, {{"extremal_planes", group.front()->light, blocker},
                        "extremal_planes",
                        pair_fields(result, group.front()->light, blocker, true),
                        surface.data()});
}

/// The pairs that share blocks, in their order.
std::vector<Group> groups_of(std::span<const PairResult* const> pairs) {
  std::vector<Group> groups;
  for (std::size_t first = 0, last = 0; first < pairs.size(); first = last) {
    const auto same = [&](const PairResult* pair) {
      return pair->light_id == pairs[first]->light_id && pair->blocker_id == pairs[first]->blocker_id;
    };
    while (last < pairs.size() && same(pairs[last])) ++last;
    if (last - first > most_parts_of_their_own) {
      groups.push_back(pairs.subspan(first, last - first));
    } else {
      for (std::size_t i = first; i < last; ++i) groups.push_back(pairs.subspan(i, 1));
    }
  }
  return groups;
}

}  // namespace

std::vector<Block> shadow_blocks(const ShadowResult& result) {
  if (std::holds_alternative<PlaneScene>(*result.scene)) return planar_shadow_blocks(result);
  std::vector<const PairResult*> pairs;
  for (const PairResult& pair : result.pairs) {
    if (pair.supported) pairs.push_back(&pair);
  }
  // Blocks of one light are siblings, in whatever order the pairs come.
  std::ranges::stable_sort(pairs, {}, &PairResult::light_id);
  const std::vector<Group> groups = groups_of(pairs);

  std::vector<Block> blocks;
  append_scene_blocks(blocks, result);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    append_volumes(blocks, result, groups[i]);
    const std::uint32_t light = groups[i].front()->light_id;
    if (i + 1 < groups.size() && groups[i + 1].front()->light_id == light) continue;
    for (const MergedResult& merged : result.merged) {
      if (merged.light_id == light) append_merged(blocks, result, merged);
    }
  }
  for (const auto append : {append_solids, append_planes}) {
    for (const Group group : groups) append(blocks, result, group);
  }
  for (const SideResult side : sides_of(result.receivers)) {
    append_receiver_faces(blocks, result, side, side_drawing(side));
  }
  for (const PaintedReceiver& painted : result.painted) append_painted_receiver(blocks, result, painted);
  return blocks;
}

}  // namespace gnomon::viz
