#include "geometry/scene/file_text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace gnomon {

FileText file_text(const std::filesystem::path& file, std::size_t limit, FileKind kind) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::is_directory(status)) return {{}, "a folder"};
  if (kind == FileKind::regular && std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return {{}, "a pipe, socket or device"};
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    if (errno == ENOENT) return {{}, "no such file"};
    return {{}, std::string("a file that cannot be opened (") + std::strerror(errno) + ")"};
  }
  // The size is no help: pipes have none. So the text grows block by block.
  constexpr std::size_t block = std::size_t{1} << 20;
  FileText result;
  while (stream && result.text.size() <= limit) {
    const std::size_t size = result.text.size();
    result.text.resize(size + std::min(block, limit + 1 - size));
    stream.read(result.text.data() + size, static_cast<std::streamsize>(result.text.size() - size));
    result.text.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return {{}, "a file that cannot be read"};
  if (result.text.size() > limit) return {{}, "a file of more than " + std::to_string(limit >> 20) + " MiB"};
  return result;
}

}  // namespace gnomon
