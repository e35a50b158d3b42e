#include "apps/gnomon/point_batches.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>
#include <utility>

#include "gnomon/scene.h"

namespace gnomon {

ExitCode with_points(const std::string& at, const std::function<ExitCode(std::istream&, const std::string&)>& work) {
  if (at == "-") return work(std::cin, "stdin");
  if (std::filesystem::is_directory(at)) throw SceneError(at + ": found a folder, expected a CSV file");
  std::ifstream stream(at, std::ios::binary);
  if (!stream) throw SceneError(at + ": cannot be read, expected a CSV file of points");
  return work(stream, at);
}

std::vector<TableRow> next_rows(PointTable& table) {
  constexpr std::size_t most = 1024;
  std::vector<TableRow> rows;
  while (rows.size() < most) {
    auto row = table.next();
    if (!row) break;
    rows.push_back(std::move(*row));
  }
  return rows;
}

double share_read(std::istream& stream, const std::string& at) {
  std::error_code error;
  const std::uintmax_t size =
      at == "-" || !std::filesystem::is_regular_file(at, error) ? 0 : std::filesystem::file_size(at, error);
  const std::streamoff place = size == 0 || error ? -1 : std::streamoff(stream.tellg());
  return place < 0 ? -1 : std::min(1.0, static_cast<double>(place) / static_cast<double>(size));
}

}  // namespace gnomon
