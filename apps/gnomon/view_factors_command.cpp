#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/started_processes.h"
#include "apps/gnomon/text.h"
#include "apps/gnomon/view_factor_output.h"
#include "apps/gnomon/view_surfaces.h"
#include "geometry/parallel.h"
#include "gnomon/receiver_mesh.h"
#include "gnomon/scene.h"
#include "gnomon/view_factors.h"
#include "gnomon/writer.h"

namespace gnomon {
namespace {

struct ViewFactorOptions : CommonOptions {
  std::string out;
  std::string npy;
  std::string vtk;
  std::string bound = "1e-9";
  std::string from;
  std::string enforce;
  bool faces = false;
  bool open = false;
  bool twice = false;
};

void add_options(CommandLine& app, ViewFactorOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_text(app, "--out", options.out, "F.csv", "Write the factors to this file (default: to stdout)");
  add_text(app, "--npy", options.npy, "F.npy",
           "Write the whole matrix, and its bounds as F_bound.npy, as NumPy reads them");
  add_text(app, "--vtk", options.vtk, "DIR",
           "Write the surfaces with their row sums as DIR/view_factors.vtp, which ParaView opens");
  add_json_option(app, options);
  app.add_flag("--faces", options.faces,
               "Take the facets of the blockers from outside for surfaces, instead of the receivers");
  add_text(app, "--from", options.from, "NAME", "Only factors from this surface");
  add_text(app, "--bound", options.bound, "B", "How far each factor may be off (default: 1e-9)");
  app.add_flag("--open", options.open, "Also tell the rest of each row, as a factor to \"sky\"");
  app.add_flag("--twice", options.twice,
               "Work each pair out from both sides, and tell how far A_i F_ij and A_j F_ji are apart");
  add_text(app, "--enforce", options.enforce, "E.csv",
           "Also write factors that were scaled until all row sums are 1: consistent, not more true");
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "The factor from one surface to another is the share of what the first sends out, alike in all directions,\n"
      "that reaches the second behind all blockers. Surfaces are the sides of the scene's receivers; lights do not\n"
      "matter. The CSV has the columns from,to,area,factor,error_bound,bound_is; factors that are 0 are left out.\n"
      "|factor - exact| is at most error_bound where bound_is says proven: where nothing stands between the two, or\n"
      "one sees the other in lit parts alone. Elsewhere it is an estimate: the difference of two rules of Gauss on\n"
      "the exact regions of what is seen. Nothing is repaired: in a closed room row sums are 1 up to the bounds.\n\n"
      "Examples:\n"
      "  gnomon view-factors examples/shapiro.scene.json\n"
      "  gnomon view-factors examples/cornell_box.scene.json --faces --out F.csv\n");
}

/// Throws: UsageError.
double bound_of(const std::string& text) {
  const double bound = finite_value("--bound", text, "a number larger than 0");
  if (!(bound > 0)) throw UsageError("--bound: found '" + text + "', expected a number larger than 0");
  return bound;
}

void check_usage(const ViewFactorOptions& options) {
  const std::vector<std::string> read = {options.scene};
  require_table_places(options.out, options.json, read);
  require_place("--enforce", options.enforce, OutputKind::csv);
  require_unread("--enforce", options.enforce, read);
  require_unread("--npy", options.npy, read);
  if (!options.npy.empty() && !options.npy.ends_with(".npy")) {
    throw UsageError("--npy " + options.npy + ": expected a file that ends in .npy");
  }
  if (!options.vtk.empty()) require_place("--vtk", options.vtk, OutputKind::folder);
  if (!options.enforce.empty() && (!options.from.empty() || options.open)) {
    throw UsageError("--enforce takes all rows of a closed room: it goes with neither --from nor --open");
  }
}

std::optional<std::uint32_t> number_of(const std::string& name, const ViewSurfaces& surfaces) {
  if (name.empty()) return std::nullopt;
  const auto found = std::ranges::find(surfaces.names, name);
  if (found != surfaces.names.end()) return static_cast<std::uint32_t>(found - surfaces.names.begin());
  constexpr std::size_t most_names = 20;
  std::string known;
  for (std::size_t s = 0; s < std::min(most_names, surfaces.names.size()); ++s) {
    known += (known.empty() ? "'" : ", '") + surfaces.names[s] + "'";
  }
  if (surfaces.names.size() > most_names)
    known += " and " + std::to_string(surfaces.names.size() - most_names) + " more";
  throw UsageError("--from: found no surface '" + name + "', expected one of " + (known.empty() ? "none" : known));
}

void tell_size(const std::string& npy, std::size_t surfaces) {
  const double bytes = 8.0 * static_cast<double>(surfaces) * static_cast<double>(surfaces);
  if (npy.empty() || bytes < 2e9) return;
  print_warning(npy + " and its bounds will take " + rounded_text(bytes / 1e9) +
                " GB each: " + counted(surfaces, "surface"));
}

ViewFactors worked_out(const ViewFactorOptions& options, const ViewSurfaces& surfaces, const Obstacles& obstacles,
                       const std::optional<std::uint32_t>& from) {
  std::size_t pieces = 0;
  for (const ViewSurface& shape : surfaces.shapes) pieces += shape.size();
  Progress progress("piece", pieces, progress_visibility(options.quiet, options.out.empty()));
  ViewFactorEffort effort;
  effort.bound = bound_of(options.bound);
  effort.threads = thread_count(options.threads);
  effort.from = from;
  effort.twice = options.twice;
  effort.processes = started_processes();
  effort.progress = [&](std::size_t, std::size_t) { progress.step(); };
  return view_factors(surfaces.shapes, obstacles, effort);
}

void write_csv(const std::string& file, const ViewSurfaces& surfaces, const ViewFactors& factors,
               const std::optional<std::uint32_t>& from, bool open) {
  OutputFile output(file);
  write_factors_csv(output.stream(), surfaces, factors, from, open);
  output.publish();
}

void write_all(const ViewFactorOptions& options, const Scene& scene, const ViewSurfaces& surfaces, ViewFactors factors,
               const std::optional<std::uint32_t>& from) {
  const double bound = bound_of(options.bound);
  if (!options.npy.empty()) write_npy(options.npy, factors);
  if (!options.vtk.empty()) {
    std::vector<SurfaceRow> rows;
    const std::vector<RowSum> sums = row_sums(factors);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      rows.push_back({surfaces.names[i], &surfaces.shapes[i], sums[i].value, sums[i].error_bound});
    }
    write_view_surfaces(rows, scene, options.vtk);
  }
  if (!options.json.empty()) write_json(factors_json(scene, surfaces, factors, from, bound), options.json);
  if (!options.out.empty()) {
    write_csv(options.out, surfaces, factors, from, options.open);
  } else if (options.json != "-") {
    write_factors_csv(std::cout, surfaces, factors, from, options.open);
  }
  const bool tells = !options.quiet && !options.out.empty() && options.json != "-";
  if (tells) std::cout << factors_summary(factors, from, bound);
  if (options.enforce.empty()) return;
  const double left = enforce_closure(factors);
  write_csv(options.enforce, surfaces, factors, from, false);
  if (tells) std::cout << options.enforce << ": scaled so that row sums are 1, up to " << rounded_text(left) << '\n';
}

}  // namespace

