#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "viz/vtk/field_data.h"

namespace gnomon::viz {

/// A number or vector of every pixel, row by row from the upper left one.
struct PixelArray {
  std::string name;
  std::size_t components = 1;
  std::variant<std::vector<double>, std::vector<std::int32_t>> values;
};

/// A picture's pixels as cells of VTK image data, x to the right and y up; completely written, then renamed into place.
///
/// Throws: std::runtime_error naming the file that could not be written.
void write_pixels(const std::filesystem::path& file, std::uint32_t width, std::uint32_t height,
                  std::span<const PixelArray> arrays, const Fields& fields);

/// A PNG of red, green and blue, row by row from the top. Needs no display.
///
/// Throws: std::runtime_error naming the file that could not be written.
void write_png(const std::filesystem::path& file, std::uint32_t width, std::uint32_t height,
               std::span<const std::uint8_t> levels);

}  // namespace gnomon::viz
