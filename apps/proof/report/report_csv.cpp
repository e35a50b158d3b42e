#include "apps/proof/report/pareto.h"
#include "apps/proof/report/report.h"
#include "apps/proof/report/tables.h"

namespace gnomon::report {
namespace {

std::string text(std::size_t number) {
  return std::to_string(number);
}

Row times(const Seconds& seconds) {
  return {full_text(1e9 * seconds.median), full_text(1e9 * seconds.least), full_text(1e9 * seconds.most)};
}

Row joined(Row row, const Row& more) {
  row.insert(row.end(), more.begin(), more.end());
  return row;
}

std::string speed_against_error(const std::vector<Measurement>& measurements) {
  std::vector<Row> rows = {{"task", "method", "size", "samples", "ns", "ns_least", "ns_most", "results", "rms",
                            "relative_rms", "max", "largest", "bound", "outside_bound", "wrong_regions", "bytes"}};
  for (const Measurement& m : measurements) {
    const Row head = joined({m.task, m.method, text(m.size), text(m.samples)}, times(m.seconds));
    rows.push_back(joined(
        head, {text(m.errors.results), full_text(m.errors.rms), full_text(m.errors.relative_rms),
               full_text(m.errors.most), full_text(m.errors.largest), m.errors.bound ? full_text(*m.errors.bound) : "",
               text(m.errors.outside_bound), text(m.errors.wrong_regions), text(m.bytes)}));
  }
  return csv(rows);
}

std::string hard_cases(const std::vector<HardCaseResult>& results) {
  std::vector<Row> rows = {{"name", "about", "region", "visible_fraction", "error_bound", "irradiance",
                            "irradiance_bound", "points", "misclassified_double", "misclassified_embree",
                            "misclassified_gnomon", "outside_bound", "max", "bound", "exact_answers", "ns", "ns_least",
                            "ns_most"}};
  for (const HardCaseResult& r : results) {
    const Row head = {r.name,
                      r.about,
                      std::string(name(r.focus.region)),
                      full_text(r.focus.fraction),
                      full_text(r.focus.error_bound),
                      full_text(r.irradiance.value),
                      full_text(r.irradiance.error_bound),
                      text(r.points),
                      text(r.wrong_doubles),
                      text(r.wrong_embree),
                      text(r.wrong_gnomon),
                      text(r.outside_bound),
                      full_text(r.most_error),
                      full_text(r.most_bound),
                      text(r.exact_answers)};
    rows.push_back(joined(head, times(r.seconds)));
  }
  return csv(rows);
}

std::string rotation(const std::vector<RotationResult>& results) {
  std::vector<Row> rows = {
      {"distance", "points", "rms", "max", "regions_changed", "wrong_gnomon", "embree_rms", "embree_max"}};
  for (const RotationResult& r : results) {
    rows.push_back({full_text(r.distance), text(r.points), full_text(r.rms), full_text(r.most), text(r.regions_changed),
                    text(r.wrong_gnomon), full_text(r.embree_rms), full_text(r.embree_most)});
  }
  return csv(rows);
}

std::string equivalent_lights(const std::vector<Equivalent>& all) {
  std::vector<Row> rows = {{"task", "method", "blockers", "samples", "rms"}};
  for (const Equivalent& e : all) {
    rows.push_back({e.task, e.method, text(e.size), full_text(e.samples), full_text(e.rms)});
  }
  return csv(rows);
}

}  // namespace

std::vector<TextFile> report_csv(const Report& report) {
  return {{"speed_against_error.csv", speed_against_error(report.measurements)},
          {"hard_cases.csv", hard_cases(report.hard_cases)},
          {"rotation.csv", rotation(report.rotations)},
          {"equivalents.csv", equivalent_lights(equivalents(report.measurements))}};
}

}  // namespace gnomon::report