ExitCode view_factors_command(Arguments arguments) {
  CommandLine app(
      "Tells view factors between the surfaces of a scene behind all blockers together, each with a bound of its\n"
      "error.",
      "gnomon view-factors");
  ViewFactorOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  check_usage(options);
  if (options.out == "-") options.out.clear();
  bound_of(options.bound);
  const Scene scene = shapes_file_with_warnings(options.scene);
  const auto* space = std::get_if<SpaceScene>(&scene);
  if (!space) throw UnsupportedError(facts(scene).source + ": view factors need a scene of dimension 3");
  const SceneBodies bodies = scene_bodies(*space);
  const ViewSurfaces surfaces = options.faces ? blocker_surfaces(*space, bodies) : receiver_surfaces(*space);
  if (surfaces.names.empty()) {
    print_warning(facts(scene).source + ": there are no " +
                  (options.faces ? "blockers" : "receivers; --faces takes the blockers'"));
  }
  const std::optional<std::uint32_t> from = number_of(options.from, surfaces);
  require_range(*space, surfaces, bodies.obstacles);
  tell_size(options.npy, surfaces.names.size());
  ViewFactors factors = worked_out(options, surfaces, bodies.obstacles, from);
  if (is_first_process()) write_all(options, scene, surfaces, std::move(factors), from);
  return ExitCode::done;
}

}  // namespace gnomon
