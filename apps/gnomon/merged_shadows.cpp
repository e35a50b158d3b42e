#include "apps/gnomon/merged_shadows.h"

#include <algorithm>
#include <span>

#include "apps/gnomon/console.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon {
namespace {

/// Pairs of one light.
using PartPairs = std::span<const ScenePair>;

bool can_be_merged(PartPairs parts, Merging merging) {
  const std::size_t least = merging == Merging::each_blocker ? 2 : 1;
  return parts.size() >= least && supported_count({parts.begin(), parts.end()}) == parts.size();
}

std::vector<PartPairs> pairs_to_merge(const std::vector<ScenePair>& pairs, Merging merging) {
  std::vector<PartPairs> result;
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto last = std::find_if(first, pairs.end(), [&](const ScenePair& pair) {
      return pair.light_index != first->light_index ||
             (merging == Merging::each_blocker && pair.blocker_index != first->blocker_index);
    });
    if (can_be_merged({first, last}, merging)) result.emplace_back(first, last);
    first = last;
  }
  return result;
}

MergedResult merged(const SpaceScene& scene, PartPairs pairs, Merging merging, const Box3& clip_box,
                    Progress& progress) {
  std::vector<ConvexBlocker> parts;
  for (const ScenePair& pair : pairs) parts.push_back(pair.shadow->blocker());
  const ScenePair& first = pairs.front();
  OcclusionMerger merger(scene.lights[first.light_index].shape, parts, clip_box);
  while (merger.remaining() > 0) {
    merger.advance();
    progress.step();
  }
  MergedResult result{static_cast<std::uint32_t>(first.light_index), static_cast<std::uint32_t>(first.blocker_index),
                      first.light, scene.blockers[first.blocker_index].name, merger.result()};
  for (const ScenePair& pair : pairs) result.part_names.push_back(pair.blocker);
  if (merging == Merging::each_blocker) return result;
  result.blocker = MergedResult::all_blockers;
  for (const ScenePair& pair : pairs) result.part_blockers.push_back(static_cast<std::uint32_t>(pair.blocker_index));
  return result;
}

}  // namespace

std::vector<MergedResult> merged_shadows(const SpaceScene& scene, const std::vector<ScenePair>& pairs, Merging merging,
                                         const Box3& clip_box, const Effort& effort) {
  const std::vector<PartPairs> groups = pairs_to_merge(pairs, merging);
  std::size_t part_count = 0;
  for (const PartPairs parts : groups) part_count += parts.size();
  Progress progress("merged part", part_count,
                    effort.shows_progress ? Progress::Visibility::automatic : Progress::Visibility::hidden);
  std::vector<MergedResult> result;
  for (const PartPairs parts : groups) result.push_back(merged(scene, parts, merging, clip_box, progress));
  return result;
}

}  // namespace gnomon
