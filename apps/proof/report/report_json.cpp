#include <nlohmann/json.hpp>

#include "apps/proof/report/pareto.h"
#include "apps/proof/report/report.h"

namespace gnomon::report {
namespace {

using nlohmann::ordered_json;

double nanoseconds(double seconds) {
  return 1e9 * seconds;
}

void add_times(ordered_json& entry, const Seconds& seconds) {
  entry["ns"] = nanoseconds(seconds.median);
  entry["ns_least"] = nanoseconds(seconds.least);
  entry["ns_most"] = nanoseconds(seconds.most);
}

ordered_json entry(const Measurement& m) {
  ordered_json result = {{"task", m.task}, {"method", m.method}};
  result[m.task.ends_with("_volume") ? "vertices" : "blockers"] = m.size;
  if (m.samples > 0) result["samples"] = m.samples;
  add_times(result, m.seconds);
  result["bytes"] = m.bytes;
  result["results"] = m.errors.results;
  result["rms"] = m.errors.rms;
  result["relative_rms"] = m.errors.relative_rms;
  result["max"] = m.errors.most;
  result["mean"] = m.errors.mean;
  result["largest"] = m.errors.largest;
  if (m.errors.bound) {
    result["bound"] = *m.errors.bound;
    result["outside_bound"] = m.errors.outside_bound;
  }
  result["wrong_regions"] = m.errors.wrong_regions;
  return result;
}

ordered_json entry(const Timing& t) {
  ordered_json result = {{"task", t.task}, {"size", t.size}, {"count", t.count}};
  add_times(result, t.seconds);
  result["bytes"] = t.memory;
  return result;
}

ordered_json entry(const HardCaseResult& r) {
  ordered_json regions;
  for (std::size_t k = 0; k < r.regions.size(); ++k) regions[std::string(name(static_cast<Region>(k)))] = r.regions[k];
  ordered_json result = {
      {"name", r.name},
      {"about", r.about},
      {"region", name(r.focus.region)},
      {"visible_fraction", r.focus.fraction},
      {"error_bound", r.focus.error_bound},
      {"irradiance", r.irradiance.value},
      {"irradiance_bound", r.irradiance.error_bound},
      {"irradiance_is_right", r.irradiance_is_right},
      {"points", r.points},
      {"regions", regions},
      {"misclassified", {{"double", r.wrong_doubles}, {"embree", r.wrong_embree}, {"gnomon", r.wrong_gnomon}}},
      {"outside_bound", r.outside_bound},
      {"max", r.most_error},
      {"bound", r.most_bound},
      {"fallback_share", static_cast<double>(r.exact_answers) / static_cast<double>(r.points)}};
  add_times(result, r.seconds);
  return result;
}

ordered_json entry(const RotationResult& r) {
  return {{"distance", r.distance},
          {"points", r.points},
          {"rms", r.rms},
          {"max", r.most},
          {"regions_changed", r.regions_changed},
          {"wrong_gnomon", r.wrong_gnomon},
          {"embree_rms", r.embree_rms},
          {"embree_max", r.embree_most}};
}

ordered_json entry(const TableOneRow& row) {
  return {{"primitive", row.primitive},
          {"shadows", row.has_shadows},
          {"pixel_ns", 1e9 * row.pixel_seconds},
          {"constant", row.constant},
          {"per_point", row.per_point},
          {"equal", row.equal()},
          {"rms", row.rms},
          {"points_at_256", row.points_at_256},
          {"points_at_1000", row.points_at_1000}};
}

ordered_json entry(const SearchRow& row) {
  ordered_json json = {{"scene", row.scene}, {"search", name(row.search.strategy)}};
  if (row.search.parts > 0) json["parts"] = row.search.parts;
  json.update({{"blockers", row.blockers},
               {"references", row.references},
               {"needed", row.needed},
               {"candidates", row.candidates},
               {"visited", row.visited},
               {"ns", 1e9 * row.seconds}});
  return json;
}

ordered_json entry(const MeshedBoardRow& row) {
  return {{"triangles", row.triangles}, {"hidden_by_one", row.share}};
}

ordered_json entry(const BspRow& row) {
  return {
      {"tree", row.tree}, {"volumes", row.volumes}, {"nodes", row.nodes}, {"height", row.height}, {"path", row.path}};
}

ordered_json entry(const AdaptiveRow& row) {
  return {{"triangles", row.triangles},
          {"start", row.start},
          {"rays", row.rays},
          {"rms", row.rms},
          {"missed", row.missed},
          {"stratified_rms", row.stratified_rms},
          {"stratified_missed", row.stratified_missed}};
}

ordered_json entry(const Equivalent& e) {
  return {{"task", e.task}, {"method", e.method}, {"blockers", e.size}, {"samples", e.samples}, {"rms", e.rms}};
}

template <class Item>
ordered_json list(const std::vector<Item>& items) {
  ordered_json all = ordered_json::array();
  for (const Item& item : items) all.push_back(entry(item));
  return all;
}

}  // namespace

TextFile report_json(const Report& report) {
  ordered_json document = {{"schema", "gnomon/report/1"},
                           {"effort", report.effort == Effort::quick ? "quick" : "full"},
                           {"machine", ordered_json::object()}};
  for (const auto& [name, value] : report.machine) document["machine"][name] = value;
  document["hard_cases"] = list(report.hard_cases);
  document["speed_vs_error"] = list(report.measurements);
  document["timings"] = list(report.timings);
  document["equivalent_point_lights"] = list(equivalents(report.measurements));
  document["rotation"] = list(report.rotations);
  document["table_one"] = list(report.table_one);
  document["linear_searches"] = list(report.searches);
  document["meshed_board"] = list(report.meshed_board);
  document["shadow_trees"] = list(report.boxes.trees);
  document["adaptive_rays"] = list(report.adaptive);
  return {"report.json", document.dump(1) + '\n'};
}

}  // namespace gnomon::report
