#include <array>
#include <atomic>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/region_finder.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/shadow_summary.h"
#include "apps/gnomon/text.h"
#include "geometry/parallel.h"
#include "gnomon/scene.h"
#include "gnomon/writer.h"

namespace gnomon {
namespace {

struct GridOptions : CommonOptions {
  std::string shape;
  std::string out;
};

void add_options(CommandLine& app, GridOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_required_text(app, "--shape", options.shape, "nx,ny,nz",
                    "Number of points along x, y and z; in scenes of dimension 2 nz is 1");
  add_text(app, "--box", options.box, "xmin,ymin,zmin,xmax,ymax,zmax",
           "The grid runs from corner to corner of this box (default: the scene's, grown by half its diagonal); a\n"
           "single point along an axis lies in the middle");
  add_required_text(app, "--out", options.out, "FILE.vti", "Write this file");
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "The file holds VTK image data with the point arrays region (0 lit, 1 penumbra, 2 umbra, 3 unlit),\n"
      "visible_fraction and error_bound; of several lights, with _NAME behind each.\n\n"
      "Examples:\n"
      "  gnomon grid examples/figure_4_22.scene.json --shape 40,40,40 --out grid.vti\n"
      "  gnomon grid examples/cornell_box.scene.json --shape 9,9,9 --out room.vti\n");
}

std::vector<GridValues> grid_values(const PointGrid& grid, const RegionFinder& finder, const GridOptions& options) {
  std::vector<GridValues> values;
  for (const std::string& light : finder.lights) {
    values.push_back({finder.lights.size() > 1 ? '_' + light : "", std::vector<std::uint8_t>(grid.size()),
                      std::vector<double>(grid.size()), std::vector<double>(grid.size())});
  }
  Progress progress("point", grid.size(), progress_visibility(options.quiet, false));
  for_all(grid.size(), finder.threads, [&](std::size_t i, std::size_t worker) {
    const Point3 p = grid.point(i);
    const std::vector<Visibility> seen = finder.at(worker, {p.x, p.y, p.z});
    for (std::size_t l = 0; l < seen.size(); ++l) {
      values[l].region[i] = static_cast<std::uint8_t>(seen[l].region);
      values[l].visible_fraction[i] = seen[l].fraction;
      values[l].error_bound[i] = seen[l].error_bound;
    }
    progress.step();
  });
  return values;
}

}  // namespace

ExitCode grid_command(Arguments arguments) {
  CommandLine app(
      "Tells for the points of a grid what they receive of each light behind all blockers together, as VTK image\n"
      "data: the region, decided exactly, the visible fraction, and a bound of its error.",
      "gnomon grid");
  GridOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  require_place("--out", options.out, OutputKind::image);
  const std::array<std::uint32_t, 3> shape = whole_numbers<3>("--shape", options.shape, "nx,ny,nz");
  const Scene scene = scene_file_with_warnings(options.scene);
  const RegionFinder finder = region_finder(scene, options.light, options.threads);
  const Box3 box = clip_box(scene, options.box);
  const PointGrid grid = PointGrid::in_box(shape, box);
  if (!grid.has_distinct_points()) {
    throw UsageError("--shape " + options.shape + ": in the box " + box_text(box, dimension(scene)) +
                     " neighbouring points would fall together; expected fewer points, or a larger box");
  }
  write_grid(grid, grid_values(grid, finder, options), scene, options.out);
  if (!options.quiet) std::cout << options.out << ": " << counted(grid.size(), "point") << '\n';
  return ExitCode::done;
}

}  // namespace gnomon
