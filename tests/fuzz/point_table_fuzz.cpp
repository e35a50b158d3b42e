#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "apps/gnomon/point_table.h"
#include "gnomon/scene.h"

/// One run of the fuzzer: any bytes must end in rows of finite points and of problems, or in a SceneError. The first
/// byte chooses the columns, the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::istringstream stream(std::string(reinterpret_cast<const char*>(data + 1), size - 1));
  try {
    gnomon::PointTable table(stream, "fuzz.csv", static_cast<gnomon::TableColumns>(data[0] % 4));
    std::size_t line = 0;
    while (const auto row = table.next()) {
      const auto* point = std::get_if<gnomon::PointRow>(&*row);
      const std::size_t at = point ? point->line : std::get<gnomon::MalformedRow>(*row).line;
      if (at <= line) std::abort();
      line = at;
      if (!point) continue;
      for (const double c : point->coordinates) {
        if (!std::isfinite(c)) std::abort();
      }
    }
  } catch (const gnomon::SceneError&) {
  }
  return 0;
}
