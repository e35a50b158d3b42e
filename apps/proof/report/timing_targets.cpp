#include "apps/proof/report/timing_targets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "apps/proof/report/tables.h"

namespace gnomon::report {
namespace {

using Findings = std::vector<Finding>;
using Text = std::function<std::string(double)>;

const Timing* timing(const Report& report, const std::string& task, std::size_t size) {
  const auto found = std::find_if(report.timings.begin(), report.timings.end(),
                                  [&](const Timing& t) { return t.task == task && t.size == size; });
  return found == report.timings.end() ? nullptr : &*found;
}

std::optional<double> seconds(const Report& report, const std::string& task, std::size_t size) {
  const Timing* found = timing(report, task, size);
  return found == nullptr ? std::nullopt : std::optional(found->seconds.median);
}

std::optional<double> memory(const Report& report, const std::string& task, std::size_t size) {
  const Timing* found = timing(report, task, size);
  return found == nullptr ? std::nullopt : std::optional(static_cast<double>(found->memory));
}

/// The time that CGAL takes for the hull of the shadows of 4 by 4 vertices, divided by what it takes where 300 ns are
/// wanted for the planes.
double hull_scale(const Report& report) {
  constexpr double hull_there = 59e-6;
  for (const Measurement& m : report.measurements) {
    if (m.task == "occlusion_volume" && m.method == "convex_hull_3" && m.size == 4)
      return m.seconds.median / hull_there;
  }
  return 1;
}

std::optional<double> quotient(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::optional(*a / *b) : std::nullopt;
}

std::string times_text(double value) {
  return short_text(value) + " times";
}

std::string megabytes_text(double bytes) {
  return short_text(bytes / 1e6) + " MB";
}

/// All of a subject that is at most so much, in one way to write it.
struct Limits {
  Findings& all;
  std::string bench;  ///< which benchmarks measure it too
  Text text;

