#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/recognised_elements.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/scene_pairs.h"
#include "apps/gnomon/shadow_json.h"
#include "apps/gnomon/shadow_summary.h"
#include "apps/gnomon/text.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

Json elements_json(const std::vector<RecognisedElement>& elements) {
  Json list = Json::array();
  for (const RecognisedElement& element : elements) {
    Json json = {{"name", element.name}, {"shape", element.shape}};
    if (element.vertices) json["vertices"] = *element.vertices;
    if (element.holes) json["holes"] = *element.holes;
    if (element.facets) json["facets"] = *element.facets;
    if (element.closed) json["closed"] = *element.closed;
    if (element.two_sided) json["two_sided"] = *element.two_sided;
    if (element.strength) {
      json[element.strength->quantity] = element.strength->value;
      json["unit"] = element.strength->unit;
    }
    if (element.flux) json["flux"] = *element.flux;
    list.push_back(std::move(json));
  }
  return list;
}

Json check_json(const Scene& scene, const RecognisedElements& elements, const std::vector<ScenePair>& pairs) {
  Json json = {{"schema", "gnomon/check/1"},
               {"scene", facts(scene).source},
               {"dimension", dimension(scene)},
               {"length_unit", facts(scene).length_unit}};
  const std::optional<Box3> box = default_clip_box(scene);
  json["clip_box"] = box ? box_json(*box, dimension(scene)) : Json();
  json["lights"] = elements_json(elements.lights);
  json["blockers"] = elements_json(elements.blockers);
  json["receivers"] = elements_json(elements.receivers);
  json["doubts"] = facts(scene).doubts;
  json["pairs"] = Json::array();
  for (const ScenePair& pair : pairs) json["pairs"].push_back(pair_json(pair));
  return json;
}

TextRow element_row(const RecognisedElement& element) {
  std::string counts;
  if (element.vertices) counts = std::to_string(*element.vertices) + (*element.vertices == 1 ? " vertex" : " vertices");
  if (element.holes) counts += ", " + counted(*element.holes, "hole");
  if (element.facets) counts += (counts.empty() ? "" : ", ") + counted(*element.facets, "facet");
  if (element.closed) counts += *element.closed ? ", closed" : ", open";
  TextRow row{element.name, element.shape, counts};
  if (element.two_sided) row.back() += *element.two_sided ? ", two-sided" : ", one-sided";
  if (element.strength) {
    // The last column is broken between words where it is too wide; numbers elsewhere might lose digits.
    row.push_back(element.strength->quantity + ' ' + rounded_text(element.strength->value) + ' ' +
                  element.strength->unit);
    if (element.flux) row.back() += ", flux " + rounded_text(*element.flux) + " W";
  }
  return row;
}

std::string section(const std::string& title, const std::vector<TextRow>& rows) {
  return rows.empty() ? std::string() : title + '\n' + aligned(rows, 2);
}

std::string section(const std::string& title, const std::vector<RecognisedElement>& elements) {
  std::vector<TextRow> rows;
  rows.reserve(elements.size());
  for (const RecognisedElement& element : elements) rows.push_back(element_row(element));
  return section(title, rows);
}

/// The pairs that get a line: those that are not supported before the others, in file order, and not too many.
std::vector<const ScenePair*> shown_pairs(const std::vector<ScenePair>& pairs) {
  constexpr std::size_t most_lines = 20;
  std::vector<const ScenePair*> shown;
  for (const ScenePair& pair : pairs) shown.push_back(&pair);
  std::ranges::stable_sort(shown, {}, [](const ScenePair* pair) { return pair->supported(); });
  if (shown.size() > most_lines) shown.resize(most_lines);
  std::ranges::sort(shown);  // all are of one list
  return shown;
}

std::string pairs_text(const std::vector<ScenePair>& pairs) {
  std::vector<TextRow> rows;
  for (const ScenePair* pair : shown_pairs(pairs)) {
    rows.push_back({pair->light, pair->blocker, std::string(name(pair->position)),
                    pair->supported() ? "supported" : pair->reason});
  }
  std::string text = section(
      "pairs, " + std::to_string(supported_count(pairs)) + " of " + std::to_string(pairs.size()) + " supported", rows);
  if (rows.size() < pairs.size()) {
    text += "  and " + std::to_string(pairs.size() - rows.size()) + " more; --json FILE lists them all\n";
  }
  return text;
}

std::string check_text(const Scene& scene, const RecognisedElements& elements, const std::vector<ScenePair>& pairs) {
  std::string text = in_columns(scene_text(scene));
  if (const auto box = default_clip_box(scene)) {
    text += in_columns("default clip box: " + box_text(*box, dimension(scene)));
  }
  text += section("lights", elements.lights) + section("blockers", elements.blockers) +
          section("receivers", elements.receivers) + pairs_text(pairs);
  text += facts(scene).doubts.empty() ? "no doubts\n" : "doubts\n";
  for (const std::string& doubt : facts(scene).doubts) text += in_columns("  " + doubt);
  return text;
}

}  // namespace

ExitCode check_command(Arguments arguments) {
  CommandLine app("Validates a scene file and prints what was recognised, every doubt, and every pair's position.",
                  "gnomon check");
  CommonOptions options;
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_json_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "The flux of a light is what it emits in all directions, off by less than 1e-12 of itself.\n\n"
      "Examples:\n"
      "  gnomon check examples/figure_4_22.scene.json\n"
      "  gnomon check examples/cornell_box.scene.json --json -\n");
  if (!app.parse(arguments)) return ExitCode::done;

  require_place("--json", options.json, OutputKind::json);
  require_unread("--json", options.json, {options.scene});
  const Scene scene = scene_file(options.scene);
  if (options.quiet) print_doubts(scene);
  const RecognisedElements elements = recognised_elements(scene);
  const std::vector<ScenePair> pairs = scene_pairs(scene, {});
  if (!options.json.empty()) write_json(check_json(scene, elements, pairs), options.json);
  if (!options.quiet && options.json != "-") std::cout << check_text(scene, elements, pairs);
  return ExitCode::done;
}

}  // namespace gnomon
