#include "apps/gnomon/scene_pairs.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <variant>

#include "apps/gnomon/element_choice.h"

namespace gnomon {
namespace {

/// Why nothing is computed for a light of this shape, or empty.
std::string light_reason(const Light& light) {
  if (std::holds_alternative<DirectionalLight>(light)) return "lights of shape direction are not supported yet";
  const auto* area = std::get_if<AreaLight>(&light);
  if (area && !area->polygon.is_flat()) return "lights whose vertices are not exactly coplanar are not supported yet";
  return {};
}

/// Why nothing is computed for a blocker of this shape, or empty.
std::string blocker_reason(const BlockerShape& shape) {
  if (std::holds_alternative<Polytope>(shape)) return "blockers of shape polytope are not supported yet";
  if (std::holds_alternative<ConcavePolygon>(shape)) return "blockers of shape concave_polygon are not supported yet";
  if (std::holds_alternative<Mesh>(shape)) return "blockers of shape mesh are not supported yet";
  if (!std::get<ConvexPolygon>(shape).is_flat()) {
    return "blockers whose vertices are not exactly coplanar are not supported yet";
  }
  return {};
}

std::string position_reason(Position position) {
  if (position == Position::standard) return {};
  return "the position " + std::string(name(position)) + " is not supported yet";
}

void judge(const SceneLight& light, const SceneBlocker& blocker, ScenePair& pair) {
  pair.reason = light_reason(light.shape);
  if (pair.reason.empty()) pair.reason = blocker_reason(blocker.shape);
  if (!pair.reason.empty()) return;
  pair.position = pair_position(light.shape, std::get<ConvexPolygon>(blocker.shape));
  pair.reason = position_reason(*pair.position);
}

planar::Pair planar_pair(const PlanarLight& light, const PlanarBlocker& blocker, std::size_t part) {
  return planar::Pair::from_points(light.vertices, std::span(blocker.vertices).subspan(part, 2));
}

/// In the plane every position is supported.
void judge(const PlanarLight& light, const PlanarBlocker& blocker, ScenePair& pair) {
  pair.position = planar::pair_position(planar_pair(light, blocker, pair.part));
}

std::vector<std::string> part_names(const SceneBlocker& blocker) {
  return {blocker.name};
}

/// A plain segment keeps its name.
std::vector<std::string> part_names(const PlanarBlocker& blocker) {
  if (blocker.vertices.size() == 2) return {blocker.name};
  std::vector<std::string> names;
  for (std::size_t k = 0; k + 1 < blocker.vertices.size(); ++k) names.push_back(blocker.name + '#' + std::to_string(k));
  return names;
}

template <class SomeLight, class SomeBlocker>
void add_pairs(std::vector<ScenePair>& pairs, const SomeLight& light, const SomeBlocker& blocker, ScenePair pair) {
  pair.light = light.name;
  for (const std::string& part : part_names(blocker)) {
    pair.blocker = part;
    judge(light, blocker, pairs.emplace_back(pair));
    ++pair.part;
  }
}

template <class SomeLight, class SomeBlocker>
std::vector<ScenePair> selected_pairs(const std::vector<SomeLight>& lights, const std::vector<SomeBlocker>& blockers,
                                      const PairSelection& selection) {
  require_name("--light", "light", selection.light, lights);
  require_name("--blocker", "blocker", selection.blocker, blockers);
  const auto chosen = [](const std::string& wanted, const std::string& name) {
    return wanted.empty() || wanted == name;
  };
  std::vector<ScenePair> pairs;
  for (std::size_t l = 0; l < lights.size(); ++l) {
    for (std::size_t b = 0; b < blockers.size(); ++b) {
      if (!chosen(selection.light, lights[l].name) || !chosen(selection.blocker, blockers[b].name)) continue;
      add_pairs(pairs, lights[l], blockers[b], {l, b, 0, {}, {}, {}, {}});
    }
  }
  return pairs;
}

}  // namespace

std::vector<ScenePair> scene_pairs(const Scene& scene, const PairSelection& selection) {
  if (scene.dimension == 2) return selected_pairs(scene.planar_lights, scene.planar_blockers, selection);
  return selected_pairs(scene.lights, scene.blockers, selection);
}

planar::Pair planar_pair(const Scene& scene, const ScenePair& pair) {
  return planar_pair(scene.planar_lights[pair.light_index], scene.planar_blockers[pair.blocker_index], pair.part);
}

std::size_t supported_count(const std::vector<ScenePair>& pairs) {
  return static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [](const ScenePair& pair) { return pair.supported(); }));
}

}  // namespace gnomon
