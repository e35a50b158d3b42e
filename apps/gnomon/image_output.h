#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gnomon/scene.h"
#include "shading/image/shaded_image.h"

namespace gnomon {

/// How a picture was asked for, and what it took.
struct ImageStory {
  std::string file;
  std::string shading;
  std::string lights;
  std::uint32_t samples = 1;
  double exposure = 1;
  double seconds = 0;
};

/// Writes a picture as its file's ending says: .png, .pfm or .vti.
///
/// Throws: std::runtime_error naming the file.
void write_picture(const image::ShadedImage& picture, const SpaceScene& scene, double exposure,
                   const std::filesystem::path& file);

/// The result as JSON of schema gnomon/image/1.
nlohmann::ordered_json image_json(const image::ShadedImage& picture, const SpaceScene& scene, const ImageStory& story);

/// The same for people: a line or two.
std::string image_text(const image::ShadedImage& picture, const ImageStory& story);

}  // namespace gnomon
