#pragma once

/// Pictures of scenes, every pixel with a bound of its error.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "gnomon/reflection.h"
#include "gnomon/scene.h"

namespace gnomon::image {

/// Where radiance is worked out: once a facet at the mean of its corners, at the corners and interpolated, or at every
/// place with the normals of the corners interpolated.
/// After: [Ph73]; Gouraud 1971.
enum class ShadingMode { flat, gouraud, phong };

struct ImageOptions {
  ShadingMode shading = ShadingMode::phong;
  std::uint32_t points = 0;   ///< points that stand for every linear and area light; 0: the lights themselves
  std::uint32_t samples = 1;  ///< rays along each side of a pixel
  unsigned threads = 1;
  LinearSearch search = {};  ///< for what may hide a linear light
};

/// What a pixel shows: means over its rays of radiance and irradiance; the rest is that of the ray through its middle.
struct ImagePixel {
  RadianceRgb radiance;
  Irradiance irradiance;      ///< of all lights, colours left out [W/m²]
  double depth = 0;           ///< distance from the eye; infinite where nothing is
  std::int32_t element = -1;  ///< index of Image::elements; -1 where nothing is
  std::int32_t facet = -1;    ///< of that element
};

struct ShadedImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::string> elements;  ///< blockers and receivers, then polygon lights
  std::size_t surfaces = 0;           ///< how many of them are no lights
  std::vector<ImagePixel> pixels;     ///< row by row, from the upper left one
  std::size_t flattened = 0;          ///< facets shaded flat because normals at a corner cancel
  std::size_t rays = 0;               ///< from the eye
  std::size_t answers = 0;            ///< of lights
  std::size_t exact_answers = 0;      ///< those that the exact level gave
};

/// A picture of a scene from its camera.
///
/// Definition: the first facet that a ray meets (FirstHit) is shaded on the side that is seen, at the point in doubles
///             where it is met. Visibility of every light from there is exact, the facet and the solid that it bounds
///             left out; lights are cut at the facet's plane, then at the normal's horizon. An eye below that horizon
///             sees diffuse light alone. A polygon light that is met shows its radiance. Elsewhere it is dark.
/// Exactness:  a pixel's bound holds for its points and normals in doubles, not for where a ray would meet a surface
///             without rounding. Interpolated radiance has the bound of what is interpolated.
/// Returns:    the same for any number of threads.
/// Requires:   a scene of space with a camera.
ShadedImage shaded_image(const SpaceScene& scene, const ImageOptions& options,
                         const std::function<void(std::size_t pixels)>& on_progress);

}  // namespace gnomon::image
