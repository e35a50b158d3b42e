#pragma once

/// A light as pictures ask it: as it is, or as points. Private to the libraries.

#include <cstdint>
#include <optional>
#include <vector>

#include "gnomon/reflection.h"
#include "gnomon/scene.h"
#include "shading/image/shaded_image.h"

namespace gnomon::image {

/// A point that stands for a part of a linear or area light of strength 1.
struct LightSample {
  Point3 place;
  double weight = 1;     ///< the part's length or area
  Point3 normal = {};    ///< of an area light's front, of unit length
  bool is_flat = false;  ///< of an area light: times the cosine between normal and direction
  bool two_sided = false;
};

/// The middles of equal parts: of a linear light `count`, of an area light a grid of the divisors of `count` that make
/// its cells most like squares, over the smallest rectangle along the first side; of other polygons those on it, each
/// for as much of its area.
/// Exactness: rounded.
std::vector<LightSample> light_samples(const Light& light, std::uint32_t count);

/// What one light gives, exactly visible in every case.
class LightSource {
 public:
  /// The options say how many points stand for a linear or area light, 0 for the light itself, and how occluders are
  /// found.
  LightSource(const SceneLight& light, const PreparedObstacles& obstacles, const ImageOptions& options);

  /// Points of a linear light have its emission, each from its own place; its shade is decided exactly for all of them.
  /// Exactness: of the light, or of its points with these weights, which are rounded: with error bounds.
  Reflection received(const ReceiverPoint& receiver, const View& view, ReflectionModel model, int exponent);

  std::size_t answers() const;
  std::size_t exact_answers() const;

 private:
  double weight_towards(const LightSample& sample, const Point3& p) const;

  std::optional<LinearLight> shining_;  ///< of points: the light that does not shine alike in all directions
  std::vector<LightSample> samples_;    ///< none: the light itself
  std::vector<LightReflection> reflections_;
};

}  // namespace gnomon::image
