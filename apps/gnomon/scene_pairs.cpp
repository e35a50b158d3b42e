#include "apps/gnomon/scene_pairs.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <variant>

#include "apps/gnomon/element_choice.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

/// A convex part of a blocker as pairs need it.
struct Part {
  std::string name;
  std::optional<ConvexBlocker> shape;
  std::vector<std::uint32_t> vertices;
};

/// A polygon stays one, with its own edges, where its vertices were rounded off their plane.
std::vector<Part> parts(const SceneBlocker& blocker) {
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker.shape)) return {{blocker.name, *polygon, {}}};
  const bool is_whole = std::holds_alternative<Polytope>(blocker.shape);
  std::vector<Part> result;
  for (ConvexPart& part : convex_parts(blocker, PartsFor::volumes)) {
    result.push_back({std::move(part.name), std::move(part.shape), {}});
    if (!is_whole) result.back().vertices = std::move(part.vertices);
  }
  return result;
}

/// A plain segment keeps its name.
std::vector<Part> parts(const PlanarBlocker& blocker) {
  if (blocker.vertices.size() == 2) return {{blocker.name, std::nullopt, {}}};
  std::vector<Part> result;
  for (std::size_t k = 0; k + 1 < blocker.vertices.size(); ++k) {
    result.push_back({blocker.name + '#' + std::to_string(k), std::nullopt, {}});
  }
  return result;
}

planar::Pair planar_pair(const PlanarLight& light, const PlanarBlocker& blocker, std::size_t part) {
  return planar::Pair::from_points(light.vertices, std::span(blocker.vertices).subspan(part, 2));
}

void judge(const SceneLight& light, const SceneBlocker&, const Part& part, ScenePair& pair) {
  pair.shadow.emplace(light.shape, *part.shape);
  pair.position = pair.shadow->position();
  pair.reason = pair.shadow->refusal();
}

/// In the plane every position is supported.
void judge(const PlanarLight& light, const PlanarBlocker& blocker, const Part&, ScenePair& pair) {
  pair.position = planar::pair_position(planar_pair(light, blocker, pair.part));
}

template <class SomeLight, class SomeBlocker>
void add_pairs(std::vector<ScenePair>& pairs, const SomeLight& light, const SomeBlocker& blocker,
               const std::vector<Part>& parts, ScenePair pair) {
  pair.light = light.name;
  for (const Part& part : parts) {
    pair.blocker = part.name;
    pair.part_vertices = part.vertices;
    judge(light, blocker, part, pairs.emplace_back(pair));
    ++pair.part;
  }
}

template <class SomeLight, class SomeBlocker>
std::vector<ScenePair> selected_pairs(const std::vector<SomeLight>& lights, const std::vector<SomeBlocker>& blockers,
                                      const PairSelection& selection) {
  require_name("--light", "light", selection.light, lights);
  require_name("--blocker", "blocker", selection.blocker, blockers);
  std::vector<std::vector<Part>> parts_of;
  for (const SomeBlocker& blocker : blockers) {
    parts_of.push_back(is_asked_for(selection.blocker, blocker.name) ? parts(blocker) : std::vector<Part>{});
  }
  std::vector<ScenePair> pairs;
  for (std::size_t l = 0; l < lights.size(); ++l) {
    if (!is_asked_for(selection.light, lights[l].name)) continue;
    for (std::size_t b = 0; b < blockers.size(); ++b) {
      ScenePair pair;
      pair.light_index = l;
      pair.blocker_index = b;
      add_pairs(pairs, lights[l], blockers[b], parts_of[b], std::move(pair));
    }
  }
  return pairs;
}

}  // namespace

std::vector<ScenePair> scene_pairs(const Scene& scene, const PairSelection& selection) {
  return std::visit([&](const auto& some) { return selected_pairs(some.lights, some.blockers, selection); }, scene);
}

planar::Pair planar_pair(const PlaneScene& scene, const ScenePair& pair) {
  return planar_pair(scene.lights[pair.light_index], scene.blockers[pair.blocker_index], pair.part);
}

std::size_t supported_count(const std::vector<ScenePair>& pairs) {
  return static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [](const ScenePair& pair) { return pair.supported(); }));
}

}  // namespace gnomon
