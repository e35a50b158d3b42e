#include "viz/staged_folder.h"

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

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

// Staging folders are named .gnomon-PROCESS-NUMBER.
void remove_leftovers(const fs::path& directory) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    long process = 0;
    const auto [end, bad] = std::from_chars(name.data() + prefix.size(), name.data() + name.size(), process);
    if (bad != std::errc() || *end != '-' || process <= 0 || is_running(process)) continue;
    fs::remove_all(entry.path(), error);
  }
}

fs::path fresh_folder(const fs::path& directory) {
  for (int number = 0;; ++number) {
    fs::path folder = directory / (std::string(prefix) + std::to_string(::getpid()) + "-" + std::to_string(number));
    std::error_code error;
    if (fs::create_directory(folder, error)) return folder;
    if (error) fail("cannot create the folder", folder, error);
  }
}

}  // namespace

StagedFolder::StagedFolder(fs::path directory) : directory_(std::move(directory)) {
  if (directory_.empty()) directory_ = ".";
  make_folder(directory_);
  remove_leftovers(directory_);
  staging_ = fresh_folder(directory_);
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
}

StagedFile StagedFolder::add(const std::string& relative) {
  files_.push_back(relative);
  const fs::path temporary = staging_ / relative;
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
  // Everything that can be found out before the first file is replaced is found out before.
  for (const std::string& file : files_) {
    const fs::path target = directory_ / file;
    make_folder(target.parent_path());
    std::error_code error;
    if (fs::is_directory(target, error))
      fail("cannot replace", target, std::make_error_code(std::errc::is_a_directory));
  }
  for (const std::string& file : files_) {
    std::error_code error;
    fs::rename(staging_ / file, directory_ / file, error);
    if (error) fail("cannot write", directory_ / file, error);
  }
}

}  // namespace gnomon::viz
