#include "shading/image/tone.h"

#include <algorithm>
#include <cmath>

namespace gnomon::image {
namespace {

double luminance(const RadianceRgb& r) {
  return 0.2126 * r[0].value + 0.7152 * r[1].value + 0.0722 * r[2].value;
}

/// IEC 61966-2-1.
double srgb_curve(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace

double automatic_exposure(const ShadedImage& image) {
  std::vector<double> shown;
  for (const ImagePixel& pixel : image.pixels) {
    const bool is_surface = pixel.element >= 0 && static_cast<std::size_t>(pixel.element) < image.surfaces;
    if (is_surface) shown.push_back(luminance(pixel.radiance));
  }
  if (shown.empty()) return 1;
  const auto at = shown.begin() + static_cast<std::ptrdiff_t>((shown.size() - 1) * 99 / 100);
  std::nth_element(shown.begin(), at, shown.end());
  return *at > 0 && *at < HUGE_VAL ? 0.8 / *at : 1;
}

std::vector<std::uint8_t> grey_levels(const ShadedImage& image, double exposure) {
  std::vector<std::uint8_t> levels;
  levels.reserve(3 * image.pixels.size());
  for (const ImagePixel& pixel : image.pixels) {
    for (const Radiance& r : pixel.radiance) {
      const double linear = std::fmin(r.value == 0 ? 0 : exposure * r.value, 1);
      levels.push_back(static_cast<std::uint8_t>(std::lround(255 * srgb_curve(linear))));
    }
  }
  return levels;
}

}  // namespace gnomon::image
