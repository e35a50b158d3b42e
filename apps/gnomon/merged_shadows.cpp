#include "apps/gnomon/merged_shadows.h"

#include <algorithm>
#include <span>

#include "apps/gnomon/console.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon {
namespace {

/// The pairs of one light with all parts of one blocker.
using PartPairs = std::span<const ScenePair>;

bool can_be_merged(PartPairs parts) {
  return parts.size() > 1 && supported_count({parts.begin(), parts.end()}) == parts.size();
}

std::vector<PartPairs> pairs_to_merge(const std::vector<ScenePair>& pairs) {
  std::vector<PartPairs> result;
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto last = std::find_if(first, pairs.end(), [&](const ScenePair& pair) {
      return pair.light_index != first->light_index || pair.blocker_index != first->blocker_index;
    });
    if (can_be_merged({first, last})) result.emplace_back(first, last);
    first = last;
  }
  return result;
}

MergedResult merged(const SpaceScene& scene, PartPairs pairs, const Box3& clip_box, Progress& progress) {
  std::vector<ConvexBlocker> parts;
  for (const ScenePair& pair : pairs) parts.push_back(pair.shadow->blocker());
  const ScenePair& first = pairs.front();
  OcclusionMerger merger(scene.lights[first.light_index].shape, parts, clip_box);
  while (merger.remaining() > 0) {
    merger.advance();
    progress.step();
  }
  return {static_cast<std::uint32_t>(first.light_index), static_cast<std::uint32_t>(first.blocker_index), first.light,
          scene.blockers[first.blocker_index].name, merger.result()};
}

}  // namespace

std::vector<MergedResult> merged_shadows(const SpaceScene& scene, const std::vector<ScenePair>& pairs,
                                         const Box3& clip_box, const Effort& effort) {
  const std::vector<PartPairs> blockers = pairs_to_merge(pairs);
  std::size_t part_count = 0;
  for (const PartPairs parts : blockers) part_count += parts.size();
  Progress progress("merged part", part_count,
                    effort.shows_progress ? Progress::Visibility::automatic : Progress::Visibility::hidden);
  std::vector<MergedResult> result;
  for (const PartPairs parts : blockers) result.push_back(merged(scene, parts, clip_box, progress));
  return result;
}

}  // namespace gnomon
