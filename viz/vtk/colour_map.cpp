#include "viz/vtk/colour_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon::viz {
namespace {

/// The curve of sRGB.
double coded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// OKLab (B. Ottosson, 2020) to sRGB.
Color srgb(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {coded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          coded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          coded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Color colour_of_share(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  // As much chroma as can be shown at that lightness and hue, less a little.
  const double chroma = 0.10 - 0.032 * std::sin(std::numbers::pi * t) + 0.03 * t * t;
  return srgb(0.25 + 0.70 * t, chroma, (290 - 185 * t) * std::numbers::pi / 180);
}

RoundScale round_scale(double largest) {
  if (!(largest > 0)) return {};
  double power = std::pow(10, std::floor(std::log10(largest)) - 1);
  if (power == 0) return {largest, 1};
  for (;; power *= 10) {
    for (const int digit : {1, 2, 5}) {
      const double step = digit * power;
      const double steps = std::ceil(largest / step);
      if (steps <= 8) return {step, static_cast<int>(steps)};
    }
  }
}

}  // namespace gnomon::viz
