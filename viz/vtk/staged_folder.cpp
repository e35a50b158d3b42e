#include "viz/vtk/staged_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>

#include "viz/vtk/own_files.h"

namespace gnomon::viz {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".gnomon-";

[[noreturn]] void fail(std::string_view what, const fs::path& path, const std::error_code& error) {
  throw std::runtime_error(std::string(what) + " " + path.string() + ": " + error.message());
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail("cannot create the folder", folder, error);
  if (!fs::is_directory(folder, error))
    fail("cannot create the folder", folder, std::make_error_code(std::errc::not_a_directory));
}

bool is_running(long process) {
  return ::kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
}

/// A whole number without a sign.
std::optional<long> number_in(std::string_view text) {
  long number = 0;
  const auto [end, bad] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (bad != std::errc() || end != text.data() + text.size() || text.front() == '-') return std::nullopt;
  return number;
}

/// The process that made a hidden folder: they are named .gnomon-PROCESS-NUMBER. Nothing for any other name.
std::optional<long> process_of(std::string_view name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  const std::size_t dash = std::min(name.find('-'), name.size());
  if (dash + 1 >= name.size() || !number_in(name.substr(dash + 1))) return std::nullopt;
  return number_in(name.substr(0, dash));
}

void remove_leftovers(const fs::path& directory) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
    const std::optional<long> process = process_of(entry.path().filename().string());
    if (!process || *process <= 0 || is_running(*process) || !fs::is_directory(entry.symlink_status(error))) continue;
    fs::remove_all(entry.path(), error);
  }
}

/// The hidden folders of this process. Never destroyed: a thread may still ask while the process ends.
struct StagingFolders {
  std::recursive_timed_mutex mutex;  ///< held while files are renamed, too
  std::set<fs::path> paths;
};

StagingFolders& staging_folders() {
  static auto* folders = new StagingFolders;
  return *folders;
}

fs::path fresh_folder(const fs::path& directory) {
  for (int number = 0;; ++number) {
    fs::path folder = directory / (std::string(prefix) + std::to_string(::getpid()) + "-" + std::to_string(number));
    std::error_code error;
    if (fs::create_directory(folder, error)) return folder;
    if (error) fail("cannot write in the folder", directory, error);
  }
}

}  // namespace

StagedFolder::StagedFolder(fs::path directory) : directory_(std::move(directory)) {
  if (directory_.empty()) directory_ = ".";
  make_folder(directory_);
  remove_leftovers(directory_);
  const std::lock_guard lock(staging_folders().mutex);
  staging_ = fresh_folder(directory_);
  staging_folders().paths.insert(staging_);
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  const std::lock_guard lock(staging_folders().mutex);
  fs::remove_all(staging_, ignored);
  staging_folders().paths.erase(staging_);
}

StagedFile StagedFolder::add(const std::string& relative) {
  files_.push_back(relative);
  const fs::path temporary = staging_ / relative;
  const std::lock_guard lock(staging_folders().mutex);  // so that no folder comes back that the end has removed
  make_folder(temporary.parent_path());
  return {temporary, directory_ / relative};
}

void StagedFolder::add_text(const std::string& relative, std::string_view text) {
  const StagedFile file = add(relative);
  errno = 0;
  std::ofstream out(file.temporary, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) fail("cannot write", file.target, {errno != 0 ? errno : EIO, std::generic_category()});
}

void StagedFolder::publish() {
  const std::lock_guard lock(staging_folders().mutex);
  // Everything that can be found out before the first file is replaced is found out before.
  for (const std::string& file : files_) {
    const fs::path target = directory_ / file;
    if (const std::string why = way_out(directory_, file); !why.empty()) {
      throw std::runtime_error("cannot write " + target.string() + ": " + why);
    }
    make_folder(target.parent_path());
    std::error_code error;
    if (fs::is_directory(fs::symlink_status(target, error)))
      fail("cannot replace", target, std::make_error_code(std::errc::is_a_directory));
  }
  for (const std::string& file : files_) {
    std::error_code error;
    fs::rename(staging_ / file, directory_ / file, error);
    if (error) fail("cannot write", directory_ / file, error);
  }
}

void remove_staging_folders() {
  // For good, as the process ends. Who holds it may wait for memory that will never be there.
  static_cast<void>(staging_folders().mutex.try_lock_for(std::chrono::seconds(5)));
  std::error_code ignored;
  for (const fs::path& folder : staging_folders().paths) {
    // A thread that is still writing there may make a file anew.
    for (int attempt = 0; attempt < 100 && fs::exists(folder, ignored); ++attempt) fs::remove_all(folder, ignored);
  }
}

}  // namespace gnomon::viz
