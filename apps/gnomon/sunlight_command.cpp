#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/shadow_json.h"
#include "apps/gnomon/sunlight_output.h"
#include "apps/gnomon/text.h"
#include "geometry/parallel.h"
#include "gnomon/errors.h"
#include "gnomon/scene.h"
#include "gnomon/sunlight.h"

namespace gnomon {
namespace {

struct SunlightOptions : CommonOptions {
  std::string at;
  std::string out;
  std::string latitude;
  std::string declination;
  std::string north;
  std::uint32_t day = 0;
};

void add_options(CommandLine& app, SunlightOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_required_text(app, "--at", options.at, "POINTS.csv|-",
                    "Points as CSV with columns x,y,z or x,y,z,nx,ny,nz; '-' reads them from stdin");
  add_required_text(app, "--latitude", options.latitude, "D", "Degrees, north positive");
  app.add_number("--day", options.day, "N", 1, 366,
                 "Day of the year: declination 23.44 sin(360 (284 + N)/365) degrees");
  add_text(app, "--declination", options.declination, "D",
           "The sun's declination in degrees, instead of --day (default: 0, an equinox)");
  add_text(app, "--north", options.north, "x,y,z", "Which way is north (default: y; where y points up, -z)");
  add_text(app, "--out", options.out, "FILE", "Write the CSV to this file (default: to stdout)");
  add_json_option(app, options);
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Tells for each point when the sun shines on it through one day: above the horizon, before the point's normal\n"
      "where it has one, behind no blocker. The scene's lights do not matter. Each row of the input is followed by\n"
      "hours,error_bound,intervals; the JSON names what each interval begins and ends with: the horizon, an edge of a\n"
      "blocker. Hours are of local solar time, 12 where the sun is highest: clock time, the equation of time,\n"
      "refraction and the sun's disc of half a degree are left to the caller.\n\n"
      "Examples:\n"
      "  gnomon sunlight examples/dial.scene.json --at examples/dial.csv --latitude 37\n"
      "  gnomon sunlight examples/desk.scene.json --at examples/dial.csv --latitude 52\n");
}

SunDay day_of(const SunlightOptions& options, const SpaceScene& scene) {
  SunDay day;
  day.latitude = finite_value("--latitude", options.latitude, "degrees from -90 to 90");
  if (std::fabs(day.latitude) > 90) {
    throw UsageError("--latitude: found '" + options.latitude + "', expected degrees from -90 to 90");
  }
  if (options.day != 0 && !options.declination.empty()) throw UsageError("--day and --declination do not go together");
  if (options.day != 0) day.declination = declination_of_day(options.day);
  constexpr const char* degrees = "degrees from -23.44 to 23.44";
  if (!options.declination.empty()) day.declination = finite_value("--declination", options.declination, degrees);
  if (std::fabs(day.declination) > 23.44) {
    throw UsageError("--declination: found '" + options.declination + "', expected " + degrees);
  }
  if (scene.up == UpAxis::y) day = {day.latitude, day.declination, {0, 1, 0}, {0, 0, -1}};
  if (options.north.empty()) return day;
  const auto parts = comma_separated(options.north);
  const std::string expected = "x,y,z, level and not zero";
  if (parts.size() != 3) throw UsageError("--north: found '" + options.north + "', expected " + expected);
  const auto number = [&](std::size_t k) { return finite_value("--north", std::string(parts[k]), expected); };
  day.north = {number(0), number(1), number(2)};
  const double height = scene.up == UpAxis::y ? day.north.y : day.north.z;
  if (height != 0 || day.north == Point3{}) {
    throw UsageError("--north: found '" + options.north + "', expected " + expected);
  }
  return day;
}

/// What has been worked out of a table.
struct SunlitTable {
  std::vector<SunlitRow> kept;  ///< for the JSON
  std::size_t points = 0, malformed = 0, tied = 0;
  double hours = 0;
};

std::vector<SunlitRow> sunlit_rows(std::vector<TableRow> rows, const std::string& file, const DaySunlight& sun,
                                   bool has_normals, unsigned threads, SunlitTable& table) {
  std::vector<SunlitRow> good;
  for (TableRow& row : rows) {
    if (auto* point = std::get_if<PointRow>(&row)) {
      good.push_back({std::move(*point), {}});
      continue;
    }
    const auto& malformed = std::get<MalformedRow>(row);
    print_error(file + ':' + std::to_string(malformed.line) + ": " + malformed.problem);
    ++table.malformed;
  }
  for_all(good.size(), threads, [&](std::size_t i, std::size_t) {
    const auto& [x, y, z] = good[i].row.coordinates;
    const auto& [nx, ny, nz] = good[i].row.normal;
    SunPoint point{{x, y, z}, {}};
    if (has_normals) point.normal = Point3{nx, ny, nz};
    good[i].day = sun.at(point);
  });
  for (const SunlitRow& row : good) {
    ++table.points;
    table.tied += row.day.tied ? 1 : 0;
    table.hours += row.day.hours;
  }
  return good;
}

ExitCode write_sunlight(const SunlightOptions& options, const SpaceScene& scene, const SunDay& day,
                        std::istream& stream, const std::string& file) {
  const SceneBodies bodies = scene_bodies(scene);
  const DaySunlight sun(bodies.obstacles, day);
  PointTable table(stream, file, TableColumns::points_perhaps_with_normals);
  std::optional<OutputFile> csv_file;
  if (!options.out.empty()) csv_file.emplace(options.out);
  const bool writes_csv = csv_file || options.json != "-";
  std::ostream& csv = csv_file ? csv_file->stream() : std::cout;
  if (writes_csv) csv << table.header() << ",hours,error_bound,intervals\n";
  SunlitTable result;
  Progress progress("point", 0, progress_visibility(options.quiet, options.out.empty()));
  const unsigned threads = thread_count(options.threads);
  for (auto rows = next_rows(table); !rows.empty(); rows = next_rows(table)) {
    progress.step(rows.size());
    std::vector<SunlitRow> good = sunlit_rows(std::move(rows), file, sun, table.has_normals(), threads, result);
    if (writes_csv) write_sunlight_rows(csv, good);
    if (!options.json.empty()) std::ranges::move(good, std::back_inserter(result.kept));
    progress.set_share(share_read(stream, options.at));
  }
  if (!options.json.empty()) write_json(sunlight_json(scene, day, result.kept, bodies.names), options.json);
  if (csv_file) csv_file->publish();
  if (result.tied > 0) {
    print_warning("of " + counted(result.tied, "point") +
                  " some events follow each other so closely that their order is not certain: they are taken as one");
  }
  if (!options.quiet && csv_file && options.json != "-" && result.points > 0) {
    std::cout << counted(result.points, "point") << ", " << rounded_text(result.hours / double(result.points))
              << " hours of sun on average\n";
  }
  return result.malformed == 0 ? ExitCode::done : ExitCode::bad_scene;
}

}  // namespace

ExitCode sunlight_command(Arguments arguments) {
  CommandLine app("Tells when the sun shines on points through one day, to the moment, and what hides it.",
                  "gnomon sunlight");
  SunlightOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  require_table_places(options.out, options.json, {options.scene, options.at});
  if (options.out == "-") options.out.clear();
  const SpaceScene scene = space_scene_with_warnings(options.scene, "sunlight");
  const SunDay day = day_of(options, scene);
  return with_points(options.at, [&](std::istream& stream, const std::string& file) {
    return write_sunlight(options, scene, day, stream, file);
  });
}

}  // namespace gnomon
