#include "apps/gnomon/irradiance_output.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "apps/gnomon/text.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

Json row_json(const LitRow& lit, const std::vector<std::string>& lights) {
  if (const auto* malformed = std::get_if<MalformedRow>(&lit.row)) {
    return {{"line", malformed->line}, {"problem", malformed->problem}};
  }
  const auto& row = std::get<PointRow>(lit.row);
  Json json = {{"line", row.line}, {"point", row.coordinates}, {"normal", row.normal}, {"lights", Json::array()}};
  for (std::size_t l = 0; l < lights.size(); ++l) {
    const Irradiance& e = lit.received[l];
    json["lights"].push_back({{"light", lights[l]}, {"irradiance", e.value}, {"error_bound", e.error_bound}});
  }
  return json;
}

}  // namespace

IrradianceCsv::IrradianceCsv(std::ostream& stream, const std::string& header, std::vector<std::string> lights)
    : stream_(stream), lights_(std::move(lights)) {
  for (std::string& light : lights_) light = csv_field(light);
  stream_ << header << ",light,irradiance,error_bound\n";
}

void IrradianceCsv::add(const LitRow& lit) {
  const auto* row = std::get_if<PointRow>(&lit.row);
  if (!row) return;
  for (std::size_t l = 0; l < lights_.size(); ++l) {
    stream_ << row->text << ',' << lights_[l] << ',' << number_text(lit.received[l].value) << ','
            << number_text(lit.received[l].error_bound) << '\n';
  }
}

IrradianceJson::IrradianceJson(std::ostream& stream, const Scene& scene, std::vector<std::string> lights)
    : stream_(stream), lights_(std::move(lights)) {
  stream_ << "{\n  \"schema\": \"gnomon/irradiance/1\",\n  \"scene\": " << Json(scene.source).dump()
          << ",\n  \"length_unit\": " << Json(scene.length_unit).dump()
          << ",\n  \"irradiance_unit\": \"W/m^2\",\n  \"points\": [";
}

void IrradianceJson::add(const LitRow& lit) {
  stream_ << (std::exchange(first_, false) ? "\n    " : ",\n    ") << row_json(lit, lights_).dump();
}

void IrradianceJson::finish(std::size_t points, std::size_t malformed_lines) {
  stream_ << "\n  ],\n  \"point_count\": " << points << ",\n  \"malformed_lines\": " << malformed_lines << "\n}\n";
}

}  // namespace gnomon
