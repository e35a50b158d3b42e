#include "apps/gnomon/sunlight_output.h"

#include <nlohmann/json.hpp>

#include "apps/gnomon/text.h"
#include "geometry/numbers/printed_bound.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

Json event_name_json(const SunEventName& name, const std::vector<std::string>& parts) {
  switch (name.kind) {
    case SunEventName::Kind::midnight:
      return "midnight";
    case SunEventName::Kind::horizon:
      return "horizon";
    case SunEventName::Kind::receiver:
      return "receiver";
    case SunEventName::Kind::shadow:
      break;
  }
  return {{"blocker", parts[name.blocker]}, {"edge", name.edge}};
}

Json event_json(const SunEvent& event, const std::vector<std::string>& parts) {
  return {{"hour", event.hour},
          {"error_bound", printed_error_bound(event.hour, event.error_bound)},
          {"name", event_name_json(event.name, parts)}};
}

}  // namespace

void write_sunlight_rows(std::ostream& stream, std::span<const SunlitRow> rows) {
  for (const SunlitRow& row : rows) {
    stream << row.row.text << ',' << number_text(row.day.hours) << ','
           << number_text(printed_error_bound(row.day.hours, row.day.error_bound)) << ',';
    bool is_first = true;
    for (const SunInterval& interval : row.day.intervals) {
      stream << (is_first ? "" : " ") << number_text(interval.start.hour) << '-' << number_text(interval.end.hour);
      is_first = false;
    }
    stream << '\n';
  }
}

Json sunlight_json(const SpaceScene& scene, const SunDay& day, std::span<const SunlitRow> rows,
                   const std::vector<std::string>& parts) {
  Json points = Json::array();
  for (const SunlitRow& row : rows) {
    Json intervals = Json::array();
    for (const SunInterval& interval : row.day.intervals) {
      intervals.push_back({{"from", event_json(interval.start, parts)}, {"to", event_json(interval.end, parts)}});
    }
    points.push_back({{"at", row.row.coordinates},
                      {"hours", row.day.hours},
                      {"error_bound", printed_error_bound(row.day.hours, row.day.error_bound)},
                      {"tied", row.day.tied},
                      {"intervals", std::move(intervals)}});
  }
  return {{"schema", "gnomon/sunlight/1"},  {"scene", scene.source}, {"latitude", day.latitude},
          {"declination", day.declination}, {"time", "local solar"}, {"north", {day.north.x, day.north.y, day.north.z}},
          {"points", std::move(points)}};
}

}  // namespace gnomon
