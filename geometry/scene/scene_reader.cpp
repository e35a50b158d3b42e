#include "geometry/scene/scene_reader.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "geometry/scene/file_text.h"
#include "geometry/scene/json_node.h"
#include "geometry/scene/json_text.h"
#include "geometry/scene/planar_reader.h"
#include "geometry/scene/scene_doubts.h"
#include "geometry/scene/scene_elements.h"
#include "geometry/scene/spatial_reader.h"

namespace gnomon {
namespace {

/// Far more than any scene needs, and little enough to be held in memory some ten times over while it is parsed.
constexpr std::size_t largest_scene_file = std::size_t{64} << 20;

void require_version(const JsonNode& document) {
  const JsonNode version = document.required("gnomon", "the version of the format, 1");
  if (!version.is_number(1)) version.refuse_value("the version of the format, 1");
}

int dimension(const JsonNode& document) {
  const JsonNode node = document.required("dimension", "2 or 3");
  if (!node.is_number(2) && !node.is_number(3)) node.refuse_value("2 or 3");
  return node.is_number(2) ? 2 : 3;
}

std::string length_unit(const JsonNode& document) {
  const auto node = document.optional("length_unit");
  if (!node) return "m";
  std::string unit = node->string("a unit of length (a string), such as \"m\"");
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (unit.empty() || unit.size() > 40 || std::any_of(unit.begin(), unit.end(), is_control)) {
    node->refuse_value("a unit of length of 1 to 40 printable bytes");
  }
  return unit;
}

std::vector<SceneElement> required_elements(const JsonNode& document, std::string_view list) {
  return scene_elements(document.required(list, "an array of " + std::string(list)), list);
}

std::vector<SceneElement> optional_elements(const JsonNode& document, std::string_view list) {
  const auto node = document.optional(list);
  return node ? scene_elements(*node, list) : std::vector<SceneElement>{};
}

Scene read_document(const JsonNode& document, const std::filesystem::path& folder) {
  document.require_object("an object with the keys \"gnomon\", \"dimension\", \"lights\", \"blockers\"");
  require_version(document);
  Scene scene;
  scene.dimension = dimension(document);
  document.allow_keys({"gnomon", "dimension", "length_unit", "lights", "blockers", "receivers"}, "a scene");
  scene.length_unit = length_unit(document);
  const std::vector<SceneElement> lights = required_elements(document, "lights");
  const std::vector<SceneElement> blockers = required_elements(document, "blockers");
  const std::vector<SceneElement> receivers = optional_elements(document, "receivers");
  if (scene.dimension == 2) {
    scene.planar_lights = read_planar_lights(lights);
    scene.planar_blockers = read_planar_chains(blockers);
    scene.planar_receivers = read_planar_chains(receivers);
  } else {
    read_spatial_lights(lights, scene);
    read_spatial_blockers(blockers, folder, scene);
    read_spatial_receivers(receivers, scene);
  }
  return scene;
}

Scene scene_of(const nlohmann::json& document, const std::string& source, const std::filesystem::path& folder) {
  Scene scene = read_document(JsonNode(document, source), folder);
  scene.source = source;
  for (std::string& doubt : scene_doubts(scene)) scene.doubts.push_back(std::move(doubt));
  return scene;
}

/// The text is let go: large scenes need the memory.
nlohmann::json document_in(const std::filesystem::path& file) {
  const FileText text = file_text(file, largest_scene_file);
  if (!text.problem.empty()) throw SceneError(file.string() + ": found " + text.problem + "; expected a scene file");
  return parse_json(text.text, file.string());
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& source, const std::filesystem::path& folder) {
  return scene_of(parse_json(text, source), source, folder);
}

Scene read_scene(const std::filesystem::path& file) {
  return scene_of(document_in(file), file.string(), file.parent_path());
}

}  // namespace gnomon
