#include "apps/proof/report/targets.h"

#include <algorithm>
#include <array>
#include <optional>

#include "apps/proof/report/pareto.h"
#include "apps/proof/report/tables.h"
#include "apps/proof/report/timing_targets.h"

namespace gnomon::report {
namespace {

using Findings = std::vector<Finding>;

const Measurement* measurement(const Report& report, const std::string& task, const std::string& method,
                               std::size_t size) {
  const auto found = std::find_if(report.measurements.begin(), report.measurements.end(), [&](const Measurement& m) {
    return m.task == task && m.method == method && m.size == size;
  });
  return found == report.measurements.end() ? nullptr : &*found;
}

void add_time(Findings& all, const std::string& subject, double wanted, const Measurement* m) {
  all.push_back({subject, "at most " + time_text(wanted), m == nullptr ? "" : time_text(m->seconds.median),
                 m != nullptr && m->seconds.median <= wanted, false, "./bootstrap bench visibility_fast"});
}

void add_times(Findings& all, const Report& report) {
  const std::pair<std::size_t, double> per_point[] = {{1, 0.4e-6}, {4, 0.8e-6},  {16, 2e-6},
                                                      {64, 12e-6}, {256, 40e-6}, {1024, 120e-6}};
  for (const auto& [n, wanted] : per_point) {
    const std::string subject = "region, fraction and irradiance with bounds behind " + counted_text(n, "triangle");
    add_time(all, subject, wanted, measurement(report, "irradiance", "gnomon", n));
  }
}

/// A way to compare with stratified sampling, and how many times faster is wanted behind 1, 64 and 1,024 triangles.
struct Comparison {
  const char* method;
  ErrorScale scale;
  double error;
  std::array<double, 3> wanted;
};

/// The least flattering first. Of each irradiance's own error less is wanted beside packets, as these are two to three
/// times as fast.
constexpr std::array comparisons = {Comparison{"embree_packets", ErrorScale::largest_value, 1e-2, {5, 5, 5}},
                                    Comparison{"embree_packets", ErrorScale::largest_value, 1e-3, {50, 50, 50}},
                                    Comparison{"embree_stratified", ErrorScale::largest_value, 1e-3, {50, 50, 50}},
                                    Comparison{"embree_packets", ErrorScale::own_value, 1e-3, {80, 12, 10}},
                                    Comparison{"embree_stratified", ErrorScale::own_value, 1e-3, {200, 30, 25}}};

std::string subject(const Comparison& c, std::size_t n) {
  const std::string rays = std::string(c.method) == "embree_packets" ? "rays in packets of eight" : "single rays";
  const std::string of = c.scale == ErrorScale::largest_value ? " of the largest irradiance" : " of each irradiance";
  return "faster than Embree's stratified " + rays + " at an RMS error of " + short_text(c.error) + of + ", " +
         counted_text(n, "triangle");
}

void add_speedups(Findings& all, const Report& report) {
  constexpr std::array<std::size_t, 3> sizes = {1, 64, 1024};
  for (const Comparison& c : comparisons) {
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const Measurement* gnomon = measurement(report, "irradiance", "gnomon", sizes[i]);
      Measurement like;
      like.task = "irradiance";
      like.method = c.method;
      like.size = sizes[i];
      const auto sampling = seconds_for_error(report.measurements, like, c.scale, c.error);
      const double found = gnomon == nullptr || !sampling ? 0 : *sampling / gnomon->seconds.median;
      all.push_back({subject(c, sizes[i]), "at least " + short_text(c.wanted[i]) + " times",
                     found == 0 ? "" : short_text(found) + " times", found >= c.wanted[i], false,
                     "./bootstrap bench visibility"});
    }
  }
}

void add_count(Findings& all, const std::string& subject, std::size_t wrong, std::size_t of) {
  all.push_back({subject, "0", std::to_string(wrong) + " of " + std::to_string(of), wrong == 0, true, ""});
}

void add_counts(Findings& all, const Report& report) {
  std::size_t wrong = 0, outside = 0, points = 0, irradiances = 0;
  for (const HardCaseResult& r : report.hard_cases) {
    wrong += r.wrong_gnomon;
    outside += r.outside_bound;
    points += r.points;
    irradiances += r.irradiance_is_right ? 0 : 1;
  }
  add_count(all, "wrong regions around hard cases", wrong, points);
  add_count(all, "fractions outside their bounds around hard cases", outside, points);
  add_count(all, "irradiances outside their bounds at hard cases", irradiances, report.hard_cases.size());
  std::size_t claims = 0, broken = 0;
  for (const Measurement& m : report.measurements) {
    if (!m.errors.bound) continue;
    claims += m.errors.results;
    broken += m.errors.outside_bound;
  }
  add_count(all, "results outside the bound they claim behind random triangles", broken, claims);
}

Findings all_targets(const Report& report) {
  Findings all;
  add_counts(all, report);
  add_times(all, report);
  add_speedups(all, report);
  const Findings more = timing_findings(report);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

std::vector<Finding> findings(const Report& report) {
  Findings all = all_targets(report);
  std::erase_if(all, [](const Finding& finding) { return !finding.is_measured(); });
  return all;
}

std::vector<Finding> unmeasured(const Report& report) {
  Findings all = all_targets(report);
  std::erase_if(all, [](const Finding& finding) { return finding.is_measured(); });
  return all;
}

}  // namespace gnomon::report
