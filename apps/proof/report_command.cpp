#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/text.h"
#include "apps/proof/proof_commands.h"
#include "apps/proof/report/machine.h"
#include "apps/proof/report/receiver_tasks.h"
#include "apps/proof/report/report.h"
#include "apps/proof/report/targets.h"
#include "apps/proof/report/timings.h"
#include "apps/proof/report/volume_tasks.h"
#include "viz/vtk/staged_folder.h"

namespace gnomon {
namespace {

struct ReportOptions : CommonOptions {
  std::string out;
  bool quick = false;

  report::Effort effort() const { return quick ? report::Effort::quick : report::Effort::full; }
};

void add_options(CommandLine& app, ReportOptions& options) {
  add_required_text(app, "--out", options.out, "DIR",
                    "Write report.md, report.json, tables (.csv) and plots (.svg) into this folder");
  app.add_flag("--quick", options.quick, "Fewer points and sizes: within a minute, instead of a quarter of an hour");
  add_quiet_option(app, options);
  app.footer(
      "Measured are visible fractions, irradiances, volumes of a pair and areas on a receiver, by gnomon, by plain\n"
      "doubles, by Embree and by CGAL, and a corpus of hard cases against the exact level. Times are processor time\n"
      "of one thread. Counts and errors are the same in every run. The exit code is 1 if gnomon gave a wrong region\n"
      "or a number outside the bound it claims.\n\n"
      "Examples:\n"
      "  gnomon report --out report_quick --quick\n"
      "  gnomon report --quick --out report_again\n");
}

std::vector<report::Measurement> measurements(const ReportOptions& options, Progress::Visibility shown) {
  std::vector<report::Task> tasks = report::visibility_tasks(options.effort());
  for (const auto& more : {report::volume_tasks(options.effort()), report::receiver_tasks(options.effort())}) {
    tasks.insert(tasks.end(), more.begin(), more.end());
  }
  Progress progress("speed against error", tasks.size(), shown);
  std::vector<report::Measurement> all;
  for (const report::Task& task : tasks) {
    for (report::Measurement& measurement : task.measure()) all.push_back(std::move(measurement));
    progress.step();
  }
  return all;
}

std::vector<report::Timing> timings(const ReportOptions& options, Progress::Visibility shown) {
  const std::vector<report::TimingTask> tasks = report::timing_tasks(options.effort());
  Progress progress("timings", tasks.size(), shown);
  std::vector<report::Timing> all;
  for (const report::TimingTask& task : tasks) {
    for (report::Timing& timing : task.measure()) all.push_back(std::move(timing));
    progress.step();
  }
  return all;
}

std::vector<report::HardCaseResult> hard_case_results(const ReportOptions& options, Progress::Visibility shown) {
  const std::vector<report::HardCase> cases = report::hard_cases();
  Progress progress("hard cases", cases.size(), shown);
  std::vector<report::HardCaseResult> results;
  for (const report::HardCase& hard : cases) {
    results.push_back(report::hard_case_trial(hard, options.effort()));
    progress.step();
  }
  return results;
}

/// The files' names, the folder's before them.
std::vector<std::string> written(const report::Report& report, const std::string& folder, viz::StagedFolder& staged) {
  std::vector<report::TextFile> files = {report::report_page(report), report::report_json(report)};
  for (const auto& more : {report::report_csv(report), report::report_pictures(report)}) {
    files.insert(files.end(), more.begin(), more.end());
  }
  std::vector<std::string> names;
  for (const report::TextFile& file : files) {
    staged.add_text(file.name, file.text);
    names.push_back((std::filesystem::path(folder) / file.name).string());
  }
  staged.publish();
  return names;
}

/// True if something is wrong, and not merely slow.
bool has_failed(const report::Report& report) {
  bool failed = false;
  for (const report::Finding& finding : report::findings(report)) {
    if (finding.reached || !finding.is_promise) continue;
    print_error(finding.subject + ": " + finding.found);
    failed = true;
  }
  return failed;
}

void print_findings(const report::Report& report) {
  std::vector<TextRow> rows;
  for (const report::Finding& finding : report::findings(report)) {
    rows.push_back({finding.reached ? "reached" : "missed", finding.subject, finding.wanted, finding.found});
  }
  std::cout << aligned(rows, 0);
}

}  // namespace

ExitCode report_command(Arguments arguments) {
  CommandLine app(
      "Measures speed against error of gnomon and of other ways, tries hard cases, and writes a report with plots.",
      "gnomon report");
  ReportOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  viz::StagedFolder staged(options.out);  // first, so that a folder that cannot be made is told at once
  const Progress::Visibility shown = progress_visibility(options.quiet, false);
  report::Report report;
  report.effort = options.effort();
  report.machine = report::machine();
  report.measurements = measurements(options, shown);
  report.timings = timings(options, shown);
  report.table_one = report::table_one(options.effort());
  report.searches = report::search_tables(options.effort());
  report.meshed_board = report::meshed_board(options.effort());
  report.boxes = report::boxes_trees(options.effort());
  report.adaptive = report::adaptive_rays(options.effort());
  report.hard_cases = hard_case_results(options, shown);
  report.rotations = report::rotation_results(options.effort());
  const std::vector<std::string> files = written(report, options.out, staged);
  if (!options.quiet) {
    print_findings(report);
    for (const std::string& file : files) std::cout << "written    " << shell_word(file) << '\n';
  }
  return has_failed(report) ? ExitCode::failure : ExitCode::done;
}

}  // namespace gnomon
