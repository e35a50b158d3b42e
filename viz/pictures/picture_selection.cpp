#include "viz/pictures/picture_selection.h"

#include <algorithm>

namespace gnomon::viz {
namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::count(names, name) > 0;
}

bool is_of_scene(const PictureBlock& block) {
  return block.path.front() == "scene";
}

/// The names of the scene's elements of a kind: "light", "blocker", "receiver".
std::vector<std::string> element_names(const PictureSource& source, const std::string& kind) {
  std::vector<std::string> names;
  for (const PictureBlock& block : source.blocks) {
    if (is_of_scene(block) && block.kind == kind) names.push_back(block.path.back());
  }
  return names;
}

/// A part of a larger blocker is none of the scene's elements.
bool is_of_a_part(const PictureSource& source, const PictureBlock& block) {
  return source.dimension == 3 && block.kind == "volume" && !has(element_names(source, "blocker"), block.path.at(2));
}

bool is_receivers(const PictureBlock& block) {
  return block.kind == "receiver" || block.kind == "receiver_mesh" || block.path.front() == "receivers";
}

}  // namespace

ResultNames names_in(const PictureSource& source) {
  ResultNames names{{}, element_names(source, "receiver")};
  const std::vector<std::string> meshes = element_names(source, "receiver_mesh");
  names.receivers.insert(names.receivers.end(), meshes.begin(), meshes.end());
  const std::vector<std::string> all = element_names(source, "light");
  for (const std::string& light : all) {
    const bool has_result = std::ranges::any_of(
        source.blocks, [&](const PictureBlock& block) { return !is_of_scene(block) && block.path.at(1) == light; });
    if (has_result) names.lights.push_back(light);
  }
  if (names.lights.empty()) names.lights = all;
  return names;
}

PictureSource selected(PictureSource source, const PictureSelection& selection, LightsShown lights) {
  source.light_count = element_names(source, "light").size();
  source.lights = selection.light.empty() ? names_in(source).lights : std::vector{selection.light};
  if (lights == LightsShown::first && source.lights.size() > 1) source.lights.resize(1);
  const auto is_shown = [&](const PictureBlock& block) {
    const bool names_light = block.kind == "light" || !is_of_scene(block);
    const std::string& light = is_of_scene(block) ? block.path.back() : block.path.at(1);
    if (names_light && !has(source.lights, light)) return false;
    if (is_receivers(block) && !selection.receiver.empty() && block.path.at(2) != selection.receiver) return false;
    return selection.part_volumes == Shown::yes || !is_of_a_part(source, block);
  };
  std::vector<PictureBlock> blocks;
  std::ranges::copy_if(source.blocks, std::back_inserter(blocks), is_shown);
  source.blocks = std::move(blocks);
  return source;
}

}  // namespace gnomon::viz
