#include "apps/gnomon/shadow_summary.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "apps/gnomon/light_groups.h"
#include "apps/gnomon/shadow_extents.h"
#include "apps/gnomon/text.h"
#include "geometry/scene/receiver_facets.h"

namespace gnomon {
namespace {

/// With more pairs than this, each gets one line.
constexpr std::size_t most_blocks = 3;
constexpr std::size_t most_lines = 40;
constexpr std::size_t most_names = 8;

std::string extent_text(const VolumeFacts& facts) {
  if (facts.empty) return "empty";
  const std::string extent = facts.bounded ? "bounded" : "unbounded";
  return extent + ", " + counted(facts.components, "component");
}

/// How the umbra of a solid lies about it.
std::string pockets_text(const ShadowResult& result, std::size_t pair, std::string_view volume) {
  if (result.pairs.empty() || !result.pairs[pair].is_solid || volume != "umbra") return {};
  return ", " + counted(result.pairs[pair].volumes.umbra_pockets, "pocket") + " outside";
}

std::string planes_text(const ExtremalPlanes& planes) {
  const std::size_t through_blocker = planes.separating_blocker.size();
  const std::size_t through_light = planes.separating_light.size();
  return std::to_string(through_blocker + through_light) + " separating (" + std::to_string(through_blocker) +
         " through blocker edges, " + std::to_string(through_light) + " through light edges), " +
         std::to_string(planes.supporting_blocker.size()) + " supporting";
}

/// How many extremal planes or lines hold the pair apart, and how many lie on one side of both.
struct ContactCounts {
  std::size_t separating = 0;
  std::size_t supporting = 0;
};

ContactCounts contact_counts(const ShadowResult& result, std::size_t pair) {
  if (result.planar_pairs.empty()) {
    const ExtremalPlanes& planes = result.pairs[pair].volumes.planes;
    return {planes.separating_blocker.size() + planes.separating_light.size(), planes.supporting_blocker.size()};
  }
  const auto& lines = result.planar_pairs[pair].regions.lines;
  const auto separating = std::ranges::count(lines, Contact::separating, &planar::ExtremalLine::contact);
  return {static_cast<std::size_t>(separating), lines.size() - static_cast<std::size_t>(separating)};
}

TextRow extremal_row(const ShadowResult& result, std::size_t pair) {
  if (result.planar_pairs.empty()) return {"planes", planes_text(result.pairs[pair].volumes.planes)};
  const ContactCounts counts = contact_counts(result, pair);
  return {"lines",
          std::to_string(counts.separating) + " separating, " + std::to_string(counts.supporting) + " supporting"};
}

/// The unit of volumes, or of areas in the plane.
std::string size_unit(const Scene& scene) {
  return facts(scene).length_unit + '^' + std::to_string(dimension(scene));
}

std::string block(const ScenePair& pair, const ShadowResult& result, std::size_t index) {
  std::string text =
      pair.light + " / " + pair.blocker + '\n' + labelled("position", std::string(name(pair.position)), 2);
  if (!pair.supported()) return text + labelled("left out", pair.reason, 2);
  const TextRow extremal = extremal_row(result, index);
  text += labelled(extremal[0], extremal[1], 2);
  std::vector<TextRow> rows;
  for (const ShadowExtent& extent : shadow_extents(result, index)) {
    rows.push_back({std::string(extent.name), extent_text(extent.facts) + pockets_text(result, index, extent.name),
                    rounded_text(extent.size_in_box) + ' ' + size_unit(*result.scene) + " in the box"});
  }
  return text + aligned(rows, 2);
}

/// What stands in a table for a volume: unbounded ones have a star.
std::string size_text(const ShadowExtent& extent) {
  if (extent.facts.empty) return "empty";
  return rounded_text(extent.size_in_box) + (extent.facts.bounded ? "" : " *");
}

TextRow line(const ScenePair& pair, const ShadowResult& result, std::size_t index) {
  TextRow row{pair.light, pair.blocker};
  if (!pair.supported()) {
    row.emplace_back("left out");
  } else {
    const ContactCounts counts = contact_counts(result, index);
    row.push_back(std::to_string(counts.separating) + " + " + std::to_string(counts.supporting));
    for (const ShadowExtent& extent : shadow_extents(result, index)) row.push_back(size_text(extent));
  }
  return row;
}

/// Which pairs are in which position; nothing of the standard one.
std::string positions_text(const std::vector<ScenePair>& pairs) {
  std::map<std::string_view, std::vector<const ScenePair*>> others;
  for (const ScenePair& pair : pairs) {
    if (pair.position != Position::standard) others[name(pair.position)].push_back(&pair);
  }
  if (others.empty()) return "position: standard\n";
  std::string text = "position: standard, but\n";
  for (const auto& [position, of_it] : others) {
    std::string list = "  " + std::string(position) + ": ";
    const std::size_t shown = std::min(most_names, of_it.size());
    for (std::size_t k = 0; k < shown; ++k) list += (k == 0 ? "" : ", ") + of_it[k]->light + " / " + of_it[k]->blocker;
    if (shown < of_it.size()) list += " and " + std::to_string(of_it.size() - shown) + " more";
    text += in_columns(list);
  }
  return text;
}

std::string table(const ShadowResult& result, const std::vector<ScenePair>& pairs) {
  const bool planar = !result.planar_pairs.empty();
  const std::string extremal = planar ? "lines" : "planes";
  std::vector<TextRow> rows{{"light", "blocker", extremal, "occlusion", "umbra", "penumbra"}};
  const std::size_t shown = std::min(most_lines, pairs.size());
  for (std::size_t i = 0; i < shown; ++i) rows.push_back(line(pairs[i], result, i));
  const std::string others =
      shown == pairs.size() ? "" : "and " + std::to_string(pairs.size() - shown) + " more; --json lists them all\n";
  return aligned(rows, 0) + others + '\n' +
         in_columns(extremal + ": separating + supporting; " + (planar ? "areas" : "volumes") + ": in the box, in " +
                    size_unit(*result.scene) + ", * unbounded") +
         positions_text(pairs);
}

/// Every light behind all of its blockers together.
std::string together_text(const ShadowResult& result) {
  std::string text;
  for (const PlanarLightResult& light : result.planar_lights) {
    text += '\n' + light.light + " / all " + counted(light.blockers.size(), "segment") + " together\n";
    std::vector<TextRow> rows;
    for (const Region region : {Region::lit, Region::penumbra, Region::umbra}) {
      rows.push_back(
          {std::string(name(region)), counted(light.partition.count(region), "component"),
           rounded_text(light.in_box.area(region).nearest) + ' ' + size_unit(*result.scene) + " in the box"});
    }
    text += aligned(rows, 2);
  }
  return text;
}

}  // namespace

std::string shadow_summary(const ShadowResult& result, const std::vector<ScenePair>& pairs) {
  std::string text = labelled("scene", scene_text(*result.scene)) +
                     labelled("clip box", box_text(result.clip_box, dimension(*result.scene))) + '\n';
  if (pairs.size() > most_blocks) return text + table(result, pairs) + together_text(result);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i != 0) text += '\n';
    text += block(pairs[i], result, i);
  }
  return text + together_text(result);
}

