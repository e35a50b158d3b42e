#include "apps/gnomon/shadow_summary.h"

#include <algorithm>
#include <string_view>

#include "apps/gnomon/text.h"

namespace gnomon {
namespace {

/// With more pairs than this, each gets one line.
constexpr std::size_t most_blocks = 3;

std::string position_text(const ScenePair& pair) {
  return pair.position ? std::string(name(*pair.position)) : "-";
}

std::string extent_text(const VolumeFacts& facts) {
  if (facts.empty) return "empty";
  const std::string extent = facts.bounded ? "bounded" : "unbounded";
  return extent + ", " + counted(facts.components, "component");
}

std::string planes_text(const ExtremalPlanes& planes) {
  const std::size_t through_blocker = planes.separating_blocker.size();
  const std::size_t through_light = planes.separating_light.size();
  return std::to_string(through_blocker + through_light) + " separating (" + std::to_string(through_blocker) +
         " through blocker edges, " + std::to_string(through_light) + " through light edges), " +
         std::to_string(planes.supporting_blocker.size()) + " supporting";
}

std::string block(const ScenePair& pair, const PairResult& result, const std::string& unit) {
  const ShadowVolumes& volumes = result.volumes;
  const ShadowMeshes& meshes = result.meshes;
  const auto row = [&unit](std::string label, const VolumeFacts& facts, const VolumeMesh& mesh) {
    return TextRow{std::move(label), extent_text(facts),
                   number_text(mesh.volume.nearest) + ' ' + unit + "^3 in the box"};
  };
  std::string text = pair.light + " / " + pair.blocker + "\n  position   " + position_text(pair) + '\n';
  if (!pair.supported()) return text + "  left out   " + pair.reason + '\n';
  text += "  planes     " + planes_text(volumes.planes) + '\n';
  return text + aligned({row("occlusion", volumes.occlusion_facts, meshes.occlusion),
                         row("umbra", volumes.umbra_facts, meshes.umbra),
                         row("penumbra", volumes.penumbra_facts, meshes.penumbra)},
                        2);
}

TextRow line(const ScenePair& pair, const PairResult& result) {
  TextRow row{pair.light, pair.blocker, position_text(pair)};
  if (!pair.supported()) {
    row.emplace_back("left out");
    return row;
  }
  const auto cell = [](const VolumeFacts& facts, const VolumeMesh& mesh) {
    if (facts.empty) return std::string("empty");
    return number_text(mesh.volume.nearest) + (facts.bounded ? " bounded" : " unbounded");
  };
  const ExtremalPlanes& planes = result.volumes.planes;
  row.push_back(std::to_string(planes.separating_blocker.size() + planes.separating_light.size()) + " + " +
                std::to_string(planes.supporting_blocker.size()));
  row.push_back(cell(result.volumes.occlusion_facts, result.meshes.occlusion));
  row.push_back(cell(result.volumes.umbra_facts, result.meshes.umbra));
  row.push_back(cell(result.volumes.penumbra_facts, result.meshes.penumbra));
  return row;
}

std::string table(const ShadowResult& result, const std::vector<ScenePair>& pairs) {
  std::vector<TextRow> rows{{"light", "blocker", "position", "planes", "occlusion", "umbra", "penumbra"}};
  for (std::size_t i = 0; i < pairs.size(); ++i) rows.push_back(line(pairs[i], result.pairs[i]));
  return aligned(rows, 0) + "\nplanes: separating + supporting; volumes: in the box, in " + result.scene->length_unit +
         "^3\n";
}

}  // namespace

std::string shadow_summary(const ShadowResult& result, const std::vector<ScenePair>& pairs) {
  std::string text = "scene      " + scene_text(*result.scene) + "\nclip box   " + box_text(result.clip_box) + "\n\n";
  if (pairs.size() > most_blocks) return text + table(result, pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i != 0) text += '\n';
    text += block(pairs[i], result.pairs[i], result.scene->length_unit);
  }
  return text;
}

std::string box_text(const Box3& box) {
  const auto range = [](char axis, double min, double max) {
    return std::string(1, axis) + ' ' + number_text(min) + " to " + number_text(max);
  };
  return range('x', box.min.x, box.max.x) + ", " + range('y', box.min.y, box.max.y) + ", " +
         range('z', box.min.z, box.max.z);
}

std::string scene_text(const Scene& scene) {
  const bool planar = scene.dimension == 2;
  const std::size_t lights = planar ? scene.planar_lights.size() : scene.lights.size();
  const std::size_t blockers = planar ? scene.planar_blockers.size() : scene.blockers.size();
  const std::size_t receivers = planar ? scene.planar_receivers.size() : scene.receivers.size();
  return scene.source + ": " + counted(lights, "light") + ", " + counted(blockers, "blocker") + ", " +
         counted(receivers, "receiver") + "; dimension " + std::to_string(scene.dimension) + ", lengths in " +
         scene.length_unit;
}

std::string unsupported_text(const std::vector<ScenePair>& pairs) {
  const std::size_t count = pairs.size() - supported_count(pairs);
  if (count == 0) return {};
  std::string text = std::to_string(count) + " of " + counted(pairs.size(), "pair") + (count == 1 ? " is" : " are") +
                     " not supported:";
  std::size_t room = 20;
  for (const ScenePair& pair : pairs) {
    if (pair.supported()) continue;
    if (room-- == 0) return text + "\n  and more; --json lists them all";
    text += "\n  " + pair.light + " / " + pair.blocker + ": " + pair.reason;
  }
  return text;
}

}  // namespace gnomon
