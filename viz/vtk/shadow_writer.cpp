#include "gnomon/writer.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <array>

#include "gnomon/errors.h"
#include "viz/vtk/block.h"
#include "viz/vtk/block_file.h"
#include "viz/vtk/generation.h"
#include "viz/vtk/manifest.h"
#include "viz/vtk/result_folder.h"
#include "viz/vtk/staged_folder.h"
#include "viz/vtk/surface_files.h"
#include "viz/vtk/tree_file.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> format_names = {"vtm", "vtpc", "vtp", "obj", "stl", "gltf"};

/// A result on its way to its folder.
struct Writing {
  const ShadowResult& result;
  const std::vector<viz::Block>& blocks;
  viz::StagedFolder& folder;
  viz::ManifestEntries entries;
};

bool has(const WriteOptions& options, OutputFormat format) {
  return std::ranges::count(options.formats, format) > 0;
}

void write_block_files(Writing& writing) {
  for (viz::WrittenBlock& written : writing.entries.blocks) {
    if (written.block->empty()) continue;
    written.files.push_back(viz::block_file_name(*written.block));
    viz::write_data(*written.block->data, writing.folder.add(written.files.back()));
  }
}

void write_stl_files(Writing& writing) {
  for (viz::WrittenBlock& written : writing.entries.blocks) {
    const viz::Block& block = *written.block;
    if (block.empty() || block.kind != "volume") continue;
    written.files.push_back(fs::path(viz::block_file_name(block)).replace_extension(".stl").string());
    writing.folder.add_text(written.files.back(),
                            viz::stl_text(*vtkPolyData::SafeDownCast(block.data), block.path.back()));
  }
}

std::vector<viz::TreeLeaf> tree_leaves(const Writing& writing) {
  std::vector<viz::TreeLeaf> leaves;
  for (const viz::WrittenBlock& written : writing.entries.blocks) {
    if (!written.block->empty()) leaves.push_back({written.block->path, written.files.front()});
  }
  return leaves;
}

viz::ModelFrame model_frame_of(const ShadowResult& result) {
  const auto* space = std::get_if<SpaceScene>(result.scene);
  return viz::model_frame(result.clip_box, dimension(*result.scene), space ? space->up : UpAxis::z,
                          facts(*result.scene).length_unit);
}

void write_root(Writing& writing, OutputFormat format) {
  if (format == OutputFormat::stl) return;
  const std::string file = "shadow." + std::string(name(format));
  const viz::Fields fields = viz::root_fields(writing.result, writing.entries.generations.front());
  writing.entries.roots.push_back(file);
  switch (format) {
    case OutputFormat::vtm:
      return writing.folder.add_text(file, viz::multiblock_xml(tree_leaves(writing), fields));
    case OutputFormat::vtpc:
      return writing.folder.add_text(file, viz::partitioned_xml(tree_leaves(writing), fields));
    case OutputFormat::vtp:
      return viz::write_data(*viz::merged_surfaces(writing.blocks, fields), writing.folder.add(file));
    case OutputFormat::obj:
      return writing.folder.add_text(file, viz::obj_text(writing.blocks));
    case OutputFormat::gltf:
      return writing.folder.add_text(file, viz::gltf_text(writing.blocks, model_frame_of(writing.result)));
    case OutputFormat::stl:
      return;
  }
}

void write_all(Writing& writing, const WriteOptions& options) {
  const bool tree = has(options, OutputFormat::vtm) || has(options, OutputFormat::vtpc);
  if (tree) write_block_files(writing);
  if (has(options, OutputFormat::stl)) write_stl_files(writing);
  for (std::size_t i = 0; i < format_names.size(); ++i) {
    const auto format = static_cast<OutputFormat>(i);
    if (has(options, format)) write_root(writing, format);
  }
  if (tree) writing.folder.add_text("view.py", viz::view_script());
  writing.entries.files = writing.folder.files();
}

}  // namespace

std::string_view name(OutputFormat format) {
  return format_names[static_cast<std::size_t>(format)];
}

std::optional<OutputFormat> output_format(std::string_view name) {
  const auto found = std::ranges::find(format_names, name);
  if (found == format_names.end()) return std::nullopt;
  return static_cast<OutputFormat>(found - format_names.begin());
}

std::vector<fs::path> write_shadow(const ShadowResult& result, const fs::path& directory, const WriteOptions& options) {
  if (result.scene == nullptr) throw PreconditionError("write_shadow: a result without a scene");
  const std::vector<viz::Block> blocks = viz::shadow_blocks(result);
  const std::string generation = viz::generation(blocks);
  viz::mark_generation(blocks, generation);
  viz::StagedFolder folder(directory);
  Writing writing{result, blocks, folder, {}};
  writing.entries.command = "shadow";
  writing.entries.generations = {generation};
  for (const viz::Block& block : blocks) writing.entries.blocks.push_back({&block, {}, generation});
  write_all(writing, options);
  return viz::publish_result(folder, viz::manifest_text(result, writing.entries), "shadow", writing.entries.roots);
}

}  // namespace gnomon
