#include "apps/gnomon/point_batches.h"

#include <tbb/parallel_for.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <utility>

#include "geometry/scene/scene_reader.h"

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

int arena_size(unsigned threads) {
  return threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads);
}

void for_all(std::size_t count, tbb::task_arena& threads, const std::function<void(std::size_t)>& work) {
  threads.execute([&] { tbb::parallel_for(std::size_t{0}, count, work); });
}

}  // namespace gnomon
