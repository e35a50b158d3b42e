#include "apps/gnomon/computed_shadows.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <variant>

#include "apps/gnomon/console.h"

namespace gnomon {
namespace {

PairResult computed(const Scene& scene, const ScenePair& pair, const Box3& clip_box) {
  PairResult result;
  result.light_id = static_cast<std::uint32_t>(pair.light_index);
  result.blocker_id = static_cast<std::uint32_t>(pair.blocker_index);
  result.light = pair.light;
  result.blocker = pair.blocker;
  result.position = pair.position;
  result.supported = pair.supported();
  if (!result.supported) return result;
  const Light& light = scene.lights[pair.light_index].shape;
  result.is_solid = std::holds_alternative<ConvexSolid>(*pair.shape);
  result.volumes = shadow_volumes(light, *pair.shape);
  result.meshes = shadow_meshes(light, *pair.shape, clip_box);
  return result;
}

PlanarPairResult computed_in_plane(const Scene& scene, const ScenePair& pair, const Box3& clip_box) {
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

/// Segments are quick: helpers would cost more than they save.
ShadowResult computed_in_plane(const Scene& scene, const std::vector<ScenePair>& pairs, const Box3& clip_box,
                               Progress& progress) {
  ShadowResult result{&scene, clip_box, {}};
  for (const ScenePair& pair : pairs) {
    result.planar_pairs.push_back(computed_in_plane(scene, pair, clip_box));
    progress.step();
  }
  return result;
}

}  // namespace

ShadowResult computed_shadows(const Scene& scene, const std::vector<ScenePair>& pairs, const Box3& clip_box,
                              const Effort& effort) {
  using enum Progress::Visibility;
  Progress progress("pair", pairs.size(), effort.shows_progress ? automatic : hidden);
  if (scene.dimension == 2) return computed_in_plane(scene, pairs, clip_box, progress);
  ShadowResult result{&scene, clip_box, std::vector<PairResult>(pairs.size())};
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < pairs.size(); i = next++) {
      result.pairs[i] = computed(scene, pairs[i], clip_box);
      progress.step();
    }
  };
  const unsigned threads = effort.threads ? effort.threads : std::max(1U, std::thread::hardware_concurrency());
  // Helpers beside this thread; a future hands on what its helper throws.
  std::vector<std::future<void>> helpers;
  const std::size_t helper_count = std::min<std::size_t>(threads, pairs.size());
  for (std::size_t i = 1; i < helper_count; ++i) helpers.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& helper : helpers) helper.get();
  return result;
}

}  // namespace gnomon
