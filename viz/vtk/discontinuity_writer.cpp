#include "viz/vtk/discontinuity_writer.h"

#include "gnomon/errors.h"
#include "viz/vtk/discontinuity_blocks.h"
#include "viz/vtk/tree_result.h"

namespace gnomon {

namespace fs = std::filesystem;

std::vector<fs::path> write_discontinuities(const DiscontinuityResult& result, DiscontinuityOutput output,
                                            const fs::path& directory, const std::vector<OutputFormat>& formats) {
  if (result.scene == nullptr) throw PreconditionError("write_discontinuities: a result without a scene");
  const std::string stem = output == DiscontinuityOutput::receivers ? "receivers" : "discontinuities";
  const std::vector<viz::Block> blocks = viz::discontinuity_blocks(result);
  return viz::write_tree(blocks, {result.scene, result.clip_box, {}}, stem, directory, formats);
}

}  // namespace gnomon
