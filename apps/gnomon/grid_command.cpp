#include <array>
#include <atomic>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/light_groups.h"
#include "apps/gnomon/linear_search_option.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/region_finder.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/shadow_summary.h"
#include "apps/gnomon/text.h"
#include "apps/gnomon/viewed_surface.h"
#include "geometry/parallel.h"
#include "gnomon/irradiance.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"
#include "gnomon/writer.h"

namespace gnomon {
namespace {

struct GridOptions : CommonOptions {
  std::string shape;
  std::string normal;
  std::string eye;
  std::string material;
  std::string out;
};

void add_options(CommandLine& app, GridOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_required_text(app, "--shape", options.shape, "nx,ny,nz",
                    "Number of points along x, y and z; in scenes of dimension 2 nx,ny");
  add_text(app, "--box", options.box, "xmin,ymin,zmin,xmax,ymax,zmax",
           "The grid runs from corner to corner of this box (default: the scene's, grown by half its diagonal); a\n"
           "single point along an axis lies in the middle");
  add_required_text(app, "--out", options.out, "FILE.vti", "Write this file");
  add_text(app, "--normal", options.normal, "x,y,z",
           "Take every point as one of a surface with this normal: what it receives before its plane, and irradiance");
  add_text(app, "--eye", options.eye, "x,y,z|camera",
           "With --normal: also the radiance that it reflects to an eye here, or to that of the scene's camera");
  add_text(app, "--material", options.material, "NAME",
           "With --eye: what the points are made of, as for gnomon radiance");
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_linear_search_option(app, options);
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "The file holds VTK image data with the point arrays region (0 lit, 1 penumbra, 2 umbra, 3 unlit),\n"
      "visible_fraction and error_bound; of several lights, with _NAME behind each. With --normal it holds irradiance\n"
      "and irradiance_error_bound in W/m^2 too, with _NAME likewise; with --eye radiance and radiance_error_bound in\n"
      "W/(m^2 sr), red, green and blue, of all lights asked for and of ambient light together.\n\n"
      "Examples:\n"
      "  gnomon grid examples/figure_4_22.scene.json --shape 40,40,40 --out grid.vti\n"
      "  gnomon grid examples/cornell_box.scene.json --shape 9,9,9 --out room.vti\n");
}

/// Throws: UsageError.
std::array<std::uint32_t, 3> grid_shape(const std::string& text, int dimension) {
  if (dimension == 3) return whole_numbers<3>("--shape", text, "nx,ny,nz");
  const std::string_view flat = text.ends_with(",1") && comma_separated(text).size() == 3
                                    ? std::string_view(text).substr(0, text.size() - 2)
                                    : std::string_view(text);
  const auto [nx, ny] = whole_numbers<2>("--shape", std::string(flat), "nx,ny in a scene of dimension 2");
  return {nx, ny, 1};
}

/// What the points of a grid are asked as points of a surface.
class SurfaceOfGrid {
 public:
  SurfaceOfGrid(const SpaceScene& scene, const GridOptions& options)
      : normal_(normal_of(options.normal)),
        groups_(chosen_groups(scene, options.light)),
        chosen_(parts_of(groups_)),
        unit_(*length_unit_named(scene.length_unit)),
        obstacles_(scene_bodies(scene).obstacles),
        lights_(thread_count(options.threads)) {
    for (std::vector<LightIrradiance>& own : lights_) {
      for (const SceneLight* light : chosen_) {
        own.emplace_back(light->shape, light->strength, obstacles_, linear_search(options));
      }
    }
    if (options.eye.empty()) return;
    eye_ = eye_named(options.eye, scene);
    const Material& material = chosen_material(options.material, "", scene).material;
    seen_.emplace(scene, groups_, material, obstacles_,
                  SurfaceViewers{static_cast<unsigned>(lights_.size()), linear_search(options)});
  }

  bool has_eye() const { return seen_.has_value(); }
  std::array<double, 3> normal() const { return {normal_.x, normal_.y, normal_.z}; }

  /// Puts irradiance, and radiance to an eye, where they belong to the point of this index.
  void tell(std::size_t i, const Point3& p, std::size_t worker, std::vector<GridValues>& values,
            GridRadiance& radiance) {
    const ReceiverPoint receiver = resting_point(obstacles_, p, normal_);
    std::vector<Irradiance> of_parts;
    for (std::size_t l = 0; l < chosen_.size(); ++l) {
      of_parts.push_back(per_square_metre(lights_[worker][l].received(receiver, normal_), chosen_[l]->shape, unit_));
    }
    const std::vector<Irradiance> received = irradiance_of_groups(groups_, of_parts);
    for (std::size_t l = 0; l < received.size(); ++l) {
      values[l].irradiance[i] = received[l].value;
      values[l].irradiance_error_bound[i] = received[l].error_bound;
    }
    if (!seen_) return;
    const RadianceRgb total = seen_->at(worker, receiver, normal_, eye_).total();
    for (std::size_t c = 0; c < 3; ++c) {
      radiance.radiance[3 * i + c] = total[c].value;
      radiance.error_bound[3 * i + c] = total[c].error_bound;
    }
  }

