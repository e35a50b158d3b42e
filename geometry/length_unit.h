#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace gnomon {

/// A unit of length: `top` / `bottom` metres, exactly.
struct LengthUnit {
  std::string_view name;
  double top = 1;
  double bottom = 1;
};

/// The units that scene files may use. An inch is 0.0254 m, a foot 0.3048 m.
inline constexpr std::array<LengthUnit, 6> length_units{
    {{"mm", 1, 1000}, {"cm", 1, 100}, {"m", 1, 1}, {"km", 1000, 1}, {"in", 127, 5000}, {"ft", 381, 1250}}};

/// The unit of that name; nothing if there is none.
inline std::optional<LengthUnit> length_unit_named(std::string_view name) {
  for (const LengthUnit& unit : length_units) {
    if (unit.name == name) return unit;
  }
  return std::nullopt;
}

}  // namespace gnomon
