#include "apps/gnomon/computed_shadows.h"

#include <algorithm>
#include <span>
#include <variant>

#include "apps/gnomon/console.h"
#include "geometry/parallel.h"

namespace gnomon {
namespace {

PairResult computed(const ScenePair& pair, const Box3& clip_box) {
  PairResult result;
  result.light_id = static_cast<std::uint32_t>(pair.light_index);
  result.blocker_id = static_cast<std::uint32_t>(pair.blocker_index);
  result.light = pair.light;
  result.blocker = pair.blocker;
  result.position = pair.position;
  result.supported = pair.supported();
  if (!result.supported) return result;
  result.is_solid = std::holds_alternative<ConvexSolid>(pair.shadow->blocker());
  result.volumes = pair.shadow->volumes();
  result.meshes = pair.shadow->meshes(clip_box);
  return result;
}

PlanarPairResult computed_in_plane(const PlaneScene& scene, const ScenePair& pair, const Box3& clip_box) {
  planar::ShadowRegions regions = planar::shadow_regions(planar_pair(scene, pair));
  const Box2 box{{clip_box.min.x, clip_box.min.y}, {clip_box.max.x, clip_box.max.y}};
  planar::ShadowRegionsInBox in_box = planar::regions_in_box(regions, box);
  return {static_cast<std::uint32_t>(pair.light_index),
          static_cast<std::uint32_t>(pair.blocker_index),
          pair.light,
          pair.blocker,
          pair.position,
          std::move(regions),
          std::move(in_box)};
}

/// The pairs of one light as one light behind all of their segments.
PlanarLightResult computed_together(const PlaneScene& scene, std::span<const ScenePair> pairs, const Box3& clip_box) {
  std::vector<planar::BlockerSegment> segments;
  std::vector<std::string> names;
  std::vector<std::uint32_t> ids;
  for (const ScenePair& pair : pairs) {
    segments.push_back(planar_pair(scene, pair).blocker());
    names.push_back(pair.blocker);
    ids.push_back(static_cast<std::uint32_t>(pair.blocker_index));
  }
  const std::size_t light = pairs.front().light_index;
  const planar::LightVisibility visibility(planar::Flatland::from_points(scene.lights[light].vertices, segments));
  const Box2 box{{clip_box.min.x, clip_box.min.y}, {clip_box.max.x, clip_box.max.y}};
  planar::Partition partition = planar::partition(visibility, {planar::Fineness::regions, box});
  planar::PartitionInBox in_box = planar::partition_in_box(partition);
  return {static_cast<std::uint32_t>(light),
          pairs.front().light,
          std::move(names),
          std::move(ids),
          std::move(partition),
          std::move(in_box)};
}

/// One result for every light that is behind more than one segment.
std::vector<PlanarLightResult> computed_together(const PlaneScene& scene, const std::vector<ScenePair>& pairs,
                                                 const Box3& clip_box) {
  std::vector<PlanarLightResult> results;
  for (std::size_t first = 0; first < pairs.size();) {
    std::size_t last = first;
    while (last < pairs.size() && pairs[last].light_index == pairs[first].light_index) ++last;
    const auto own = std::span(pairs).subspan(first, last - first);
    if (own.size() > 1) results.push_back(computed_together(scene, own, clip_box));
    first = last;
  }
  return results;
}

/// Segments are quick: helpers would cost more than they save.
ShadowResult computed_in_plane(const Scene& scene, const std::vector<ScenePair>& pairs, const Box3& clip_box,
                               Progress& progress) {
  ShadowResult result{&scene, clip_box, {}};
  const auto& plane = std::get<PlaneScene>(scene);
  for (const ScenePair& pair : pairs) {
    result.planar_pairs.push_back(computed_in_plane(plane, pair, clip_box));
    progress.step();
  }
  result.planar_lights = computed_together(plane, pairs, clip_box);
  return result;
}

}  // namespace

ShadowResult computed_shadows(const Scene& scene, const std::vector<ScenePair>& pairs, const Box3& clip_box,
                              const Effort& effort) {
  using enum Progress::Visibility;
  Progress progress("pair", pairs.size(), effort.shows_progress ? automatic : hidden);
  if (std::holds_alternative<PlaneScene>(scene)) return computed_in_plane(scene, pairs, clip_box, progress);
  ShadowResult result{&scene, clip_box, std::vector<PairResult>(pairs.size())};
  for_all(pairs.size(), thread_count(effort.threads), [&](std::size_t i, std::size_t) {
    result.pairs[i] = computed(pairs[i], clip_box);
    progress.step();
  });
  return result;
}

}  // namespace gnomon
