#include "viz/stale_files.h"

#include <set>
#include <system_error>

#include "viz/own_files.h"

namespace gnomon::viz {
namespace {

namespace fs = std::filesystem;

bool may_be_removed(const fs::path& directory, const fs::path& file) {
  return may_be_ours(file) && way_out(directory, file).empty() && says_it_is_ours(directory / file);
}

}  // namespace

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

}  // namespace gnomon::viz
