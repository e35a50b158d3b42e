#include <algorithm>
#include <array>
#include <cmath>

#include "apps/proof/report/draws.h"
#include "apps/proof/report/search_tables.h"
#include "apps/proof/report/tables.h"
#include "gnomon/errors.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon::report {
namespace {

using BoardTriangle = std::array<Point3, 3>;

double squared_side(const Point3& a, const Point3& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
}

/// Two halves, through the middle of the longest side.
std::array<BoardTriangle, 2> halves_of(const BoardTriangle& t) {
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (squared_side(t[k], t[(k + 1) % 3]) > squared_side(t[longest], t[(longest + 1) % 3])) longest = k;
  }
  const Point3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  const Point3 middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  return {BoardTriangle{a, middle, c}, {middle, b, c}};
}

constexpr ShadowParts umbra_alone{.penumbra = false, .cells = false, .planes = false};
constexpr Box3 board_box{{-9, -9, -9}, {9, 9, 9}};

/// The square of side 2 at the height 2, in so many triangles, a power of two; one: the square itself.
std::vector<ConvexBlocker> board_of(std::size_t triangles) {
  if (triangles == 1) return {ConvexPolygon::from_points({{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}})};
  std::vector<BoardTriangle> parts = {BoardTriangle{Point3{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}},
                                      {Point3{-1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
  while (parts.size() < triangles) {
    std::vector<BoardTriangle> finer;
    for (const BoardTriangle& t : parts) {
      for (const BoardTriangle& half : halves_of(t)) finer.push_back(half);
    }
    parts = std::move(finer);
  }
  std::vector<ConvexBlocker> blockers;
  for (const auto& [a, b, c] : parts) blockers.emplace_back(ConvexPolygon::from_points({a, b, c}));
  return blockers;
}

}  // namespace

std::vector<MeshedBoardRow> meshed_board(Effort effort) {
  const Light lamp =
      AreaLight{ConvexPolygon::from_points({{-1.5, -1.5, 4}, {-1.5, 1.5, 4}, {1.5, 1.5, 4}, {1.5, -1.5, 4}})};
  std::vector<Point3> points;
  Draws draws(24);
  LightVisibility whole(lamp, PreparedObstacles({board_of(1), {}}));
  for (const std::size_t wanted = effort == Effort::quick ? 50 : 500; points.size() < wanted;) {
    const double x = draws.between(-1, 1), y = draws.between(-1, 1);
    const Point3 p{x, y, draws.between(-2, 2)};
    if (whole.at(p).region == Region::umbra) points.push_back(p);
  }
  double whole_volume = 0;
  std::vector<MeshedBoardRow> rows;
  for (std::size_t n = 1; n <= 1024; n *= 4) {
    const std::vector<ConvexBlocker> parts = board_of(n);
    LightVisibility together(lamp, PreparedObstacles({parts, {}}));
    for (const Point3& p : points) {
      if (together.at(p).region != Region::umbra) throw PreconditionError("a board in pieces lets light through");
    }
    // No two pieces hide the whole lamp from one point: their umbrae have no volume in common.
    double volume = 0;
    for (const ConvexBlocker& part : parts)
      volume += shadow_meshes(lamp, part, board_box, umbra_alone).umbra.volume.nearest;
    if (n == 1) whole_volume = volume;
    rows.push_back({n, volume / whole_volume});
  }
  return rows;
}

std::string meshed_board_section(const std::vector<MeshedBoardRow>& rows) {
  if (rows.empty()) return {};
  std::vector<Row> table = {{"triangles of the board", "share of the umbra that single triangles hide alone"}};
  for (const MeshedBoardRow& row : rows) table.push_back({std::to_string(row.triangles), short_text(row.share)});
  return "\n## A board in ever more triangles\n\n"
         "[P93] remarks that a finely meshed blocker has tiny umbrae and one large joint one. A square lamp of side 3\n"
         "at the height 4, a board of side 2 at the height 2: methods that label a point by single blockers ([CF91] "
         "and\n"
         "others) find ever less of its umbra, by volume, while behind all triangles together it stays the same,\n"
         "exactly.\n\n" +
         markdown_table(table) + "\n";
}

}  // namespace gnomon::report
