#include "apps/gnomon/receiver_rows.h"

#include <string>

#include "apps/gnomon/text.h"

namespace gnomon {
namespace {

PointRow row_of(const Point3& p, const Point3& n, std::size_t line) {
  std::string text;
  for (const double number : {p.x, p.y, p.z, n.x, n.y, n.z}) text += (text.empty() ? "" : ",") + number_text(number);
  return {line, text, {p.x, p.y, p.z}, {n.x, n.y, n.z}};
}

}  // namespace

std::vector<TableRow> next_rows(const ReceiverGrid& grid, std::size_t& next) {
  constexpr std::size_t most = 1024;
  std::vector<TableRow> rows;
  for (; rows.size() < most && next < grid.size(); ++next) {
    const Point3 p = grid.point(next);
    if (grid.is_on_receiver(p)) rows.emplace_back(row_of(p, grid.normal(), next + 1));
  }
  return rows;
}

}  // namespace gnomon
