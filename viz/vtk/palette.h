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
  Color receiver = {0.82, 0.82, 0.83};
  Color lit = {1.00, 0.97, 0.86};
  Color penumbra = {0.47, 0.71, 0.89};
  Color umbra = {0.07, 0.22, 0.42};
  Color occlusion = {0.60, 0.60, 0.60};
  Color separating = {0.72, 0.11, 0.42};
  Color supporting = {0.00, 0.43, 0.26};
  Color edge = {0.12, 0.12, 0.14};
  Color unlit = {0.35, 0.33, 0.36};
  Color unresolved_eee = {0.80, 0.47, 0.65};
  /// Where the visible fraction jumps, its first derivative does, or its second.
  std::array<Color, 3> discontinuities = {{{0.20, 0.00, 0.05}, {0.85, 0.08, 0.35}, {0.48, 0.92, 0.48}}};
};

inline constexpr Palette palette;

}  // namespace gnomon::viz
