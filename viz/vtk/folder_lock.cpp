#include "viz/vtk/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace gnomon::viz {
namespace {

// Files are renamed into place in far less than this, so whoever holds a folder for longer hangs or is stopped.
constexpr std::chrono::seconds longest_wait(6);

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& directory)
    : descriptor_(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) return;  // a folder that can be written, but not read
  const auto end = std::chrono::steady_clock::now() + longest_wait;
  while (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    if (std::chrono::steady_clock::now() > end) {
      ::close(descriptor_);
      throw std::runtime_error(
          "cannot write into " + directory.string() +
          ": another gnomon is writing there and does not end; wait for it, or take another folder");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace gnomon::viz
