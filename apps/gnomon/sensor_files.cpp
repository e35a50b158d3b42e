#include "apps/gnomon/sensor_files.h"

#include <variant>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/text.h"

namespace gnomon {

void require_sensor_places(const SensorFileNames& names, const std::vector<std::string>& read,
                           const std::vector<std::string>& other_results) {
  std::vector<std::string> written = other_results;
  for (const auto& [option, name] : {std::pair("--sensors", names.sensors), std::pair("--values", names.values)}) {
    require_place(option, name, OutputKind::text);
    require_unread(option, name, read);
    require_unwritten(option, name, written);
    written.push_back(name);
  }
}

SensorFiles::SensorFiles(const SensorFileNames& names) {
  if (!names.sensors.empty()) sensors_.emplace(names.sensors);
  if (!names.values.empty()) values_.emplace(names.values);
}

void SensorFiles::add(const LitRow& lit) {
  const auto* row = std::get_if<PointRow>(&lit.row);
  if (!row) return;
  if (values_) values_->stream() << number_text(total_irradiance(lit.received).value) << '\n';
  if (!sensors_) return;
  std::string line;
  for (const std::array<double, 3>& v : {row->coordinates, row->normal}) {
    for (const double x : v) line += (line.empty() ? "" : " ") + number_text(x);
  }
  sensors_->stream() << line << '\n';
}

void SensorFiles::publish() {
  if (sensors_) sensors_->publish();
  if (values_) values_->publish();
}

}  // namespace gnomon
