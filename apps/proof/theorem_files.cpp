#include "apps/proof/theorem_files.h"

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/scene_pairs.h"
#include "apps/gnomon/scene_text.h"
#include "apps/gnomon/text.h"
#include "gnomon/picture.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

fs::path scene_file(const std::string& key, const fs::path& folder) {
  return folder / (key + ".scene.json");
}

std::string points_text(const laws::Example& example) {
  const bool planar = std::holds_alternative<PlaneScene>(example.scene);
  std::string text = planar ? "x,y\n" : "x,y,z\n";
  for (const Point3& p : example.points) {
    text += number_text(p.x) + ',' + number_text(p.y) + (planar ? "" : ',' + number_text(p.z)) + '\n';
  }
  return text;
}

}  // namespace

std::vector<std::string> write_example(const laws::Example& example, const std::string& key, const fs::path& folder) {
  fs::create_directories(folder);
  const fs::path scene = scene_file(key, folder), points = folder / (key + ".csv");
  write_output_file(scene, scene_document(example.scene).dump(1) + '\n');
  write_output_file(points, points_text(example));
  return {scene.string(), points.string()};
}

std::vector<std::string> draw_example(const std::string& key, const fs::path& folder, const Effort& effort) {
  const Scene scene = read_scene(scene_file(key, folder).string());
  const std::vector<ScenePair> pairs = scene_pairs(scene, {});
  if (supported_count(pairs) == 0 || !default_clip_box(scene)) return {};
  const fs::path png = folder / (key + ".png");
  render_scene(computed_shadows(scene, pairs, clip_box(scene, ""), effort), png);
  return {png.string()};
}

}  // namespace gnomon