  void add(const std::string& subject, double limit, std::optional<double> found) const {
    all.push_back({subject, "at most " + text(limit), found ? text(*found) : "", found && *found <= limit, false,
                   "./bootstrap bench " + bench});
  }
};

void add_planes(Findings& all, const Report& report) {
  const Limits ratios{all, "extremal_planes", times_text};
  for (const std::size_t n : {3U, 4U, 16U, 256U, 1024U}) {
    const std::string by = std::to_string(n) + " by " + std::to_string(n);
    ratios.add("extremal planes of " + by + " vertices, beside the same walk in plain doubles", 1.8,
               quotient(seconds(report, "exact_planes", n), seconds(report, "plain_planes", n)));
  }
  const auto growth = quotient(seconds(report, "exact_planes", 256), seconds(report, "exact_planes", 16));
  ratios.add("extremal planes, time per vertex for 256 beside 16", 1.3, quotient(growth, 256.0 / 16));
  const Limits times{all, "extremal_planes", time_text};
  const auto squares = seconds(report, "exact_planes", 4);
  times.add("extremal planes of 4 by 4 vertices", 300e-9 * machine_scale(report), squares);
  times.add("extremal planes of 4 by 4 vertices, scaled by what convex_hull_3 takes (59 µs)",
            300e-9 * hull_scale(report), squares);
}

void add_meshes(Findings& all, const Report& report) {
  const double scale = machine_scale(report);
  const Limits times{all, ".", time_text};
  const std::string of = "occlusion and umbra meshes of ";
  times.add(of + "4 by 4 vertices", 10e-6 * scale, seconds(report, "meshes", 4));
  times.add(of + "64 by 64 vertices", 150e-6 * scale, seconds(report, "meshes", 64));
  times.add(of + "a solid of 1,000 facets", 5e-3 * scale, seconds(report, "solid_meshes", 1000));
  times.add(of + "each of 5,000 triangles", scale, seconds(report, "mesh_parts", 5000));
  Limits{all, "volume_mesh", megabytes_text}.add(of + "each of 5,000 triangles, memory", 200e6,
                                                 memory(report, "mesh_parts", 5000));
  const auto growth = quotient(seconds(report, "meshes", 1024), seconds(report, "meshes", 64));
  Limits{all, "volume_mesh", short_text}.add(of + "64 by 64 to 1,024 by 1,024 vertices, exponent of growth", 1.15,
                                             growth ? std::optional(std::log(*growth) / std::log(16)) : std::nullopt);
}

void add_visibility(Findings& all, const Report& report) {
  Limits{all, "lambert_quad", time_text}.add("irradiance of a square in full view, with its bound", 100e-9,
                                             seconds(report, "lambert_quad", 1));
  const Timing* random = timing(report, "random_points", 40000);
  Limits{all, "visibility_fast", short_text}.add(
      "points of 40,000 behind random triangles that the exact level has to answer", 4,
      random == nullptr ? std::nullopt : std::optional(static_cast<double>(random->count)));
  Limits{all, "visibility_set_up", megabytes_text}.add("100,000 triangles up to the first answer, memory", 200e6,
                                                       memory(report, "set_up", 100000));
}

/// Of evaluations with their bounds, beside those of a point light with the same exponent or of the same light.
void add_reflection(Findings& all, const Report& report) {
  const Limits ratios{all, "reflection", times_text};
  const auto beside = [&](const std::string& a, std::size_t n, const std::string& b, std::size_t m) {
    return quotient(seconds(report, a, n), seconds(report, b, m));
  };
  ratios.add("a linear light's irradiance, beside a point's", 6, beside("line_diffuse", 1, "point_diffuse", 1));
  for (const std::size_t n : {10U, 50U, 200U, 10000U}) {
    const std::string lobe = "a linear light's lobe of exponent " + std::to_string(n);
    ratios.add(lobe + ", beside a point's", n == 50 ? 16 : 10, beside("line_phong", n, "point_phong", n));
  }
  ratios.add("a linear light's lobe of exponent 200, beside 10", 1.25, beside("line_phong", 200, "line_phong", 10));
  ratios.add("a linear light's Blinn lobe of exponent 50, beside Phong's", 25,
             beside("line_blinn", 50, "line_phong", 50));
  for (const auto& [n, limit] : {std::pair{1U, 5.0}, {50U, 12.0}, {200U, 30.0}}) {
    ratios.add("a rectangle's lobe of exponent " + std::to_string(n) + ", beside its irradiance", limit,
               beside("lamp_phong", n, "lamp_lambert", 1));
  }
  ratios.add("a rectangle's Blinn lobe of exponent 50, beside Phong's", 25, beside("lamp_blinn", 50, "lamp_phong", 50));
}

/// The task of that name, whatever its size.
const Timing* timing_of_any_size(const Report& report, const std::string& task) {
  const auto found = std::ranges::find(report.timings, task, &Timing::task);
  return found == report.timings.end() ? nullptr : &*found;
}

/// How much faster certified answers are than points on the light, for an error in the root mean square.
void add_reflection_peers(Findings& all, const Report& report) {
  struct PeerComparison {
    const char *subject, *task;
    int part;
    double wanted;
  };
  const PeerComparison peer_comparisons[] = {
      {"irradiance of a tube in a square's penumbra, beside points with Embree's rays", "penumbra_tube", 256, 20},
      {"irradiance of a tube in a square's penumbra, beside points with Embree's rays", "penumbra_tube", 10000, 1000},
      {"a tube's lobe of exponent 50 there, beside Embree's stratified rays", "penumbra_tube_lobe", 256, 20},
      {"a tube's lobe of exponent 50 there, beside Embree's stratified rays", "penumbra_tube_lobe", 1000, 200},
      {"a rectangle's lobe of exponent 50 there, beside Embree's stratified rays", "penumbra_lamp_lobe", 256, 20},
      {"a rectangle's lobe of exponent 50 there, beside Embree's stratified rays", "penumbra_lamp_lobe", 1000, 200},
      {"a tube's lobe of exponent 64 in the open, beside points", "open_tube_lobe", 10000, 4}};
  for (const PeerComparison& c : peer_comparisons) {
    const std::string part = std::to_string(c.part);
    const Timing* gnomon = timing_of_any_size(report, c.task);
    const Timing* points = timing_of_any_size(report, std::string(c.task) + "_at_" + part);
    const double found = gnomon && points ? points->seconds.median / gnomon->seconds.median : 0;
    const std::string count = points ? " (" + std::to_string(points->size) + " points)" : "";
    all.push_back({std::string(c.subject) + " for an RMS error of 1/" + part + " of the largest",
                   "at least " + times_text(c.wanted), found == 0 ? "" : times_text(found) + count, found >= c.wanted,
                   false, "./bootstrap bench reflection"});
  }
}

/// [PA90]'s sphere, as Table I has it.
void add_picture(Findings& all, const Report& report) {
  Limits{all, "reflection", time_text}.add("a picture of Table I's sphere, 512 by 512 pixels",
                                           3 * machine_scale(report), seconds(report, "sphere_picture", 512));
}

/// A linear light costs as much as so many points, of every primitive of Table I.
void add_table_one(Findings& all, const Report& report) {
  std::optional<double> most;
  for (const TableOneRow& row : report.table_one) {
    if (row.has_shadows) most = std::max(most.value_or(0), row.equal());
  }
  if (!most) return;  // every report measures it
  all.push_back({"a picture under one linear light, in pictures under so many points (Table I)", "at most 8 points",
                 short_text(*most) + " points", *most <= 8, false, "gnomon report --out DIR"});
}

/// The exponent with which the time grows with the faces, from few receivers to many.
std::optional<double> growth_exponent(const Timing* few, const Timing* many) {
  if (few == nullptr || many == nullptr) return std::nullopt;
  return std::log(many->seconds.median / few->seconds.median) /
         std::log(static_cast<double>(many->count) / static_cast<double>(few->count));
}

void add_stacks(Findings& all, const Report& report) {
  const std::pair<const char*, const char*> lights[] = {{"hexagon", "a distant hexagon"}, {"square", "a square"}};
  for (const auto& [name, light] : lights) {
    const std::string task = std::string(name) + "_stacks", bench = "stacks_under_.*" + std::string(name);
    const std::string of = "receivers of stacks of boxes under " + std::string(light);
    if (task == "hexagon_stacks") {
      const Limits times{all, bench, time_text};
      times.add("1,201 " + of, 1, seconds(report, task, 1201));
      times.add("3,073 " + of, 3.5, seconds(report, task, 3073));
    }
    Limits{all, bench, short_text}.add("193 to 3,073 " + of + ", exponent of growth with the faces", 1.15,
                                       growth_exponent(timing(report, task, 193), timing(report, task, 3073)));
    Limits{all, bench, megabytes_text}.add("3,073 " + of + ", memory", 300e6, memory(report, task, 3073));
  }
}

}  // namespace

double machine_scale(const Report& report) {
  return seconds(report, "plain_planes", 4).value_or(plain_planes_there) / plain_planes_there;
}

std::vector<Finding> timing_findings(const Report& report) {
  Findings all;
  add_planes(all, report);
  add_meshes(all, report);
  add_reflection(all, report);
  add_reflection_peers(all, report);
  add_picture(all, report);
  add_table_one(all, report);
  add_visibility(all, report);
  add_stacks(all, report);
  return all;
}

}  // namespace gnomon::report
