#include "viz/pictures/picture_source.h"

#include <algorithm>

#include "viz/vtk/block.h"
#include "viz/vtk/block_file.h"
#include "viz/vtk/generation.h"
#include "viz/vtk/manifest.h"
#include "viz/vtk/own_files.h"

namespace gnomon::viz {
namespace {

namespace fs = std::filesystem;

/// The scene's file name without its endings.
std::string title(const std::string& scene) {
  std::string name = fs::path(scene).filename().string();
  for (const std::string ending : {".json", ".scene"}) {
    if (name.ends_with(ending)) name.resize(name.size() - ending.size());
  }
  return name;
}

void check_generation(vtkPointSet& leaf, const fs::path& directory, const ListedBlock& block) {
  if (generation_of(leaf) == block.generation) return;
  throw ResultError("cannot read " + directory.string() + ": " + block.file +
                    " is of another run than manifest.json; a run was stopped before it had put everything into its "
                    "place, so let gnomon write the folder again");
}

/// A leaf, if it is what the manifest says; nothing of solids, which are not drawn.
vtkSmartPointer<vtkPolyData> surface_of(const fs::path& directory, const ListedBlock& block) {
  if (const std::string why = way_out(directory, block.file); !why.empty()) {
    throw ResultError("cannot read " + (directory / block.file).string() + ": " + why);
  }
  if (fs::path(block.file).extension() == ".vtu") {
    check_generation(*read_solid(directory / block.file), directory, block);
    return nullptr;
  }
  auto surface = read_surface(directory / block.file);
  check_generation(*surface, directory, block);
  return surface;
}

}  // namespace

PictureSource picture_source(const ShadowResult& result) {
  const bool complete = std::ranges::all_of(result.pairs, &PairResult::supported);
  const auto* space = std::get_if<SpaceScene>(result.scene);
  PictureSource source{title(facts(*result.scene).source),
                       complete,
                       dimension(*result.scene),
                       space ? space->up : UpAxis::z,
                       facts(*result.scene).length_unit,
                       result.clip_box,
                       {}};
  for (const Block& block : shadow_blocks(result)) {
    auto surface = vtkSmartPointer<vtkPolyData>(vtkPolyData::SafeDownCast(block.data));
    if (surface != nullptr && !block.empty()) source.blocks.push_back({block.path, block.kind, surface});
  }
  return source;
}

PictureSource picture_source(const fs::path& directory) {
  const ListedResult listed = read_manifest(directory);
  PictureSource source{
      title(listed.scene), listed.complete, listed.dimension, listed.up, listed.length_unit, listed.clip_box, {}};
  for (const ListedBlock& block : listed.blocks) {
    const fs::path ending = fs::path(block.file).extension();
    if (ending != ".vtp" && ending != ".vtu") continue;
    if (auto surface = surface_of(directory, block)) source.blocks.push_back({block.path, block.kind, surface});
  }
  if (source.blocks.empty()) {
    throw ResultError("cannot draw " + directory.string() +
                      ": it holds no surfaces; write it with `gnomon shadow --format vtm` or vtpc");
  }
  return source;
}

}  // namespace gnomon::viz
