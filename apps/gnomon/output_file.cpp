#include "apps/gnomon/output_file.h"

#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace gnomon {
namespace {

namespace fs = std::filesystem;

}  // namespace

OutputFile::OutputFile(fs::path file) : file_(std::move(file)) {
  std::error_code error;
  const fs::file_status status = fs::status(file_, error);
  if (fs::is_directory(status)) throw std::runtime_error("cannot write " + file_.string() + ": it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    stream_.open(file_, std::ios::binary);
  } else {
    // A link stays one: what it leads to is replaced.
    const fs::path target = fs::exists(status) ? fs::canonical(file_) : file_;
    folder_.emplace(target.parent_path());
    stream_.open(folder_->add(target.filename().string()).temporary, std::ios::binary);
  }
  if (!stream_) throw std::runtime_error("cannot write " + file_.string());
}

void OutputFile::publish() {
  stream_.close();
  if (!stream_) throw std::runtime_error("cannot write " + file_.string());
  if (folder_) folder_->publish();
}

void write_output_file(const fs::path& file, std::string_view text) {
  OutputFile output(file);
  output.stream().write(text.data(), static_cast<std::streamsize>(text.size()));
  output.publish();
}

}  // namespace gnomon
