#include <algorithm>
#include <iterator>
#include <tuple>

#include "apps/proof/report/pareto.h"
#include "apps/proof/report/report.h"
#include "apps/proof/report/selection.h"
#include "apps/proof/report/svg_plot.h"
#include "apps/proof/report/tables.h"

namespace gnomon::report {
namespace {

TextFile picture(const std::string& name, const Plot& plot) {
  return {"pictures/" + name + ".svg", svg_text(plot)};
}

/// Error over time of every method, and the Pareto front.
TextFile speed_plot(const std::string& name, const std::string& title, const std::string& unit,
                    const std::vector<Measurement>& measurements) {
  Plot plot{title, {"processor time per result [s]"}, {"root mean square error " + unit}, {}, {}};
  for (const std::string& method : methods_of(measurements)) {
    Series series{title_of(method), {}, Series::Line::solid, true, ""};
    for (const Measurement& m : measurements) {
      if (m.method == method) series.points.emplace_back(m.seconds.median, m.errors.rms);
    }
    plot.series.push_back(series);
  }
  Series front{"Pareto front", {}, Series::Line::dashed, false, "black"};
  for (const Measurement& m : pareto_front(measurements)) front.points.emplace_back(m.seconds.median, m.errors.rms);
  plot.series.push_back(front);
  return picture(name, plot);
}

std::vector<TextFile> speed_plots(const Report& report) {
  const std::tuple<const char*, const char*, const char*, const char*> tasks[] = {
      {"visible_fraction", "Visible fraction of a square light behind ", "triangle", "[1]"},
      {"irradiance", "Irradiance of a square light of radiance 1 behind ", "triangle", "[W/m²]"},
      {"receiver_areas", "Areas of the regions on a floor below ", "board", "[share of the floor]"}};
  std::vector<TextFile> files;
  for (const auto& [task, before, noun, unit] : tasks) {
    for (const auto& [size, measurements] : by_size(report.measurements, task)) {
      const std::string name = std::string(task) + '_' + std::to_string(size);
      files.push_back(speed_plot(name, before + counted_text(size, noun), unit, measurements));
    }
  }
  return files;
}

/// Time over the number of vertices.
TextFile volume_plot(const Report& report, const std::string& task, const std::string& title) {
  Plot plot{title, {"vertices of the light, and of the blocker"}, {"processor time [s]"}, {}, {}};
  std::vector<Measurement> all;
  for (const auto& [size, measurements] : by_size(report.measurements, task)) {
    all.insert(all.end(), measurements.begin(), measurements.end());
  }
  for (const std::string& method : methods_of(all)) {
    Series series{title_of(method), {}, Series::Line::solid, true, ""};
    for (const Measurement& m : all) {
      if (m.method == method) series.points.emplace_back(static_cast<double>(m.size), m.seconds.median);
    }
    plot.series.push_back(series);
  }
  return picture(task, plot);
}

/// Time over the number of triangles.
TextFile equivalents_plot(const Report& report) {
  Plot plot{"Point lights that cost as much as one certified irradiance",
            {"triangles between point and light"},
            {"number of point lights"},
            {},
            {}};
  const std::vector<Equivalent> all = equivalents(report.measurements);
  for (const char* method : sampling_methods) {
    Series series{title_of(method), {}, Series::Line::solid, true, ""};
    for (const Equivalent& e : all) {
      if (e.task == "irradiance" && e.method == method) {
        series.points.emplace_back(static_cast<double>(e.size), e.samples);
      }
    }
    plot.series.push_back(series);
  }
  return picture("equivalents", plot);
}

TextFile misclassified_plot(const std::vector<HardCaseResult>& results) {
  Plot plot{"Points around hard cases whose region is wrong", {"share of the points"}, {"", Scale::linear}, {}, {}};
  plot.series = {{"plain doubles", {}, Series::Line::none, true, "#d55e00"},
                 {"floats, 256 rays (Embree)", {}, Series::Line::none, true, "#56b4e9"},
                 {"gnomon", {}, Series::Line::none, true, "black"}};
  for (std::size_t k = 0; k < results.size(); ++k) {
    const HardCaseResult& r = results[k];
    plot.rows.push_back(r.name);
    const std::size_t wrong[] = {r.wrong_doubles, r.wrong_embree, r.wrong_gnomon};
    for (std::size_t i = 0; i < std::size(wrong); ++i) {
      plot.series[i].points.emplace_back(static_cast<double>(wrong[i]) / static_cast<double>(r.points), k);
    }
  }
  return picture("hard_cases", plot);
}

TextFile time_plot(const std::vector<HardCaseResult>& results) {
  Plot plot{"Time per answer of gnomon around hard cases", {"processor time [s]"}, {"", Scale::linear}, {}, {}};
  plot.series = {{"median", {}, Series::Line::none, true, "#0072b2"}};
  for (std::size_t k = 0; k < results.size(); ++k) {
    plot.rows.push_back(results[k].name);
    plot.series[0].points.emplace_back(results[k].seconds.median, k);
  }
  return picture("hard_case_times", plot);
}

}  // namespace

std::vector<TextFile> report_pictures(const Report& report) {
  std::vector<TextFile> files = speed_plots(report);
  files.push_back(volume_plot(report, "occlusion_volume", "Occlusion volume of a pair"));
  files.push_back(volume_plot(report, "umbra_volume", "Umbra of a pair"));
  files.push_back(equivalents_plot(report));
  files.push_back(misclassified_plot(report.hard_cases));
  files.push_back(time_plot(report.hard_cases));
  return files;
}

}  // namespace gnomon::report
