#include "apps/proof/report/search_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "apps/proof/report/paper_scenes.h"
#include "apps/proof/report/stopwatch.h"
#include "apps/proof/report/tables.h"
#include "geometry/visibility/common_part.h"
#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/linear_search/occluder_index.h"

namespace gnomon::report {
namespace {

constexpr std::array<std::uint32_t, 6> grid_sides = {5, 10, 15, 20, 25, 50};
constexpr std::array<std::uint32_t, 7> buffer_sections = {1, 24, 36, 72, 144, 360, 720};

std::vector<LinearSearch> paper_searches() {
  std::vector<LinearSearch> all = {{OccluderSearch::plane}};
  for (const std::uint32_t n : grid_sides) all.push_back({OccluderSearch::grid, n});
  for (const std::uint32_t k : buffer_sections) all.push_back({OccluderSearch::light_buffer, k});
  all.push_back({OccluderSearch::hierarchy});
  all.push_back({OccluderSearch::light_hierarchy});
  return all;
}

/// Blockers in the triangle of each point, on the average; no search misses one of them (LL1).
double needed_occluders(const PaperScene& scene, const BlockerSet& blockers) {
  FastLinearVisibility visibility(scene.light, blockers);
  std::size_t count = 0;
  for (const Point3& p : scene.points) {
    const auto found = visibility.occluders(p);
    if (!found) continue;
    const std::array triangle{p, scene.light.start, scene.light.end};
    count += static_cast<std::size_t>(std::ranges::count_if(
        *found, [&](std::uint32_t b) { return viewpoint::have_common_point(blockers.content(), b, triangle); }));
  }
  return static_cast<double>(count) / static_cast<double>(scene.points.size());
}

SearchRow search_row(const PaperScene& scene, const BlockerSet& blockers, const LinearSearch& search, Effort effort) {
  const auto index = std::make_shared<const viewpoint::OccluderIndex>(scene.light, blockers, search);
  SearchRow row{scene.name, search, blockers.size(), index->references()};
  const auto ask_all = [&] {
    FastLinearVisibility visibility(scene.light, index);
    for (const Point3& p : scene.points) visibility.visible_from(p);
    return visibility.search_counts();
  };
  const viewpoint::SearchCounts counts = ask_all();
  const auto questions = static_cast<double>(scene.points.size());
  row.candidates = static_cast<double>(counts.candidates) / questions;
  row.visited = static_cast<double>(counts.visited) / questions;
  row.seconds =
      time_per_result(ask_all, scene.points.size(), effort == Effort::quick ? Care{1, 0} : Care{3, 0.05}).least;
  return row;
}

/// Rows of one scene.
std::vector<SearchRow> of_scene(const std::vector<SearchRow>& rows, const std::string& scene) {
  std::vector<SearchRow> own;
  std::ranges::copy_if(rows, std::back_inserter(own), [&](const SearchRow& row) { return row.scene == scene; });
  return own;
}

const SearchRow& row_with(const std::vector<SearchRow>& rows, const LinearSearch& search) {
  return *std::ranges::find(rows, search, &SearchRow::search);
}

/// Table II: a grid in use for the light triangle, relative to one of 5 x 5 x 5 that is not.
struct PrintedGrids {
  const char* scene;
  std::array<double, 6> active;
};
constexpr std::array<PrintedGrids, 2> printed_grids = {
    PrintedGrids{"sphereflake", {1.2342, .7969, .9722, .8245, .8696, 1.5742}},
    PrintedGrids{"tetrahedron", {1.2532, .5239, .2925, .2689, .2385, .3740}}};

/// Table III: light buffers by the grid that finds what the eye sees, relative to a grid of one voxel and one section.
struct PrintedBuffers {
  const char* scene;
  std::array<std::array<double, 7>, 7> by_grid;
};
constexpr std::array<int, 7> printed_sides = {1, 5, 10, 15, 20, 25, 50};
constexpr std::array<PrintedBuffers, 2> printed_buffers = {
    PrintedBuffers{"sphereflake",
                   {{{1.0000, .6656, .6291, .5751, .5505, .5332, .5281},
                     {1.0270, .6834, .6449, .5916, .5678, .5471, .5497},
                     {.9304, .5809, .5446, .4876, .4676, .4479, .4466},
                     {.9266, .5782, .5392, .4858, .4644, .4449, .4411},
                     {.9103, .5606, .5229, .4796, .4481, .4280, .4258},
                     {.8979, .5486, .5112, .4688, .4347, .4156, .4130},
                     {.8863, .5366, .4974, .4579, .4212, .4031, .3990}}}},
    PrintedBuffers{"tetrahedron",
                   {{{1.0000, .9732, .9508, .9425, .9236, .9120, .9127},
                     {.1429, .0455, .0410, .0359, .0333, .0318, .0314},
                     {.1275, .0303, .0256, .0206, .0180, .0166, .0160},
                     {.1246, .0418, .0227, .0177, .0151, .0138, .0132},
                     {.1237, .0384, .0223, .0168, .0142, .0128, .0123},
                     {.1231, .0341, .0214, .0163, .0138, .0122, .0117},
                     {.1235, .0534, .0209, .0159, .0133, .0118, .0114}}}}};

/// The four entries of the tetrahedron's second column that are Table II's light triangles in Table III's unit.
bool is_misprinted(const std::string& scene, std::size_t grid, std::size_t section) {
  return scene == "tetrahedron" && section == 1 && grid >= 3;
}

std::string grid_table(const std::vector<SearchRow>& rows, const PrintedGrids& printed) {
  std::vector<Row> table = {{"voxels", "candidates", "voxels met", "candidates + 0.3 voxels, relative to 5³",
                             "references", "time relative to each blocker against the plane", "printed"}};
  const auto cost = [](const SearchRow& row) { return row.candidates + 0.3 * row.visited; };
  const double plane = row_with(rows, {OccluderSearch::plane}).seconds;
  const double first = cost(row_with(rows, {OccluderSearch::grid, grid_sides[0]}));
  for (std::size_t k = 0; k < grid_sides.size(); ++k) {
    const SearchRow& row = row_with(rows, {OccluderSearch::grid, grid_sides[k]});
    table.push_back({std::to_string(grid_sides[k]) + "³", short_text(row.candidates), short_text(row.visited),
                     short_text(cost(row) / first), std::to_string(row.references), short_text(row.seconds / plane),
                     full_text(printed.active[k])});
  }
  return markdown_table(table);
}

std::string buffer_table(const std::vector<SearchRow>& rows, const PrintedBuffers& printed) {
  Row head = {"sections", "candidates", "references", "time relative to one section"};
  for (const int n : printed_sides) head.push_back("printed, " + std::to_string(n) + "³");
  std::vector<Row> table = {head};
  const double first = row_with(rows, {OccluderSearch::light_buffer, 1}).seconds;
  for (std::size_t k = 0; k < buffer_sections.size(); ++k) {
    const SearchRow& row = row_with(rows, {OccluderSearch::light_buffer, buffer_sections[k]});
    Row cells = {std::to_string(buffer_sections[k]), short_text(row.candidates), std::to_string(row.references),
                 short_text(row.seconds / first)};
    for (std::size_t g = 0; g < printed_sides.size(); ++g) {
      const std::string text = full_text(printed.by_grid[g][k]);
      cells.push_back(is_misprinted(printed.scene, g, k) ? "*" + text + "*" : text);
    }
    table.push_back(std::move(cells));
  }
  return markdown_table(table);
}

std::string peers_table(const std::vector<SearchRow>& rows) {
  std::vector<Row> table = {
      {"search", "needed", "candidates", "candidates / needed", "nodes or voxels", "references", "time of a question"}};
  for (const LinearSearch& search :
       {LinearSearch{OccluderSearch::plane}, LinearSearch{OccluderSearch::grid, 25},
        LinearSearch{OccluderSearch::light_buffer, 720}, LinearSearch{OccluderSearch::hierarchy},
        LinearSearch{OccluderSearch::light_hierarchy}}) {
    const SearchRow& row = row_with(rows, search);
    const std::string parts = search.parts > 0 ? "=" + std::to_string(search.parts) : "";
    table.push_back({std::string(name(search.strategy)) + parts, short_text(row.needed), short_text(row.candidates),
                     short_text(row.candidates / row.needed), short_text(row.visited), std::to_string(row.references),
                     time_text(row.seconds)});
  }
  return markdown_table(table);
}

}  // namespace

std::vector<SearchRow> search_tables(Effort effort) {
  const std::size_t points = effort == Effort::quick ? 100 : 2000;
  std::vector<SearchRow> rows;
  for (const PaperScene& scene : {sphereflake(2, points), tetrahedron_pyramid(5, points)}) {
    const BlockerSet blockers(scene.blockers);
    const double needed = needed_occluders(scene, blockers);
    for (const LinearSearch& search : paper_searches()) {
      rows.push_back(search_row(scene, blockers, search, effort));
      rows.back().needed = needed;
    }
  }
  return rows;
}

std::string search_tables_section(const std::vector<SearchRow>& rows) {
  if (rows.empty()) return {};
  std::string text =
      "\n## Tables II and III of [PA90] and [P93]\n\n"
      "How blockers are found that may hide a linear light, in counts for a question, which no machine changes, and "
      "in\n"
      "times relative to each other. The scenes are a tetrahedron of 1,024 tetrahedra and a sphereflake of 91 spheres "
      "on "
      "a\nsquare; light and points are not printed and chosen here, and spheres are solids of 320 triangles, which "
      "leave "
      "out\nup to " +
      short_text(icosphere_deviation()) +
      " of a radius. The papers' times are those of whole pictures by a ray tracer of another\n"
      "machine; here they are those of search and exact visible intervals together.\n\n"
      "Entries of Table III in italics are misprinted: four times, by the tetrahedron with 24 sections, Table II's "
      "light\n"
      "triangle stands in place of the light buffer (.1429 times .2925, .2689, .2385 and .3740). By its neighbours "
      "the\n"
      "buffer's times are about .025 to .027.\n\n";
  for (std::size_t s = 0; s < printed_grids.size(); ++s) {
    const std::vector<SearchRow> own = of_scene(rows, printed_grids[s].scene);
    const std::string of =
        std::string(printed_grids[s].scene) + ", " + std::to_string(own.front().blockers) + " blockers";
    text += "### Table II, light triangle in a grid: " + of + "\n\n" + grid_table(own, printed_grids[s]) +
            "\n### Table III, light buffer: " + of + "\n\n" + buffer_table(own, printed_buffers[s]) +
            "\n### The searches beside each other: " + of + "\n\n" + peers_table(own) + "\n";
  }
  return text;
}

}  // namespace gnomon::report
