#include <algorithm>

#include "apps/proof/report/pareto.h"
#include "apps/proof/report/report.h"
#include "apps/proof/report/selection.h"
#include "apps/proof/report/tables.h"
#include "apps/proof/report/targets.h"
#include "apps/proof/report/timing_targets.h"

namespace gnomon::report {
namespace {

std::string picture(const std::string& name, const std::string& title) {
  return "![" + title + "](pictures/" + name + ".svg)\n\n";
}

std::string machine_table(const Report& report) {
  std::vector<Row> rows = {{"what", "value"}};
  for (const auto& [name, value] : report.machine) rows.push_back({name, value});
  return markdown_table(rows);
}

std::string verdicts(const Report& report) {
  std::string missed, table;
  std::vector<Row> rows = {{"what", "wanted", "found", ""}};
  for (const Finding& finding : findings(report)) {
    rows.push_back({finding.subject, finding.wanted, finding.found, finding.reached ? "reached" : "**missed**"});
    if (finding.reached) continue;
    missed += "- " + finding.subject + ": wanted is " + finding.wanted + ", found was " + finding.found + ".\n";
  }
  return (missed.empty() ? "All of what is wanted and measured here was reached in this run.\n"
                         : "In this run the following falls short of what is wanted:\n\n" + missed) +
         "\n" + markdown_table(rows);
}

/// The targets that this run has no figures for, each with what measures it.
std::string not_measured(const Report& report) {
  const std::vector<Finding> others = unmeasured(report);
  if (others.empty()) {
    return "These are all targets that the project's benchmarks state; `./bootstrap bench` measures more sizes.\n\n";
  }
  std::vector<Row> rows = {{"what", "wanted", "measured by"}};
  for (const Finding& other : others) rows.push_back({other.subject, other.wanted, "`" + other.command + "`"});
  return "Not measured in this run, but by `gnomon report --out DIR` without `--quick`, and by the benchmarks:\n\n" +
         markdown_table(rows) + "\n";
}

/// What the wanted times hold for.
std::string scale_text(const Report& report) {
  const double scale = machine_scale(report);
  return "Times of extremal planes and meshes are wanted of a machine on which plain doubles take " +
         time_text(plain_planes_there) + "\nfor the planes of 4 by 4 vertices; here they take " +
         time_text(plain_planes_there * scale) + ", and what is wanted is scaled likewise.\n\n";
}

std::string time_cell(const Seconds& seconds) {
  return time_text(seconds.median) + " (" + time_text(seconds.least) + " to " + time_text(seconds.most) + ")";
}

/// Of methods that sample, only these numbers of points are in the page; the others are in the CSV file.
bool is_told(const Measurement& m) {
  return m.task == "receiver_areas" || m.samples == 0 || m.samples == 4 || m.samples == 256 || m.samples == 4096;
}

std::string speed_table(const std::vector<Measurement>& measurements) {
  std::vector<Row> rows = {{"method", "samples", "time per result: median (least to most)", "RMS error",
                            "largest error", "largest bound claimed", "results", "memory"}};
  for (const Measurement& m : measurements) {
    if (!is_told(m)) continue;
    rows.push_back({title_of(m.method), m.samples == 0 ? "" : std::to_string(m.samples), time_cell(m.seconds),
                    short_text(m.errors.rms), short_text(m.errors.most),
                    m.errors.bound ? short_text(*m.errors.bound) : "none", std::to_string(m.errors.results),
                    bytes_text(m.bytes)});
  }
  return markdown_table(rows) + "\n";
}

std::string sizes_of_task(const Report& report, const std::string& task, const std::string& heading,
                          const std::string& of) {
  std::string text = "## " + heading + "\n\n";
  for (const auto& [size, measurements] : by_size(report.measurements, task)) {
    const std::string title = heading + ", " + counted_text(size, of);
    text += "### " + counted_text(size, of) + "\n\n" + picture(task + "_" + std::to_string(size), title) +
            speed_table(measurements);
  }
  return text;
}

std::string volumes(const Report& report) {
  std::string text;
  for (const auto& [task, heading] :
       {std::pair{"occlusion_volume", "Occlusion volume of a pair"}, {"umbra_volume", "Umbra of a pair"}}) {
    std::vector<Row> rows = {
        {"vertices", "method", "time: median (least to most)", "relative error of the volume", "memory"}};
    for (const auto& [size, measurements] : by_size(report.measurements, task)) {
      for (const Measurement& m : measurements) {
        rows.push_back({std::to_string(size), title_of(m.method), time_cell(m.seconds), short_text(m.errors.most),
                        bytes_text(m.bytes)});
      }
    }
    text += std::string("### ") + heading + "\n\n" + picture(task, heading) + markdown_table(rows) + "\n";
  }
  return "## Volumes of a pair\n\n"
         "A light and a blocker of as many vertices each, in general position, cut by a floor. gnomon makes occlusion "
         "and umbra\ntogether; its time is that of both. The exact volume is a rational number. Of CGAL, "
         "`convex_hull_3` (inexact\nconstructions) makes the occlusion alone from the vertices' shadows, "
         "`Nef_polyhedron_3` (exact ones) the umbra alone;\nit is tried where it ends within a second.\n\n" +
         text;
}

std::string equivalents_section(const Report& report) {
  std::vector<Row> rows = {{"task", "blockers", "method", "points that cost as much", "their RMS error"}};
  for (const Equivalent& e : equivalents(report.measurements)) {
    rows.push_back({e.task, std::to_string(e.size), title_of(e.method), short_text(e.samples), short_text(e.rms)});
  }
  return "## Equivalent number of point lights\n\n"
         "How many points on the light cost as much as one certified answer, and how wrong the answer from so many "
         "is\n([P93] Table I asks this of a linear light). The number follows from times, so it differs from run to "
         "run.\n\n" +
         picture("equivalents", "Equivalent number of point lights") + markdown_table(rows) + "\n";
}

std::string share_text(std::size_t part, std::size_t whole) {
  return short_text(100 * static_cast<double>(part) / static_cast<double>(whole)) + " %";
}

std::string hard_cases_table(const std::vector<HardCaseResult>& results) {
  std::vector<Row> rows = {{"case", "region", "fraction", "bound", "wrong: doubles", "wrong: floats", "wrong: gnomon",
                            "time per answer", "exact level"}};
  for (const HardCaseResult& r : results) {
    rows.push_back({"`" + r.name + "`: " + r.about, std::string(name(r.focus.region)), short_text(r.focus.fraction),
                    short_text(r.focus.error_bound), std::to_string(r.wrong_doubles), std::to_string(r.wrong_embree),
                    std::to_string(r.wrong_gnomon), time_cell(r.seconds), share_text(r.exact_answers, r.points)});
  }
  return markdown_table(rows);
}

/// In words, what is costly or loose.
std::string hard_case_remarks(const std::vector<HardCaseResult>& results) {
  if (results.empty()) return "";
  const auto slowest = std::max_element(
      results.begin(), results.end(), [](const auto& a, const auto& b) { return a.seconds.median < b.seconds.median; });
  const auto loosest = std::max_element(results.begin(), results.end(),
                                        [](const auto& a, const auto& b) { return a.most_bound < b.most_bound; });
  std::string text = "Slowest is `" + slowest->name + "` with " + time_text(slowest->seconds.median) + " per answer, " +
                     share_text(slowest->exact_answers, slowest->points) +
                     " of them from the exact level; the widest bound of a fraction is " +
                     short_text(loosest->most_bound) + " (`" + loosest->name + "`).\n";
  std::string useless;
  for (const HardCaseResult& r : results) {
    if (r.irradiance.error_bound > 1e-3) useless += (useless.empty() ? "`" : ", `") + r.name + "`";
  }
  if (useless.empty()) return text;
  return text + "Irradiance is told with a bound that says nothing (above 1e-3) at " + useless + ".\n";
}

std::string hard_cases_section(const Report& report) {
  const std::size_t points = report.hard_cases.empty() ? 0 : report.hard_cases.front().points;
  return "## Hard cases\n\n" + std::to_string(report.hard_cases.size()) +
         " scenes in which rounding is likely to decide wrongly. Region, fraction and bound are gnomon's at the case's "
         "own\npoint. Of " +
         std::to_string(points) +
         " points around it, whose regions the exact level tells, so many are given a wrong region by the\nsame "
         "boundary walk in plain doubles, by floats (Embree; 256 rays, so some are missed for want of rays), and by "
         "gnomon.\nThe exact level is given a flat blocker of many corners cut into pieces of few, which is the same "
         "blocker and takes\nit less time. The last column is the share of gnomon's answers that had to come from the "
         "exact level.\n\n" +
         hard_case_remarks(report.hard_cases) + "\n" + picture("hard_cases", "Wrong regions around hard cases") +
         picture("hard_case_times", "Time per answer around hard cases") + hard_cases_table(report.hard_cases) + "\n";
}

std::string rotation_section(const Report& report) {
  std::vector<Row> rows = {{"distance from the axis", "points", "RMS movement", "largest", "regions changed",
                            "wrong: gnomon", "RMS movement, Embree", "largest, Embree"}};
  for (const RotationResult& r : report.rotations) {
    rows.push_back({short_text(r.distance), std::to_string(r.points), short_text(r.rms), short_text(r.most),
                    std::to_string(r.regions_changed), std::to_string(r.wrong_gnomon), short_text(r.embree_rms),
                    short_text(r.embree_most)});
  }
  return "## Turned scenes\n\n"
         "A scene of 16 triangles is turned about an axis through the origin by random angles, and its coordinates are "
         "rounded\nagain: it is another scene then. So far the exact visible fraction moves; gnomon's answers are "
         "right "
         "for each turned\nscene as it is given. Embree's move by what its rays then hit, with 256 regular point "
         "lights.\n\n" +
         markdown_table(rows) + "\n";
}

std::string methods_section() {
  return "## What is compared\n\n"
         "A point on a floor looks at a square light of side 1 at height 4, behind random triangles. Truth is the "
         "visible part in\nrational numbers, and for the irradiance the sum over its edges in intervals of 256 bits "
         "(MPFI).\n\n"
         "- gnomon, exact level: the same in rational numbers; the irradiance in intervals of 128 bits.\n"
         "- gnomon, certified doubles: what `gnomon regions` and `gnomon irradiance` ask, the exact level included "
         "where it is needed.\n"
         "- plain doubles: the same walk along the boundary of the visible part in doubles, without bounds, filters or "
         "a hierarchy.\n"
         "- Embree: shadow rays in floats, one by one, to points on the light: in the middles of k × k cells, or "
         "anywhere in them\n  (jittered: the same for all that look; stratified: new ones for each); stratified ones "
         "also in packets of eight, told\n  to be coherent.\n"
         "- CGAL `Polygon_set_2`: the blockers' shadows on the light's plane, joined and taken away from the light, "
         "with "
         "exact\n  constructions; asked about fewer points, as it is slow. `Nef_polyhedron_3` is tried on volumes "
         "only.\n\n"
         "Times are processor time of one thread, per result: the median of five runs after one that warms up (three "
         "with\n`--quick`), with the least and the most. An error of 0 means that the result is the double nearest to "
         "the truth. Memory is\nby how much the process grows meanwhile, in whole pages; what it has already is not "
         "counted. The dashed line joins what\nno other method beats in both time and error.\n\n";
}

std::string date_of(const Report& report) {
  const auto found = std::find_if(report.machine.begin(), report.machine.end(),
                                  [](const auto& entry) { return entry.first == "date"; });
  return found == report.machine.end() ? "" : found->second;
}

}  // namespace

TextFile report_page(const Report& report) {
  const bool quick = report.effort == Effort::quick;
  const std::string head = std::string("# Speed against error, and hard cases\n\n") +
                           "Made by `gnomon report --out DIR" + (quick ? " --quick" : "") + "` on " + date_of(report) +
                           ". Counts and errors are the same in every run; times are those of this machine.\n\n" +
                           machine_table(report) + "\n## What is reached, and what is not\n\n" + verdicts(report) +
                           "\n" + scale_text(report) + not_measured(report);
  return {"report.md",
          head + methods_section() + sizes_of_task(report, "visible_fraction", "Visible fraction", "triangle") +
              sizes_of_task(report, "irradiance", "Irradiance", "triangle") + equivalents_section(report) +
              volumes(report) + sizes_of_task(report, "receiver_areas", "Areas of regions on a receiver", "board") +
              table_one_section(report.table_one) + search_tables_section(report.searches) +
              boxes_section(report.boxes) + adaptive_rays_section(report.adaptive) + hard_cases_section(report) +
              meshed_board_section(report.meshed_board) + rotation_section(report)};
}

}  // namespace gnomon::report
