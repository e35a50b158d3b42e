#include "viz/vtk/discontinuity_writer.h"

#include "gnomon/errors.h"
#include "viz/vtk/block_file.h"
#include "viz/vtk/discontinuity_blocks.h"
#include "viz/vtk/generation.h"
#include "viz/vtk/manifest.h"
#include "viz/vtk/result_folder.h"
#include "viz/vtk/staged_folder.h"
#include "viz/vtk/tree_file.h"

namespace gnomon {

namespace fs = std::filesystem;

std::vector<fs::path> write_discontinuities(const DiscontinuityResult& result, DiscontinuityOutput output,
                                            const fs::path& directory, const std::vector<OutputFormat>& formats) {
  if (result.scene == nullptr) throw PreconditionError("write_discontinuities: a result without a scene");
  const std::string stem = output == DiscontinuityOutput::receivers ? "receivers" : "discontinuities";
  const std::vector<viz::Block> blocks = viz::discontinuity_blocks(result);
  const std::string generation = viz::generation(blocks);
  viz::mark_generation(blocks, generation);
  viz::StagedFolder folder(directory);
  viz::ManifestEntries entries;
  entries.command = stem;
  entries.generations = {generation};
  std::vector<viz::TreeLeaf> leaves;
  for (const viz::Block& block : blocks) {
    entries.blocks.push_back({&block, {}, generation});
    if (block.empty()) continue;
    entries.blocks.back().files.push_back(viz::block_file_name(block));
    viz::write_data(*block.data, folder.add(entries.blocks.back().files.back()));
    leaves.push_back({block.path, entries.blocks.back().files.back()});
  }
  const ShadowResult frame{result.scene, result.clip_box, {}};
  for (const OutputFormat format : formats) {
    const std::string file = stem + "." + std::string(name(format));
    entries.roots.push_back(file);
    const viz::Fields fields = viz::root_fields(frame, generation);
    folder.add_text(file, format == OutputFormat::vtpc ? viz::partitioned_xml(leaves, fields)
                                                       : viz::multiblock_xml(leaves, fields));
  }
  folder.add_text("view.py", viz::view_script());
  entries.files = folder.files();
  return viz::publish_result(folder, viz::manifest_text(frame, entries), stem, entries.roots);
}

}  // namespace gnomon
