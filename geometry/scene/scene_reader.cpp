#include "gnomon/scene.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "geometry/scene/camera_reader.h"
#include "geometry/scene/file_text.h"
#include "geometry/scene/json_node.h"
#include "geometry/scene/json_text.h"
#include "geometry/scene/planar_reader.h"
#include "geometry/scene/scene_doubts.h"
#include "geometry/scene/scene_elements.h"
#include "geometry/scene/spatial_reader.h"
#include "geometry/scene/surface_reader.h"
#include "gnomon/point.h"

namespace gnomon {
namespace {

/// Far more than any scene needs, and little enough to be held in memory some ten times over while it is parsed.
constexpr std::size_t largest_scene_file = std::size_t{64} << 20;

void require_version(const JsonNode& document) {
  const JsonNode version = document.required("gnomon", "the version of the format, 1");
  if (!version.is_number(1)) version.refuse_value("the version of the format, 1");
}

bool is_planar(const JsonNode& document) {
  const JsonNode node = document.required("dimension", "2 or 3");
  if (!node.is_number(2) && !node.is_number(3)) node.refuse_value("2 or 3");
  return node.is_number(2);
}

std::string length_unit(const JsonNode& document) {
  const auto node = document.optional("length_unit");
  if (!node) return "m";
  std::string expected;
  for (const LengthUnit& unit : length_units) {
    expected += (expected.empty() ? "\"" : ", \"") + std::string(unit.name) + '"';
  }
  expected = "a unit of length among " + expected;
  const std::string unit = node->string(expected);
  if (!length_unit_named(unit)) node->refuse_value(expected);
  return unit;
}

/// Pictures of the plane lie as they are, so the key is none of theirs.
UpAxis up_axis(const JsonNode& document) {
  constexpr const char* expected = "\"z\" or \"y\", the axis that points up in pictures";
  const auto node = document.optional("up");
  if (!node) return UpAxis::z;
  const std::string axis = node->string(expected);
  if (axis != "z" && axis != "y") node->refuse_value(expected);
  return axis == "z" ? UpAxis::z : UpAxis::y;
}

std::vector<SceneElement> required_elements(const JsonNode& document, std::string_view list) {
  return scene_elements(document.required(list, "an array of " + std::string(list)), list);
}

std::vector<SceneElement> optional_elements(const JsonNode& document, std::string_view list) {
  const auto node = document.optional(list);
  return node ? scene_elements(*node, list) : std::vector<SceneElement>{};
}

/// The lists of a scene, their names checked.
struct SceneLists {
  std::vector<SceneElement> lights, blockers, receivers;

  explicit SceneLists(const JsonNode& document)
      : lights(required_elements(document, "lights")),
        blockers(required_elements(document, "blockers")),
        receivers(optional_elements(document, "receivers")) {}
};

PlaneScene plane_scene(const JsonNode& document) {
  document.allow_keys({"$schema", "gnomon", "dimension", "length_unit", "lights", "blockers", "receivers"},
                      "a scene of the plane");
  PlaneScene scene;
  scene.length_unit = length_unit(document);
  const SceneLists lists(document);
  scene.lights = read_planar_lights(lists.lights);
  scene.blockers = read_planar_chains(lists.blockers);
  scene.receivers = read_planar_chains(lists.receivers);
  return scene;
}

SpaceScene space_scene(const JsonNode& document, const std::filesystem::path& folder) {
  document.allow_keys({"$schema", "gnomon", "dimension", "length_unit", "up", "ambient_radiance", "materials", "camera",
                       "lights", "blockers", "receivers"},
                      "a scene");
  SpaceScene scene;
  scene.up = up_axis(document);
  read_materials(document, scene);
  scene.camera = read_camera(document, scene.up);
  scene.length_unit = length_unit(document);
  const SceneLists lists(document);
  read_spatial_lights(lists.lights, folder, scene);
  read_spatial_blockers(lists.blockers, folder, scene);
  read_spatial_receivers(lists.receivers, folder, scene);
  return scene;
}

Scene read_document(const JsonNode& document, const std::filesystem::path& folder) {
  document.require_object("an object with the keys \"gnomon\", \"dimension\", \"lights\", \"blockers\"");
  require_version(document);
  if (const auto schema = document.optional("$schema")) schema->string("the address of a JSON Schema (a string)");
  if (is_planar(document)) return plane_scene(document);
  return space_scene(document, folder);
}

/// A document and whether its text began with a byte-order mark, which the parser passes over.
struct SceneText {
  nlohmann::json document;
  bool has_mark = false;
};

SceneText parsed(std::string_view text, const std::string& source) {
  return {parse_json(text, source), text.starts_with("\xef\xbb\xbf")};
}

Scene scene_of(const SceneText& text, const std::string& source, const std::filesystem::path& folder) {
  Scene scene = read_document(JsonNode(text.document, source), folder);
  std::vector<std::string> doubts = std::visit([](const auto& some) { return scene_doubts(some); }, scene);
  std::vector<std::string> of_lighting = std::visit([](const auto& some) { return lighting_doubts(some); }, scene);
  std::visit(
      [&](SceneFacts& facts) {
        facts.source = source;
        if (text.has_mark) facts.doubts.emplace_back("the file begins with a byte-order mark, which is passed over");
        std::ranges::move(doubts, std::back_inserter(facts.doubts));
        facts.lighting_doubts = of_lighting.size();
        std::ranges::move(of_lighting, std::back_inserter(facts.doubts));
      },
      scene);
  return scene;
}

/// The text is let go: large scenes need the memory.
SceneText text_in(const std::filesystem::path& file) {
  const FileText text = file_text(file, largest_scene_file);
  if (!text.problem.empty()) throw SceneError(file.string() + ": found " + text.problem + "; expected a scene file");
  return parsed(text.text, file.string());
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& source, const std::filesystem::path& folder) {
  return scene_of(parsed(text, source), source, folder);
}

Scene read_scene(const std::filesystem::path& file) {
  return scene_of(text_in(file), file.string(), file.parent_path());
}

}  // namespace gnomon
