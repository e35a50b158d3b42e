#include "apps/gnomon/shadow_series.h"

#include <algorithm>
#include <optional>

#include "apps/gnomon/computed_shadows.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/light_path.h"
#include "apps/gnomon/scene_discontinuities.h"
#include "apps/gnomon/scene_pairs.h"
#include "apps/gnomon/shadow_summary.h"
#include "apps/gnomon/text.h"
#include "gnomon/writer.h"

namespace gnomon {
namespace {

/// The light that moves: the one that --light names, or the only one.
std::string moving_light(const Scene& scene, const std::string& light) {
  std::vector<std::string> names;
  const auto add_names = [&](const auto& some) {
    for (const auto& candidate : some.lights) names.push_back(candidate.name);
  };
  std::visit(add_names, scene);
  if (light.empty() && names.size() == 1) return names.front();
  if (light.empty()) {
    throw UsageError("--path moves one light, and the scene has " + std::to_string(names.size()) +
                     "; name it with --light");
  }
  const auto is_part = [&](const std::string& name) { return name != light && is_asked_for(light, name); };
  if (std::ranges::any_of(names, is_part)) {
    throw UnsupportedError("--path: light '" + light + "' is bent and taken as parts, which are not moved together");
  }
  return light;
}

Box3 united(const Box3& a, const Box3& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

/// One box for all times, so that nothing else seems to move.
Box3 common_box(const std::vector<Scene>& scenes, const std::string& box_option) {
  std::optional<Box3> box;
  for (const Scene& scene : scenes) {
    const Box3 next = clip_box(scene, box_option);
    box = box ? united(*box, next) : next;
  }
  return *box;
}

}  // namespace

WrittenSeries write_shadow_series(const Scene& scene, const CommonOptions& options, const std::string& path,
                                  const std::string& out) {
  const std::string light = moving_light(scene, options.light);
  scene_pairs(scene, {light, options.blocker});  // refuses names that there are not
  std::vector<Scene> scenes;
  for (const PathPlace& place : read_light_path(path, dimension(scene))) {
    scenes.push_back(with_light_at(scene, light, place, path));
  }
  const Box3 box = common_box(scenes, options.box);
  SeriesWriter writer(out);
  WrittenSeries written;
  std::size_t pair_count = 0;
  Progress progress("place", scenes.size(),
                    options.quiet ? Progress::Visibility::hidden : Progress::Visibility::automatic);
  for (const Scene& moved : scenes) {
    const std::vector<ScenePair> pairs = scene_pairs(moved, {light, options.blocker});
    pair_count += pairs.size();
    written.unsupported_pairs += pairs.size() - supported_count(pairs);
    ShadowResult result = computed_shadows(moved, pairs, box, {options.threads, false});
    result.receivers = receivers_beside_volumes(moved, {light, {}}, {options.threads, false});
    writer.add(static_cast<double>(written.steps++), result);
    progress.step();
  }
  if (pair_count > 0 && written.unsupported_pairs == pair_count) {
    throw UnsupportedError(facts(scene).source + ": none of the " + counted(pair_count, "pair") + " is supported");
  }
  written.files = writer.publish();
  return written;
}

}  // namespace gnomon
