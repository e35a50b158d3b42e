#pragma once

/// Radiance at places of facets. Private to the libraries.

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "shading/image/first_hit.h"
#include "shading/image/light_source.h"
#include "shading/image/shaded_image.h"

namespace gnomon::image {

/// What is seen of a place.
struct Shaded {
  RadianceRgb radiance;
  Irradiance irradiance;
};

/// A facet from one of its sides.
struct FacetSide {
  const Facet* facet = nullptr;
  bool is_front = true;
};

/// What is the same for all pixels: lights, materials, unit, obstacles.
struct ShadedScene {
  const SpaceScene& scene;
  PreparedObstacles obstacles;
  std::vector<const SceneLight*> lights;
  Point3 eye;
};

/// The lights of one worker, in the scene's order.
using WorkersLights = std::vector<LightSource>;

/// What the eye sees of a place of a facet with a normal, which is turned to the facet's side that is seen.
Shaded shaded_place(const ShadedScene& scene, WorkersLights& lights, const FacetSide& side, const Point3& place,
                    const Point3& normal);

/// Shades hits in one of the modes; what is the same for a whole facet is worked out once, by whoever asks first.
class FacetShading {
 public:
  FacetShading(const ShadedScene& scene, std::span<const Facet> facets, ShadingMode mode);
  ~FacetShading();

  Shaded at(const Hit& hit, WorkersLights& lights);

 private:
  struct Kept;

  const std::vector<Shaded>& kept(const Hit& hit, WorkersLights& lights);
  std::vector<Shaded> corners(const FacetSide& side, WorkersLights& lights) const;

  const ShadedScene& scene_;
  std::span<const Facet> facets_;
  ShadingMode mode_;
  std::vector<Kept> kept_;  ///< two a facet: of its front and its back
};

}  // namespace gnomon::image
