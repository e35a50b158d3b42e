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
  Color penumbra = {0.47, 0.71, 0.89};
  Color umbra = {0.07, 0.22, 0.42};
  Color occlusion = {0.60, 0.60, 0.60};
  Color edge = {0.12, 0.12, 0.14};
};

inline constexpr Palette palette;

}  // namespace gnomon::viz
