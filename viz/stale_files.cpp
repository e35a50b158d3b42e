#include "viz/stale_files.h"

#include <algorithm>
#include <set>
#include <system_error>

namespace gnomon::viz {
namespace {

namespace fs = std::filesystem;

bool may_be_removed(const fs::path& file) {
  if (file.is_absolute() || std::ranges::count(file, fs::path("..")) > 0) return false;
  const std::string first = file.begin()->string();
  return file == "view.py" || first.starts_with("shadow") || first.starts_with("receivers.vt") ||
         first.starts_with("discontinuities.vt");
}

}  // namespace

void remove_stale(const fs::path& directory, const std::vector<std::string>& earlier,
                  const std::vector<std::string>& now) {
  const std::set<std::string> kept(now.begin(), now.end());
  std::error_code ignored;
  for (const std::string& file : earlier) {
    if (kept.contains(file) || !may_be_removed(file)) continue;
    fs::remove(directory / file, ignored);
    for (fs::path folder = fs::path(file).parent_path(); !folder.empty(); folder = folder.parent_path()) {
      if (!fs::is_empty(directory / folder, ignored) || ignored) break;
      fs::remove(directory / folder, ignored);
    }
  }
}

}  // namespace gnomon::viz
