#include "viz/vtk/tree_result.h"

#include "viz/vtk/block_file.h"
#include "viz/vtk/generation.h"
#include "viz/vtk/manifest.h"
#include "viz/vtk/result_folder.h"
#include "viz/vtk/staged_folder.h"
#include "viz/vtk/tree_file.h"

namespace gnomon::viz {

std::vector<std::filesystem::path> write_tree(std::span<const Block> blocks, const ShadowResult& frame,
                                              const std::string& command, const std::filesystem::path& directory,
                                              std::span<const OutputFormat> formats) {
  const std::string mark = generation(blocks);
  mark_generation(blocks, mark);
  StagedFolder folder(directory);
  ManifestEntries entries;
  entries.command = command;
  entries.generations = {mark};
  std::vector<TreeLeaf> leaves;
  for (const Block& block : blocks) {
    entries.blocks.push_back({&block, {}, mark});
    if (block.empty()) continue;
    entries.blocks.back().files.push_back(block_file_name(block));
    write_data(*block.data, folder.add(entries.blocks.back().files.back()));
    leaves.push_back({block.path, entries.blocks.back().files.back()});
  }
  for (const OutputFormat format : formats) {
    const std::string file = command + "." + std::string(name(format));
    entries.roots.push_back(file);
    const Fields fields = root_fields(frame, mark);
    folder.add_text(file,
                    format == OutputFormat::vtpc ? partitioned_xml(leaves, fields) : multiblock_xml(leaves, fields));
  }
  folder.add_text("view.py", view_script());
  entries.files = folder.files();
  return publish_result(folder, manifest_text(frame, entries), command, entries.roots);
}

}  // namespace gnomon::viz
