#pragma once

#include <filesystem>
#include <stdexcept>

#include "gnomon/picture.h"
#include "viz/pictures/picture_source.h"

namespace gnomon::viz {

/// The pixels could not be written; what() says why.
class PngError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Draws a picture as pixels, on the display that DISPLAY names or on a virtual one.
///
/// Requires: width and height at least 64.
/// Throws:   NoDisplayError, PngError.
void write_png(const PictureSource& source, const PictureOptions& options, const std::filesystem::path& file);

}  // namespace gnomon::viz
