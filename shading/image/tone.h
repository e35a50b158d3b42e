#pragma once

/// From radiance to grey levels.

#include <cstdint>
#include <vector>

#include "shading/image/shaded_image.h"

namespace gnomon::image {

/// What radiance is multiplied by so that of a hundred pixels that show a surface one is brighter than 0.8.
///
/// Definition: 0.8 over the 99th percentile of luminance, 0.2126 red + 0.7152 green + 0.0722 blue, of the pixels that
///             show a blocker or receiver; 1 where that is 0 or infinite.
double automatic_exposure(const ShadedImage& image);

/// Red, green and blue of 0 to 255, row by row from the top: the nearest to 255 times the sRGB curve of exposure times
/// radiance, above 1 cut. Not dithered.
std::vector<std::uint8_t> grey_levels(const ShadedImage& image, double exposure);

}  // namespace gnomon::image
