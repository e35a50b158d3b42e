#include "viz/vtk/result_folder.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <system_error>

#include "gnomon/writer.h"
#include "viz/vtk/folder_lock.h"
#include "viz/vtk/own_files.h"

namespace gnomon {
namespace viz {
namespace {

namespace fs = std::filesystem;

/// Everything that a manifest of ours in the folder lists.
std::set<std::string> listed_files(const EarlierResults& earlier) {
  std::set<std::string> files(earlier.files.begin(), earlier.files.end());
  for (const OtherResult& other : earlier.others) files.insert(other.files.begin(), other.files.end());
  return files;
}

/// A file that is there must be listed as ours or say so; what people write or edit, by itself only.
void require_ours(const fs::path& directory, const std::string& file, const std::set<std::string>& listed) {
  const fs::path target = directory / file;
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(target, ignored);
  if (!fs::exists(status) || fs::is_directory(status)) return;  // folders are told by StagedFolder
  const bool written_by_people = file == "view.py" || file == "manifest.json";
  if ((!written_by_people && listed.contains(file)) || says_it_is_ours(target)) return;
  if (file == "manifest.json" && !results_in_folder(directory).empty()) return;  // ours, laid out by another program
  throw std::runtime_error("cannot write into " + directory.string() + ": the file " + file +
                           " there is not gnomon's; move it away, or take another folder");
}

std::vector<fs::path> roots_first(const std::vector<std::string>& files, const std::vector<std::string>& roots) {
  std::vector<fs::path> result(roots.begin(), roots.end());
  for (const std::string& file : files) {
    if (std::ranges::count(roots, file) == 0) result.emplace_back(file);
  }
  return result;
}

bool may_be_removed(const fs::path& directory, const fs::path& file) {
  return may_be_ours(file) && way_out(directory, file).empty() && says_it_is_ours(directory / file);
}

/// Removes those of an earlier result's files that are not among the new ones, and the folders that this leaves empty.
/// Only what can be a file of ours inside the folder, and says it is: an earlier manifest is no reason to remove
/// anything else.
void remove_stale(const fs::path& directory, const std::vector<std::string>& earlier,
                  const std::vector<std::string>& now) {
  const std::set<std::string> kept(now.begin(), now.end());
  std::error_code ignored;
  for (const std::string& file : earlier) {
    if (kept.contains(file) || !may_be_removed(directory, file)) continue;
    fs::remove(directory / file, ignored);
    for (fs::path folder = fs::path(file).parent_path(); !folder.empty(); folder = folder.parent_path()) {
      if (!fs::is_empty(directory / folder, ignored) || ignored) break;
      fs::remove(directory / folder, ignored);
    }
  }
}

}  // namespace

std::vector<fs::path> publish_result(StagedFolder& folder, const std::string& manifest, const std::string& command,
                                     const std::vector<std::string>& roots) {
  const fs::path& directory = folder.directory();
  const FolderLock lock(directory);
  const EarlierResults earlier = earlier_results(directory, command);
  folder.add_text("manifest.json", with_others(manifest, earlier.others));
  const std::set<std::string> listed = listed_files(earlier);
  for (const std::string& file : folder.files()) require_ours(directory, file, listed);
  folder.publish();
  std::vector<std::string> kept = folder.files();
  for (const OtherResult& other : earlier.others) kept.insert(kept.end(), other.files.begin(), other.files.end());
  remove_stale(directory, earlier.files, kept);
  return roots_first(folder.files(), roots);
}

}  // namespace viz

void require_result_folder(const std::filesystem::path& directory) {
  for (const std::string file : {"view.py", "manifest.json"}) viz::require_ours(directory, file, {});
}

std::vector<std::string> outdated_roots(const std::filesystem::path& directory) {
  std::vector<std::string> roots;
  const std::vector<viz::OtherResult> results = viz::results_in_folder(directory);
  for (const viz::OtherResult& other : results) {
    if (other.generation == results.front().generation) continue;
    roots.insert(roots.end(), other.roots.begin(), other.roots.end());
  }
  return roots;
}

}  // namespace gnomon
