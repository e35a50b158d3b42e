#include "apps/gnomon/illumination_output.h"

#include <algorithm>
#include <cmath>

#include "apps/gnomon/text.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

/// A point of a side, and how bright it is.
struct Extremum {
  Point3 point;
  Irradiance irradiance;
};

/// Sums over the pieces of a side.
struct SideSums {
  std::size_t faces = 0, points = 0, unmet = 0;
  double area = 0, unmet_area = 0, largest_error = 0, flux = 0, flux_bound = 0;
  Extremum least, largest;
};

double square_metres(double area, const Scene& scene) {
  const LengthUnit unit = *length_unit_named(facts(scene).length_unit);
  return area * (unit.top / unit.bottom) * (unit.top / unit.bottom);
}

SideSums sums_of(const IlluminatedSide& side, const Scene& scene) {
  SideSums sums;
  sums.least.irradiance.value = HUGE_VAL;
  sums.largest.irradiance.value = -HUGE_VAL;
  for (const IlluminationMesh* mesh : side.pieces) {
    sums.faces += mesh->faces.size();
    sums.points += mesh->points.size();
    sums.unmet += mesh->unmet_faces();
    sums.area += mesh->area();
    sums.unmet_area += mesh->unmet_area();
    sums.largest_error = std::max(sums.largest_error, mesh->largest_error());
    sums.flux += square_metres(mesh->flux(), scene);
    sums.flux_bound += square_metres(mesh->flux_error(), scene);
    for (std::size_t i = 0; i < mesh->points.size(); ++i) {
      const Extremum here{mesh->points[i], mesh->irradiance[i]};
      if (here.irradiance.value < sums.least.irradiance.value) sums.least = here;
      if (here.irradiance.value > sums.largest.irradiance.value) sums.largest = here;
    }
  }
  return sums;
}

/// JSON has no infinite numbers; they are told as null.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json extremum_json(const Extremum& extremum) {
  return {{"irradiance", number(extremum.irradiance.value)},
          {"error_bound", number(extremum.irradiance.error_bound)},
          {"at", {extremum.point.x, extremum.point.y, extremum.point.z}}};
}

}  // namespace

Json illumination_json(const IlluminationResult& result, const Illumination& found) {
  Json receivers = Json::array();
  for (const IlluminatedSide& side : result.sides) {
    const SideSums sums = sums_of(side, *result.scene);
    receivers.push_back({{"name", side.name},
                         {"area", sums.area},
                         {"faces", sums.faces},
                         {"points", sums.points},
                         {"largest_error", number(sums.largest_error)},
                         {"unmet", {{"faces", sums.unmet}, {"area", sums.unmet_area}}},
                         {"flux", {{"value", number(sums.flux)}, {"error", number(sums.flux_bound)}}},
                         {"least", extremum_json(sums.least)},
                         {"largest", extremum_json(sums.largest)},
                         {"unbounded", !std::isfinite(sums.largest.irradiance.value)}});
  }
  return {{"schema", "gnomon/illuminate/1"},
          {"scene", facts(*result.scene).source},
          {"length_unit", facts(*result.scene).length_unit},
          {"lights", result.lights},
          {"tolerance", found.tolerance},
          {"largest", found.largest},
          {"order", result.order},
          {"errors_are", "estimate"},
          {"receivers", std::move(receivers)},
          {"evaluations", found.evaluations}};
}

std::string illumination_summary(const IlluminationResult& result, const Illumination& found) {
  constexpr std::size_t most_lines = 40;
  std::vector<TextRow> rows{{"receiver", "faces", "largest [W/m^2]", "flux [W]", "error", "unmet"}};
  std::size_t faces = 0;
  for (const IlluminatedSide& side : result.sides) {
    const SideSums sums = sums_of(side, *result.scene);
    faces += sums.faces;
    if (rows.size() > most_lines) continue;
    rows.push_back({side.name, std::to_string(sums.faces), rounded_text(sums.largest.irradiance.value),
                    rounded_text(sums.flux), rounded_text(sums.largest_error), std::to_string(sums.unmet)});
  }
  std::string text = counted(faces, "face") + ", tolerance " + rounded_text(found.tolerance) + " W/m^2";
  text += ", largest irradiance " + rounded_text(found.largest) + " W/m^2\n" + aligned(rows, 2);
  if (result.sides.size() > most_lines) {
    text += "  and " + std::to_string(result.sides.size() - most_lines) + " more; --json lists them all\n";
  }
  return text;
}

}  // namespace gnomon
