#include "gnomon/writer.h"

#include <charconv>
#include <map>
#include <string>
#include <utility>

#include "gnomon/errors.h"
#include "viz/vtk/block.h"
#include "viz/vtk/block_file.h"
#include "viz/vtk/generation.h"
#include "viz/vtk/manifest.h"
#include "viz/vtk/result_folder.h"
#include "viz/vtk/staged_folder.h"
#include "viz/vtk/tree_file.h"
#include "viz/vtk/xml.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

constexpr const char* root = "shadow.pvd";

/// "shadow_0000/": as many digits as sort well, more where they are needed.
std::string step_folder(std::size_t step) {
  std::string digits = std::to_string(step);
  digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
  return "shadow_" + digits + "/";
}

std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

struct SeriesWriter::Writing {
  viz::StagedFolder folder;
  std::vector<double> times = {};
  std::vector<std::string> generations = {};
  std::map<std::string, viz::WrittenBlock> first_files = {};  ///< by the block's name; the block itself is gone
  std::string manifest = {};

  /// The blocks of one time as a tree below its folder.
  void add_tree(const ShadowResult& result, const std::vector<viz::Block>& blocks) {
    const std::string place = step_folder(times.size());
    std::vector<viz::TreeLeaf> leaves;
    for (const viz::Block& block : blocks) {
      if (block.empty()) continue;
      const std::string file = viz::block_file_name(block);
      viz::write_data(*block.data, folder.add(place + file));
      leaves.push_back({block.path, file});
      first_files.emplace(viz::joined(block.path), viz::WrittenBlock{nullptr, {place + file}, generations.back()});
    }
    folder.add_text(place + "shadow.vtm", viz::multiblock_xml(leaves, viz::root_fields(result, generations.back())));
  }

  /// What the manifest says if this time is the last one.
  std::string manifest_of(const ShadowResult& result, const std::vector<viz::Block>& blocks) const {
    viz::ManifestEntries entries{"shadow", generations, {root}, folder.files(), {}};
    entries.files.insert(entries.files.end(), {root, "view.py"});
    for (const viz::Block& block : blocks) {
      const auto first = first_files.find(viz::joined(block.path));
      entries.blocks.push_back(first != first_files.end() ? first->second
                                                          : viz::WrittenBlock{nullptr, {}, generations.back()});
      entries.blocks.back().block = &block;
    }
    return viz::manifest_text(result, entries);
  }

  std::string collection() const {
    std::string text = "<?xml version=\"1.0\"?>\n<!-- gnomon " GNOMON_VERSION
                       " -->\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                       "  <Collection>\n";
    for (std::size_t i = 0; i < times.size(); ++i) {
      text += "    <DataSet timestep=\"" + number_text(times[i]) + "\" part=\"0\" file=\"" +
              viz::xml_escaped(step_folder(i)) + "shadow.vtm\"/>\n";
    }
    return text + "  </Collection>\n</VTKFile>\n";
  }
};

SeriesWriter::SeriesWriter(fs::path directory) : writing_(new Writing{viz::StagedFolder(std::move(directory))}) {}

SeriesWriter::~SeriesWriter() = default;

void SeriesWriter::add(double time, const ShadowResult& result) {
  if (result.scene == nullptr) throw PreconditionError("SeriesWriter: a result without a scene");
  if (!writing_->times.empty() && !(writing_->times.back() < time)) {
    throw PreconditionError("SeriesWriter: times that do not grow");
  }
  const std::vector<viz::Block> blocks = viz::shadow_blocks(result);
  writing_->generations.push_back(viz::generation(blocks));
  viz::mark_generation(blocks, writing_->generations.back());
  writing_->add_tree(result, blocks);
  writing_->times.push_back(time);
  writing_->manifest = writing_->manifest_of(result, blocks);
}

std::vector<fs::path> SeriesWriter::publish() {
  if (writing_->times.empty()) throw PreconditionError("SeriesWriter: no result has been added");
  viz::StagedFolder& folder = writing_->folder;
  folder.add_text(root, writing_->collection());
  folder.add_text("view.py", viz::view_script());
  return viz::publish_result(folder, writing_->manifest, "shadow", {root});
}

}  // namespace gnomon