std::string box_text(const Box3& box, int dimension) {
  const auto range = [](char axis, double min, double max) {
    return std::string(1, axis) + ' ' + rounded_text(min) + " to " + rounded_text(max);
  };
  const std::string text = range('x', box.min.x, box.max.x) + ", " + range('y', box.min.y, box.max.y);
  return dimension == 2 ? text : text + ", " + range('z', box.min.z, box.max.z);
}

std::string lights_and_blockers(const Scene& scene) {
  const auto* space = std::get_if<SpaceScene>(&scene);
  const std::size_t lights = space ? chosen_groups(*space, "").size() : std::get<PlaneScene>(scene).lights.size();
  const std::size_t blockers = std::visit([](const auto& some) { return some.blockers.size(); }, scene);
  return counted(lights, "light") + ", " + counted(blockers, "blocker");
}

std::string scene_text(const Scene& scene) {
  const auto* space = std::get_if<SpaceScene>(&scene);
  const std::size_t receivers =
      space ? receiver_elements(space->receivers).size() : std::get<PlaneScene>(scene).receivers.size();
  return facts(scene).source + ": " + lights_and_blockers(scene) + ", " + counted(receivers, "receiver") +
         "; dimension " + std::to_string(dimension(scene)) + ", lengths in " + facts(scene).length_unit;
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
