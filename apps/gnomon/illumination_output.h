#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "viz/vtk/illumination_writer.h"

namespace gnomon {

/// The result as JSON of schema gnomon/illuminate/1. Areas are in squares of the scene's unit of length, flux in W.
nlohmann::ordered_json illumination_json(const IlluminationResult& result, const Illumination& found);

/// One line for each side, and one for all.
std::string illumination_summary(const IlluminationResult& result, const Illumination& found);

}  // namespace gnomon
