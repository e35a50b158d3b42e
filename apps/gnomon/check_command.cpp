#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
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
    list.push_back(std::move(json));
  }
  return list;
}

Json check_json(const Scene& scene, const RecognisedElements& elements, const std::vector<ScenePair>& pairs) {
  Json json = {{"schema", "gnomon/check/1"},
               {"scene", scene.source},
               {"dimension", scene.dimension},
               {"length_unit", scene.length_unit}};
  const std::optional<Box3> box = default_clip_box(scene);
  json["clip_box"] = box ? box_json(*box, scene.dimension) : Json();
  json["lights"] = elements_json(elements.lights);
  json["blockers"] = elements_json(elements.blockers);
  json["receivers"] = elements_json(elements.receivers);
  json["doubts"] = scene.doubts;
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
    row.push_back(element.strength->quantity + ' ' + rounded_text(element.strength->value) + ' ' +
                  element.strength->unit);
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

std::string check_text(const Scene& scene, const RecognisedElements& elements, const std::vector<ScenePair>& pairs) {
  std::string text = scene_text(scene) + '\n';
  if (const auto box = default_clip_box(scene)) text += "default clip box: " + box_text(*box, scene.dimension) + '\n';
  text += section("lights", elements.lights) + section("blockers", elements.blockers) +
          section("receivers", elements.receivers);
  std::vector<TextRow> rows;
  rows.reserve(pairs.size());
  for (const ScenePair& pair : pairs) {
    rows.push_back(
        {pair.light, pair.blocker, std::string(name(pair.position)), pair.supported() ? "supported" : pair.reason});
  }
  text += section(
      "pairs, " + std::to_string(supported_count(pairs)) + " of " + std::to_string(pairs.size()) + " supported", rows);
  text += scene.doubts.empty() ? "no doubts\n" : "doubts\n";
  for (const std::string& doubt : scene.doubts) text += "  " + doubt + '\n';
  return text;
}

}  // namespace

ExitCode check_command(Arguments arguments) {
  CLI::App app("Validates a scene file and prints what was recognised, every doubt, and every pair's position.",
               "gnomon check");
  CommonOptions options;
  add_text(app, "SCENE", options.scene, "FILE", "Scene file")->required();
  add_json_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Examples:\n"
      "  gnomon check examples/figure_4_22.scene.json\n"
      "  gnomon check examples/cornell_box.scene.json --json -\n");
  if (!parse_arguments(app, arguments)) return ExitCode::done;

  const Scene scene = scene_file(options.scene);
  if (options.quiet) print_doubts(scene);
  const RecognisedElements elements = recognised_elements(scene);
  const std::vector<ScenePair> pairs = scene_pairs(scene, {});
  if (!options.json.empty()) write_json(check_json(scene, elements, pairs), options.json);
  if (!options.quiet && options.json != "-") std::cout << check_text(scene, elements, pairs);
  return ExitCode::done;
}

}  // namespace gnomon