 private:
  static Point3 normal_of(const std::string& text) {
    const std::vector<std::string_view> parts = comma_separated(text);
    std::array<double, 3> n{};
    if (parts.size() != 3) throw UsageError("--normal: found '" + text + "', expected x,y,z");
    for (std::size_t k = 0; k < 3; ++k) n[k] = finite_value("--normal", std::string(parts[k]), "x,y,z");
    if (n == std::array<double, 3>{})
      throw UsageError("--normal: found '" + text + "', expected a vector that is not 0");
    return {n[0], n[1], n[2]};
  }

  Point3 normal_;
  std::vector<LightGroup> groups_;
  std::vector<const SceneLight*> chosen_;  ///< all parts
  LengthUnit unit_;
  PreparedObstacles obstacles_;
  std::vector<std::vector<LightIrradiance>> lights_;  ///< of every worker
  std::array<double, 3> eye_{};
  std::optional<ViewedSurface> seen_;  ///< with an eye
};

/// The surface that options speak of, if they do.
///
/// Throws: UnsupportedError for one in the plane; UsageError.
std::optional<SurfaceOfGrid> surface_of_grid(const Scene& scene, const GridOptions& options) {
  if (options.eye.empty() && !options.material.empty()) throw UsageError("--material NAME goes with --eye x,y,z");
  if (options.normal.empty() && !options.eye.empty()) throw UsageError("--eye x,y,z goes with --normal x,y,z");
  if (options.normal.empty()) return {};
  if (const auto* space = std::get_if<SpaceScene>(&scene)) return SurfaceOfGrid(*space, options);
  throw UnsupportedError(facts(scene).source + ": irradiance in scenes of dimension 2 is not available");
}

/// What the points receive of every light, and reflect.
struct GridResult {
  std::vector<GridValues> lights;
  GridRadiance radiance;
};

GridResult space_for(const PointGrid& grid, const RegionFinder& finder, const std::optional<SurfaceOfGrid>& surface) {
  GridResult result;
  const std::vector<double> zeros(grid.size());
  for (const std::string& light : finder.lights) {
    result.lights.push_back(
        {finder.lights.size() > 1 ? '_' + light : "", std::vector<std::uint8_t>(grid.size()), zeros, zeros});
    if (surface) result.lights.back().irradiance = result.lights.back().irradiance_error_bound = zeros;
  }
  if (surface && surface->has_eye()) {
    result.radiance = {std::vector<double>(3 * grid.size()), std::vector<double>(3 * grid.size())};
  }
  return result;
}

GridResult grid_values(const PointGrid& grid, const RegionFinder& finder, std::optional<SurfaceOfGrid>& surface,
                       const GridOptions& options) {
  GridResult result = space_for(grid, finder, surface);
  Progress progress("point", grid.size(), progress_visibility(options.quiet, false));
  for_all(grid.size(), finder.threads, [&](std::size_t i, std::size_t worker) {
    const Point3 p = grid.point(i);
    const std::array<double, 3> place{p.x, p.y, p.z};
    const std::vector<Visibility> seen =
        surface ? finder.received(worker, place, surface->normal()) : finder.at(worker, place);
    for (std::size_t l = 0; l < seen.size(); ++l) {
      result.lights[l].region[i] = static_cast<std::uint8_t>(seen[l].region);
      result.lights[l].visible_fraction[i] = seen[l].fraction;
      result.lights[l].error_bound[i] = seen[l].error_bound;
    }
    if (surface) surface->tell(i, p, worker, result.lights, result.radiance);
    progress.step();
  });
  return result;
}

}  // namespace

ExitCode grid_command(Arguments arguments) {
  CommandLine app(
      "Tells for the points of a grid what they receive of each light behind all blockers together, as VTK image\n"
      "data: the region, decided exactly, the visible fraction, and a bound of its error; of points of a surface\n"
      "irradiance and radiance too.",
      "gnomon grid");
  GridOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  require_place("--out", options.out, OutputKind::image);
  require_unread("--out", options.out, {options.scene});
  const Scene scene = scene_file_with_warnings(options.scene);
  const std::array<std::uint32_t, 3> shape = grid_shape(options.shape, dimension(scene));
  const RegionFinder finder = region_finder(scene, options.light, options.threads, linear_search(options, scene));
  std::optional<SurfaceOfGrid> surface = surface_of_grid(scene, options);
  const Box3 box = clip_box(scene, options.box);
  const PointGrid grid = PointGrid::in_box(shape, box);
  if (!grid.has_distinct_points()) {
    throw UsageError("--shape " + options.shape + ": in the box " + box_text(box, dimension(scene)) +
                     " neighbouring points would fall together; expected fewer points, or a larger box");
  }
  const GridResult result = grid_values(grid, finder, surface, options);
  write_grid(grid, result.lights, scene, options.out, result.radiance);
  if (!options.quiet) std::cout << options.out << ": " << counted(grid.size(), "point") << '\n';
  return ExitCode::done;
}

}  // namespace gnomon
