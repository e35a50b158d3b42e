#include "apps/gnomon/output_file.h"

#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "viz/staged_folder.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

void write_device(const fs::path& file, std::string_view text) {
  std::ofstream out(file, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

void write_output_file(const fs::path& file, std::string_view text) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) throw std::runtime_error("cannot write " + file.string() + ": it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_device(file, text);
  // A link stays one: what it leads to is replaced.
  const fs::path target = fs::exists(status) ? fs::canonical(file) : file;
  viz::StagedFolder folder(target.parent_path());
  folder.add_text(target.filename().string(), text);
  folder.publish();
}

}  // namespace gnomon
