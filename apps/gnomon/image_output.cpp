#include "apps/gnomon/image_output.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "apps/gnomon/output_file.h"
#include "apps/gnomon/text.h"
#include "shading/image/tone.h"
#include "viz/vtk/image_files.h"

namespace gnomon {
namespace {

/// The largest bound of a pixel's radiance that is finite.
double worst_bound(const image::ShadedImage& picture) {
  double worst = 0;
  for (const image::ImagePixel& pixel : picture.pixels) {
    for (const Radiance& r : pixel.radiance) {
      if (r.error_bound < HUGE_VAL) worst = std::max(worst, r.error_bound);
    }
  }
  return worst;
}

/// Pixels on a point or linear light itself, or of which nothing is known.
std::size_t unbounded_pixels(const image::ShadedImage& picture) {
  const auto is_unbounded = [](const image::ImagePixel& pixel) {
    return std::ranges::any_of(pixel.radiance, [](const Radiance& r) { return !(r.error_bound < HUGE_VAL); });
  };
  return static_cast<std::size_t>(std::ranges::count_if(picture.pixels, is_unbounded));
}

void append_float(std::string& bytes, double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(bits >> shift & 0xff));
}

/// Portable float map: rows from the bottom, little endian.
std::string pfm_text(const image::ShadedImage& picture) {
  std::string text = "PF\n" + std::to_string(picture.width) + ' ' + std::to_string(picture.height) + "\n-1.0\n";
  for (std::size_t j = picture.height; j-- > 0;) {
    for (std::size_t i = 0; i < picture.width; ++i) {
      for (const Radiance& r : picture.pixels[j * picture.width + i].radiance) append_float(text, r.value);
    }
  }
  return text;
}

template <class Value, class Of>
viz::PixelArray array_of(const image::ShadedImage& picture, const std::string& name, std::size_t components, Of of) {
  std::vector<Value> values;
  values.reserve(components * picture.pixels.size());
  for (const image::ImagePixel& pixel : picture.pixels) {
    for (std::size_t c = 0; c < components; ++c) values.push_back(of(pixel, c));
  }
  return {name, components, std::move(values)};
}

std::vector<viz::PixelArray> arrays_of(const image::ShadedImage& picture) {
  using Pixel = image::ImagePixel;
  return {array_of<double>(picture, "radiance", 3, [](const Pixel& p, std::size_t c) { return p.radiance[c].value; }),
          array_of<double>(picture, "radiance_error_bound", 3,
                           [](const Pixel& p, std::size_t c) { return p.radiance[c].error_bound; }),
          array_of<double>(picture, "irradiance", 1, [](const Pixel& p, std::size_t) { return p.irradiance.value; }),
          array_of<double>(picture, "irradiance_error_bound", 1,
                           [](const Pixel& p, std::size_t) { return p.irradiance.error_bound; }),
          array_of<double>(picture, "depth", 1, [](const Pixel& p, std::size_t) { return p.depth; }),
          array_of<std::int32_t>(picture, "element_id", 1, [](const Pixel& p, std::size_t) { return p.element; }),
          array_of<std::int32_t>(picture, "facet_id", 1, [](const Pixel& p, std::size_t) { return p.facet; })};
}

std::string ending_in_small_letters(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

double fallback_share(const image::ShadedImage& picture) {
  return picture.answers == 0 ? 0 : double(picture.exact_answers) / double(picture.answers);
}

}  // namespace

void write_picture(const image::ShadedImage& picture, const SpaceScene& scene, double exposure,
                   const std::filesystem::path& file) {
  const std::string ending = ending_in_small_letters(file);
  if (ending == ".pfm") return write_output_file(file, pfm_text(picture));
  if (ending == ".png") return viz::write_png(file, picture.width, picture.height, grey_levels(picture, exposure));
  viz::write_pixels(file, picture.width, picture.height, arrays_of(picture),
                    {{"producer", std::vector<std::string>{"gnomon"}},
                     {"version", std::vector<std::string>{GNOMON_VERSION}},
                     {"scene", std::vector<std::string>{scene.source}},
                     {"length_unit", std::vector<std::string>{scene.length_unit}},
                     {"element_names", picture.elements}});
}

nlohmann::ordered_json image_json(const image::ShadedImage& picture, const SpaceScene& scene, const ImageStory& story) {
  return {{"schema", "gnomon/image/1"},
          {"scene", scene.source},
          {"file", story.file},
          {"width", picture.width},
          {"height", picture.height},
          {"shading", story.shading},
          {"lights", story.lights},
          {"samples", story.samples},
          {"exposure", story.exposure},
          {"elements", picture.elements},
          {"radiance_unit", "W/(m^2 sr)"},
          {"worst_error_bound", worst_bound(picture)},
          {"unbounded_pixels", unbounded_pixels(picture)},
          {"rays", picture.rays},
          {"answers", picture.answers},
          {"fallback_share", fallback_share(picture)},
          {"seconds", story.seconds}};
}

std::string image_text(const image::ShadedImage& picture, const ImageStory& story) {
  const std::size_t unbounded = unbounded_pixels(picture);
  const std::string off =
      story.lights == "exact" ? "no pixel off by more than " : "no pixel off from its point lights by more than ";
  const std::string rounding = story.file.ends_with(".pfm")   ? "; the file rounds them to 32-bit floats"
                               : story.file.ends_with(".png") ? "; the file rounds them to 8 bits a colour"
                                                              : "";
  return in_columns(story.file + ": " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                    " pixels in " + rounded_text(story.seconds) + " s, exposure " + rounded_text(story.exposure) +
                    ", " + off + rounded_text(worst_bound(picture)) + " W/(m^2 sr)" +
                    (unbounded == 0 ? "" : " but " + counted(unbounded, "pixel") + " without a bound") + rounding);
}

}  // namespace gnomon
