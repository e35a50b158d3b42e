#pragma once

#include <array>

namespace gnomon::viz {

/// Red, green, blue in sRGB, 0 to 1.
using Color = std::array<double, 3>;

/// One set of colours for pictures, view.py and glTF. Regions differ in lightness, kinds in hue, so that they are told
/// apart without red and green, and in grey.
struct Palette {
  Color light = {0.94, 0.76, 0.05};
  Color blocker = {0.84, 0.37, 0.00};
  Color receiver = {0.95, 0.93, 0.87};
  Color lit = {1.00, 0.97, 0.86};
  Color penumbra = {0.47, 0.71, 0.89};
  Color umbra = {0.07, 0.22, 0.42};
  Color unlit = {0.35, 0.33, 0.36};
  Color unresolved = {0.80, 0.47, 0.65};
  Color occlusion = {0.60, 0.60, 0.60};
  Color separating = {0.72, 0.11, 0.42};
  Color supporting = {0.00, 0.48, 0.32};
  Color edge = {0.12, 0.12, 0.14};
};

inline constexpr Palette palette;

/// The colour of a region by its number.
inline constexpr Color region_color(int region) {
  const Color colors[] = {palette.lit, palette.penumbra, palette.umbra, palette.unlit, palette.unresolved};
  return region >= 0 && region < 5 ? colors[region] : palette.edge;
}

/// The colour of a discontinuity by its order.
inline constexpr Color order_color(int order) {
  const Color colors[] = {palette.edge, palette.separating, palette.supporting};
  return order >= 0 && order < 3 ? colors[order] : palette.edge;
}

}  // namespace gnomon::viz
