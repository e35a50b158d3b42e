#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/design_output.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/shadow_json.h"
#include "apps/gnomon/text.h"
#include "gnomon/light_design.h"

namespace gnomon {
namespace {

struct PlaceOptions : CommonOptions {
  std::string goals;
  std::string out;
  std::string choose = "centre";
  std::string near;
  std::string check;
  std::string expect;
  std::uint32_t most_cells = 10000;
};

void add_options(CommandLine& app, PlaceOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_required_text(app, "--goals", options.goals, "FILE", "Goals file: what is sought, where, and what is wanted");
  add_text(app, "--out", options.out, "DIR", "Write the feasible cells, their walls, goals and answer for ParaView");
  add_json_option(app, options);
  add_text(app, "--choose", options.choose, "WHICH",
           "Which feasible position: centre, of the largest ball in a cell (default); cube, of the largest cube along\n"
           "the axes; nearest, to --near; brightest, for the darkest corner of the receivers that are to be lit");
  add_text(app, "--near", options.near, "x,y,z", "With --choose nearest: to this");
  add_text(app, "--check", options.check, "x,y,z", "Only tell what becomes of every goal at this position");
  add_text(app, "--expect", options.expect, "feasible", "Exit code 5 unless there is an answer");
  app.add_number("--max-cells", options.most_cells, "N", 1, 10000000,
                 "Stop where the region falls into more cells (default: 10000)");
  add_quiet_option(app, options);
  app.footer(
      "Goals are wanted effects: a point or a receiver lit, in shadow or dark, its shadow's boundary at an edge or a\n"
      "vertex, no reflection of the light in a receiver. Sought is a point light's position, the direction to a\n"
      "directional light, a shift of a light or of a blocker. Every feasible position is found, as convex cells, and\n"
      "every decision is exact; the answer is rational and rounded once, and each goal is looked at again from the\n"
      "light's side at the printed numbers. Where nothing is feasible, a minimal set of goals that collide is told.\n\n"
      "Examples:\n"
      "  gnomon place examples/desk.scene.json --goals examples/desk.goals.json\n"
      "  gnomon place examples/overhang.scene.json --goals examples/overhang.goals.json\n");
}

Point3 point_of(const std::string& option, const std::string& text) {
  const auto parts = comma_separated(text);
  if (parts.size() != 3) throw UsageError(option + ": found '" + text + "', expected x,y,z");
  const auto number = [&](std::size_t k) { return finite_value(option, std::string(parts[k]), "x,y,z"); };
  return {number(0), number(1), number(2)};
}

DesignEffort effort_of(const PlaceOptions& options) {
  DesignEffort effort;
  effort.most_cells = options.most_cells;
  if (options.choose == "cube") {
    effort.choice = Choice::cube;
  } else if (options.choose == "nearest") {
    effort.choice = Choice::nearest;
  } else if (options.choose == "brightest") {
    effort.choice = Choice::brightest;
  } else if (options.choose != "centre") {
    throw UsageError("--choose: found '" + options.choose + "', expected centre, cube, nearest or brightest");
  }
  const bool is_nearest = effort.choice == Choice::nearest;
  if (is_nearest == options.near.empty()) throw UsageError("--choose nearest and --near x,y,z go together");
  if (is_nearest) effort.near = point_of("--near", options.near);
  return effort;
}

void check_usage(const PlaceOptions& options) {
  if (!options.out.empty()) require_place("--out", options.out, OutputKind::folder);
  require_place("--json", options.json, OutputKind::json);
  require_unread("--json", options.json, {options.scene, options.goals});
  if (!options.expect.empty() && options.expect != "feasible") {
    throw UsageError("--expect: found '" + options.expect + "', expected feasible");
  }
  if (!options.check.empty() && options.choose != "centre") throw UsageError("--check goes without --choose");
}

void require_kind(const Design& design, const DesignEffort& effort) {
  if (design.variable == FreeVariable::direction && effort.choice != Choice::centre) {
    throw UsageError("--choose: a direction has no cube and is near to no point, expected centre");
  }
}

bool has_answer(const DesignResult& result, bool is_check) {
  return is_check ? result.status == DesignStatus::feasible : result.answer.has_value();
}

void write_files(const std::string& folder, const SolvedDesign& solved) {
  std::size_t left_out = 0;
  const DrawnDesign drawn = drawn_design(solved, left_out);
  write_design(drawn, Scene(solved.scene), folder);
  if (left_out > 0) print_warning(counted(left_out, "unbounded cell") + " left out of " + folder + "/design.vtm");
}

ExitCode place(const PlaceOptions& options, const DesignEffort& effort) {
  const std::optional<Point3> check =
      options.check.empty() ? std::nullopt : std::optional(point_of("--check", options.check));
  const SpaceScene scene = space_scene_with_warnings(options.scene, "placing a light");
  const Design design = read_design(options.goals, scene);
  require_kind(design, effort);
  const DesignObstacles obstacles = design_obstacles(scene);
  DesignResult result;
  try {
    result = check ? checked_design(design, obstacles, *check) : solved_design(design, obstacles, effort);
  } catch (const DesignError& error) {
    throw UnsupportedError(options.goals + ": " + error.what());
  }
  const SolvedDesign solved{scene, design, obstacles, result, check.has_value()};
  if (!options.out.empty()) write_files(options.out, solved);
  if (!options.json.empty()) write_json(design_json(solved), options.json);
  if (!options.quiet && options.json != "-") std::cout << design_text(solved);
  const bool is_missed = !options.expect.empty() && !has_answer(result, check.has_value());
  return is_missed ? ExitCode::infeasible : ExitCode::done;
}

}  // namespace

ExitCode place_command(Arguments arguments) {
  CommandLine app(
      "Finds where a light, or a blocker, may stand so that given points and receivers are lit, dark or free of\n"
      "reflections: every position, one answer, and why there is none.",
      "gnomon place");
  PlaceOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  check_usage(options);
  return place(options, effort_of(options));
}

}  // namespace gnomon
