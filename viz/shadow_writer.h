#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viz/shadow_result.h"

namespace gnomon {

/// How a result is laid out on disk. The numbers of the first three are doubles throughout.
enum class OutputFormat {
  vtm,   ///< `shadow.vtm`, a tree of the block files in `shadow/`
  vtpc,  ///< `shadow.vtpc`, the same block files as a partitioned collection with an assembly
  vtp,   ///< `shadow.vtp`, all surfaces in one file, with the cell array `block_id` and the field array `block_names`
  obj,   ///< `shadow.obj`, one group per block, named by its path; decimal numbers that read back as the same doubles
  stl,   ///< one ASCII file per volume surface in `shadow/`; STL knows one nameless triangle soup per file
  gltf,  ///< `shadow.gltf`, one node per block; positions are floats, relative to the centre of the clip box
};

/// The format's name, which is also the file name's ending.
std::string_view name(OutputFormat format);

/// The format of that name, or nothing.
std::optional<OutputFormat> output_format(std::string_view name);

struct WriteOptions {
  std::vector<OutputFormat> formats = {OutputFormat::vtm};
};

/// Writes a result into a folder, which is made if it is not there: the files of the formats asked for,
/// `manifest.json` (every block with file, kind and counts, empty ones too; every pair with its position) and, for vtm
/// and vtpc, `view.py`, a ParaView script that shows the result.
///
/// All files are first written completely to a folder beside their places and then renamed into place, block files
/// first, manifest.json last: a run that fails or is killed before that leaves an earlier result as it was. Block files
/// keep their names from run to run. Files of an earlier result that are not written again are removed, results of
/// other commands and files of others are left alone. Where two processes write into one folder, the last result is
/// there whole.
///
/// Requires: result.scene is not null.
/// Returns:  the files written, relative to the folder, those to be opened by a user first.
/// Throws:   std::runtime_error naming the file that could not be written, and why: a file that is not ours among
/// others;
///           PreconditionError.
std::vector<std::filesystem::path> write_shadow(const ShadowResult& result, const std::filesystem::path& directory,
                                                const WriteOptions& options = {});

/// Makes sure, before anything is computed, that no `manifest.json` or `view.py` of others stands where a result is to
/// be written. A folder that is not there is fine.
///
/// Throws: std::runtime_error naming the file.
void require_result_folder(const std::filesystem::path& directory);

/// The roots of those results in a folder that other commands have written of another scene, or with another box, than
/// the last one: what they show of lights, blockers and receivers is no longer theirs. None if there is no manifest.
std::vector<std::string> outdated_roots(const std::filesystem::path& directory);

}  // namespace gnomon
