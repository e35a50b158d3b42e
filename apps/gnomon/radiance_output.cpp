#include "apps/gnomon/radiance_output.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "apps/gnomon/text.h"
#include "geometry/numbers/printed_bound.h"

namespace gnomon {
namespace {

constexpr std::array channel_names{"r", "g", "b"};

nlohmann::ordered_json seen_json(const ViewedRow& seen, const std::vector<std::string>& lights) {
  if (const auto* malformed = std::get_if<MalformedRow>(&seen.row)) {
    return {{"line", malformed->line}, {"problem", malformed->problem}};
  }
  const auto& row = std::get<PointRow>(seen.row);
  nlohmann::ordered_json json = {{"line", row.line},
                                 {"point", row.coordinates},
                                 {"normal", row.normal},
                                 {"eye", row.eye},
                                 {"lights", nlohmann::ordered_json::array()}};
  for (std::size_t l = 0; l < lights.size(); ++l) {
    json["lights"].push_back({{"light", lights[l]}});
    json["lights"].back().update(radiance_json(seen.reflected.lights[l], "error_bound"));
  }
  json["ambient"] = radiance_json(seen.reflected.ambient, "error_bound");
  json["total"] = radiance_json(seen.reflected.total(), "error_bound");
  return json;
}

}  // namespace

nlohmann::ordered_json radiance_json(const RadianceRgb& radiance, const std::string& bound_name) {
  nlohmann::ordered_json values = nlohmann::ordered_json::array(), bounds = nlohmann::ordered_json::array();
  for (const Radiance& r : radiance) {
    values.push_back(r.value);
    bounds.push_back(printed_error_bound(r.value, r.error_bound));
  }
  return {{"radiance", values}, {bound_name, bounds}};
}

std::string RadianceColumns::header(const std::string& bound_name, const std::string& suffix) const {
  if (!coloured) return ',' + csv_field("radiance" + suffix) + ',' + csv_field(bound_name + suffix);
  std::string text;
  for (const std::string channel : channel_names) {
    text += ',' + csv_field("radiance_" + channel + suffix) + ',' + csv_field(bound_name + '_' + channel + suffix);
  }
  return text;
}

std::string RadianceColumns::text(const RadianceRgb& radiance) const {
  std::string text;
  for (std::size_t k = 0; k < (coloured ? 3 : 1); ++k) {
    const Radiance& r = radiance[k];
    text += ',' + number_text(r.value) + ',' + number_text(printed_error_bound(r.value, r.error_bound));
  }
  return text;
}

RadianceCsv::RadianceCsv(std::ostream& stream, const std::string& header, std::vector<std::string> lights,
                         bool coloured)
    : stream_(stream), lights_(std::move(lights)), columns_{coloured} {
  stream_ << header << ",light" << columns_.header("error_bound", "") << '\n';
  for (std::string& light : lights_) light = csv_field(light);
}

void RadianceCsv::add_line(const std::string& fields, const std::string& light, const RadianceRgb& radiance) {
  stream_ << fields << ',' << light << columns_.text(radiance) << '\n';
}

void RadianceCsv::add(const ViewedRow& seen) {
  const auto* row = std::get_if<PointRow>(&seen.row);
  if (!row) return;
  for (std::size_t l = 0; l < lights_.size(); ++l) add_line(row->text, lights_[l], seen.reflected.lights[l]);
  add_line(row->text, "ambient", seen.reflected.ambient);
  add_line(row->text, "total", seen.reflected.total());
}

RadianceJson::RadianceJson(std::ostream& stream, const SpaceScene& scene, const std::string& material,
                           std::vector<std::string> lights)
    : stream_(stream), lights_(std::move(lights)) {
  const auto quoted = [](const std::string& text) {
    return nlohmann::ordered_json(text).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  };
  stream_ << "{\n  \"schema\": \"gnomon/radiance/1\",\n  \"scene\": " << quoted(scene.source)
          << ",\n  \"length_unit\": " << quoted(scene.length_unit) << ",\n  \"material\": " << quoted(material)
          << ",\n  \"radiance_unit\": \"W/(m^2 sr)\",\n  \"points\": [";
}

void RadianceJson::add(const ViewedRow& seen) {
  stream_ << (std::exchange(first_, false) ? "\n    " : ",\n    ") << seen_json(seen, lights_).dump();
}

void RadianceJson::finish(std::size_t points, std::size_t malformed_lines) {
  stream_ << (first_ ? "]" : "\n  ]") << ",\n  \"point_count\": " << points
          << ",\n  \"malformed_lines\": " << malformed_lines << "\n}\n";
}

}  // namespace gnomon
