#include "apps/gnomon/irradiance_output.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "apps/gnomon/text.h"
#include "geometry/numbers/printed_bound.h"
#include "geometry/shared_work.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

Json irradiance_json(const Irradiance& e) {
  return {{"irradiance", e.value}, {"error_bound", printed_error_bound(e.value, e.error_bound)}};
}

Json row_json(const LitRow& lit, const std::vector<std::string>& lights, const IrradianceLayout& layout) {
  if (const auto* malformed = std::get_if<MalformedRow>(&lit.row)) {
    return {{"line", malformed->line}, {"problem", malformed->problem}};
  }
  const auto& row = std::get<PointRow>(lit.row);
  Json json = {{"line", row.line}, {"point", row.coordinates}, {"normal", row.normal}, {"lights", Json::array()}};
  for (std::size_t l = 0; l < lights.size(); ++l) {
    json["lights"].push_back({{"light", lights[l]}});
    json["lights"].back().update(irradiance_json(lit.received[l]));
    if (layout.radiance) json["lights"].back().update(radiance_json(lit.reflected.lights[l], "radiance_error_bound"));
  }
  if (layout.sum) json["sum"] = irradiance_json(total_irradiance(lit.received));
  if (!layout.radiance) return json;
  json["eye"] = lit.eye;
  json["ambient"] = radiance_json(lit.reflected.ambient, "radiance_error_bound");
  json["total"] = radiance_json(lit.reflected.total(), "radiance_error_bound");
  return json;
}

Json summary_json(const IrradianceSummary& summary) {
  return {{"mean", irradiance_json(summary.mean())},
          {"least", irradiance_json(summary.least())},
          {"largest", irradiance_json(summary.largest())}};
}

Json summaries_json(const IrradianceSummaries& summaries) {
  Json json = {{"lights", Json::array()}};
  for (std::size_t l = 0; l < summaries.lights.size(); ++l) {
    json["lights"].push_back({{"light", summaries.names[l]}});
    json["lights"].back().update(summary_json(summaries.lights[l]));
  }
  json["sum"] = summary_json(summaries.sum);
  return json;
}

/// ",irradiance,error_bound"
std::string csv_columns(const Irradiance& e) {
  return ',' + number_text(e.value) + ',' + number_text(printed_error_bound(e.value, e.error_bound));
}

TextRow summary_row(const std::string& name, const IrradianceSummary& summary) {
  TextRow row{name};
  for (const Irradiance& e : {summary.mean(), summary.least(), summary.largest()}) {
    row.push_back(rounded_text(e.value) + " +- " + rounded_text(printed_error_bound(e.value, e.error_bound)));
  }
  return row;
}

}  // namespace

std::vector<char> packed_results(const LitRow& lit) {
  std::string bytes;
  append_bytes(bytes, lit.received);
  append_bytes(bytes, lit.reflected.lights);
  append_bytes(bytes, std::vector<RadianceRgb>{lit.reflected.ambient});
  append_bytes(bytes, std::vector<double>(lit.eye.begin(), lit.eye.end()));
  return {bytes.begin(), bytes.end()};
}

void unpack_results(std::span<const char> bytes, LitRow& lit) {
  std::string_view left(bytes.data(), bytes.size());
  lit.received = take_values<Irradiance>(left);
  lit.reflected.lights = take_values<RadianceRgb>(left);
  lit.reflected.ambient = take_values<RadianceRgb>(left).at(0);
  std::ranges::copy(take_values<double>(left), lit.eye.begin());
}

void IrradianceSummaries::add(const LitRow& lit) {
  if (!std::holds_alternative<PointRow>(lit.row)) return;
  for (std::size_t l = 0; l < lights.size(); ++l) lights[l].add(lit.received[l]);
  sum.add(total_irradiance(lit.received));
}

std::string IrradianceSummaries::text() const {
  if (sum.count() == 0) return "0 points\n";
  std::vector<TextRow> rows{{"light", "mean", "least", "largest"}};
  for (std::size_t l = 0; l < lights.size(); ++l) rows.push_back(summary_row(names[l], lights[l]));
  if (lights.size() != 1) rows.push_back(summary_row("all", sum));
  return counted(sum.count(), "point") + ", irradiance in W/m^2\n" + aligned(rows, 2);
}

IrradianceCsv::IrradianceCsv(std::ostream& stream, const std::string& header, std::vector<std::string> lights,
                             const IrradianceLayout& layout)
    : stream_(stream), lights_(std::move(lights)), layout_(layout) {
  stream_ << header;
  if (!layout_.wide && !layout_.sum) stream_ << ",light" << column_names("");
  if (layout_.wide) {
    for (const std::string& light : lights_) stream_ << column_names('_' + light);
  }
  if (layout_.sum) stream_ << column_names("");
  stream_ << '\n';
  for (std::string& light : lights_) light = csv_field(light);
}

std::string IrradianceCsv::column_names(const std::string& suffix) const {
  const std::string names = ',' + csv_field("irradiance" + suffix) + ',' + csv_field("error_bound" + suffix);
  return layout_.radiance ? names + layout_.radiance->header("radiance_error_bound", suffix) : names;
}

std::string IrradianceCsv::columns_of(const LitRow& lit, std::size_t light) const {
  const std::string columns = csv_columns(lit.received[light]);
  return layout_.radiance ? columns + layout_.radiance->text(lit.reflected.lights[light]) : columns;
}

void IrradianceCsv::add(const LitRow& lit) {
  const auto* row = std::get_if<PointRow>(&lit.row);
  if (!row) return;
  if (!layout_.wide && !layout_.sum) {
    for (std::size_t l = 0; l < lights_.size(); ++l) {
      stream_ << row->text << ',' << lights_[l] << columns_of(lit, l) << '\n';
    }
    return;
  }
  stream_ << row->text;
  if (layout_.wide) {
    for (std::size_t l = 0; l < lights_.size(); ++l) stream_ << columns_of(lit, l);
  }
  if (layout_.sum) {
    stream_ << csv_columns(total_irradiance(lit.received));
    if (layout_.radiance) stream_ << layout_.radiance->text(lit.reflected.total());
  }
  stream_ << '\n';
}

IrradianceJson::IrradianceJson(std::ostream& stream, const SpaceScene& scene, std::vector<std::string> lights,
                               const IrradianceLayout& layout, const std::string& material)
    : stream_(stream), lights_(std::move(lights)), layout_(layout) {
  const auto quoted = [](const std::string& text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  stream_ << "{\n  \"schema\": \"gnomon/irradiance/1\",\n  \"scene\": " << quoted(scene.source)
          << ",\n  \"length_unit\": " << quoted(scene.length_unit) << ",\n  \"irradiance_unit\": \"W/m^2\"";
  if (layout_.radiance) {
    stream_ << ",\n  \"material\": " << quoted(material) << ",\n  \"radiance_unit\": \"W/(m^2 sr)\"";
  }
  stream_ << ",\n  \"points\": [";
}

void IrradianceJson::add(const LitRow& lit) {
  stream_ << (std::exchange(first_, false) ? "\n    " : ",\n    ") << row_json(lit, lights_, layout_).dump();
}

void IrradianceJson::finish(const IrradianceSummaries& summaries, std::size_t malformed_lines) {
  stream_ << "\n  ],\n  \"point_count\": " << summaries.sum.count() << ",\n  \"malformed_lines\": " << malformed_lines;
  if (summaries.sum.count() > 0) stream_ << ",\n  \"summary\": " << summaries_json(summaries).dump();
  stream_ << "\n}\n";
}

}  // namespace gnomon
