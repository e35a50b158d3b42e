#include "apps/gnomon/scene_input.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "apps/gnomon/console.h"
#include "apps/gnomon/text.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

bool is_mesh_file(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 8> mesh_endings = {".obj", ".off", ".ply", ".stl",
                                                            ".OBJ", ".OFF", ".PLY", ".STL"};
  return std::ranges::find(mesh_endings, file.extension().string()) != mesh_endings.end();
}

/// A scene of a mesh under a sun, over a floor where a place for it is known.
std::string scene_around(const std::string& mesh, const std::optional<Box3>& box) {
  std::string text = R"({ "gnomon": 1, "dimension": 3, "length_unit": "m",
  "lights": [ { "name": "sun", "shape": "direction", "direction": [0.5, 0.25, -1] } ],
  "blockers": [ { "name": "mesh", "shape": "mesh", "file": )" +
                     nlohmann::json(mesh).dump() + " } ]";
  if (box) {
    const auto corner = [&](double x, double y) {
      return '[' + rounded_text(x) + ", " + rounded_text(y) + ", " + rounded_text(box->min.z) + ']';
    };
    text += ",\n  \"receivers\": [ { \"name\": \"floor\", \"shape\": \"polygon\",\n    \"vertices\": [" +
            corner(box->min.x, box->min.y) + ", " + corner(box->max.x, box->min.y) + ",\n                 " +
            corner(box->max.x, box->max.y) + ", " + corner(box->min.x, box->max.y) + "] } ]";
  }
  return text + " }";
}

[[noreturn]] void refuse_mesh(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  // What is wrong with the mesh itself comes first.
  const Scene scene = parse_scene(scene_around(name, std::nullopt), file.string(), file.parent_path());
  throw SceneError(file.string() +
                   ": found a mesh, expected a scene. A scene has lights, and names meshes as blockers; "
                   "this one, beside the mesh, holds it:\n" +
                   scene_around(name, default_clip_box(scene)));
}

}  // namespace

Scene scene_file(const std::string& file) {
  if (is_mesh_file(file)) refuse_mesh(file);
  return read_scene(file);
}

Scene scene_file_with_warnings(const std::string& file) {
  Scene scene = scene_file(file);
  print_doubts(scene);
  return scene;
}

Scene shapes_file_with_warnings(const std::string& file) {
  Scene scene = scene_file(file);
  std::visit([](SceneFacts& facts) { facts.doubts.resize(facts.doubts.size() - facts.lighting_doubts); }, scene);
  print_doubts(scene);
  return scene;
}

SpaceScene space_scene_with_warnings(const std::string& file, const std::string& subject) {
  Scene scene = scene_file_with_warnings(file);
  if (auto* space = std::get_if<SpaceScene>(&scene)) return std::move(*space);
  throw UnsupportedError(facts(scene).source + ": " + subject +
                         " in scenes of dimension 2 is not available in this version");
}

void print_doubts(const Scene& scene) {
  constexpr std::size_t most = 10;
  const auto& [source, unit, doubts, of_lighting] = facts(scene);
  for (std::size_t i = 0; i < std::min(most, doubts.size()); ++i) print_warning(source + ": " + doubts[i]);
  if (doubts.size() <= most) return;
  print_warning(counted(doubts.size() - most, "further doubt") + ", which 'gnomon check' tells");
}

}  // namespace gnomon
