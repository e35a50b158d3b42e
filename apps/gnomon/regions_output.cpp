#include "apps/gnomon/regions_output.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "apps/gnomon/text.h"
#include "geometry/numbers/printed_bound.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array regions = {Region::lit, Region::penumbra, Region::umbra, Region::unlit};

Json point_json(const PointRow& row, int dimension, PointKind kind) {
  Json point = Json::array();
  for (std::size_t i = 0; i < std::size_t(dimension); ++i) point.push_back(row.coordinates[i]);
  Json json = {{"line", row.line}, {"point", std::move(point)}};
  if (kind == PointKind::of_receivers) json["normal"] = row.normal;
  return json;
}

Json seen_json(const std::string& light, const Visibility& seen, PointKind kind) {
  Json json = {{"light", light},
               {"region", name(seen.region)},
               {"visible_fraction", seen.fraction},
               {"error_bound", printed_error_bound(seen.fraction, seen.error_bound)}};
  if (kind == PointKind::of_receivers) json["before_receiver"] = seen.before_receiver;
  return json;
}

}  // namespace

void RegionCounts::add(const JudgedRow& judged) {
  if (std::holds_alternative<MalformedRow>(judged.row)) {
    ++malformed_lines_;
    return;
  }
  ++points_;
  for (std::size_t l = 0; l < lights_.size(); ++l) ++counts_[l][std::size_t(judged.seen[l].region)];
}

std::string RegionCounts::text() const {
  std::vector<TextRow> rows{{"light"}};
  for (const Region region : regions) rows[0].emplace_back(name(region));
  for (std::size_t l = 0; l < lights_.size(); ++l) {
    rows.push_back({lights_[l]});
    for (const Region region : regions) rows.back().push_back(std::to_string(count(l, region)));
  }
  return counted(points_, "point") + '\n' + aligned(rows, 2);
}

RegionsCsv::RegionsCsv(std::ostream& stream, const std::string& header, std::vector<std::string> lights, PointKind kind)
    : kind_(kind), stream_(stream), lights_(std::move(lights)) {
  for (std::string& light : lights_) light = csv_field(light);
  stream_ << header << ",light,region,visible_fraction,error_bound"
          << (kind_ == PointKind::of_receivers ? ",before_receiver\n" : "\n");
}

void RegionsCsv::add(const JudgedRow& judged) {
  const auto* row = std::get_if<PointRow>(&judged.row);
  if (!row) return;
  for (std::size_t l = 0; l < lights_.size(); ++l) {
    const Visibility& seen = judged.seen[l];
    stream_ << row->text << ',' << lights_[l] << ',' << name(seen.region) << ',' << number_text(seen.fraction) << ','
            << number_text(printed_error_bound(seen.fraction, seen.error_bound));
    if (kind_ == PointKind::of_receivers) stream_ << ',' << number_text(seen.before_receiver);
    stream_ << '\n';
  }
}

RegionsJson::RegionsJson(std::ostream& stream, const Scene& scene, std::vector<std::string> lights, PointKind kind)
    : stream_(stream), lights_(std::move(lights)), dimension_(dimension(scene)), kind_(kind) {
  stream_ << "{\n  \"schema\": \"gnomon/regions/1\",\n  \"scene\": "
          << Json(facts(scene).source).dump(-1, ' ', false, Json::error_handler_t::replace)
          << ",\n  \"dimension\": " << dimension_ << ",\n  \"length_unit\": " << Json(facts(scene).length_unit).dump()
          << ",\n  \"points\": [";
}

void RegionsJson::add(const JudgedRow& judged) {
  Json json;
  if (const auto* malformed = std::get_if<MalformedRow>(&judged.row)) {
    json = {{"line", malformed->line}, {"problem", malformed->problem}};
  } else {
    json = point_json(std::get<PointRow>(judged.row), dimension_, kind_);
    json["lights"] = Json::array();
    for (std::size_t l = 0; l < lights_.size(); ++l)
      json["lights"].push_back(seen_json(lights_[l], judged.seen[l], kind_));
  }
  stream_ << (std::exchange(first_, false) ? "\n    " : ",\n    ") << json.dump();
}

void RegionsJson::finish(const RegionCounts& counts) {
  Json lights = Json::array();
  for (std::size_t l = 0; l < lights_.size(); ++l) {
    lights.push_back({{"name", lights_[l]}});
    for (const Region region : regions) lights.back()[std::string(name(region))] = counts.count(l, region);
  }
  stream_ << "\n  ],\n  \"point_count\": " << counts.points()
          << ",\n  \"malformed_lines\": " << counts.malformed_lines() << ",\n  \"lights\": " << lights.dump()
          << "\n}\n";
}

}  // namespace gnomon
