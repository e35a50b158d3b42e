#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "apps/proof/report/visibility_answer.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::report {

/// Where the k * k points on the light are.
enum class Placing {
  regular,     ///< in the middles of k * k cells: point lights instead of the light
  jittered,    ///< anywhere in their cells, the same for all that look
  stratified,  ///< anywhere in their cells, new ones for each point that looks
};

/// How rays are handed to Embree: by ones, or by eights, told to be coherent, which is its fastest way on AVX2.
enum class Rays { single, packets };

/// What a point sees of an area light by shadow rays of Embree 3 to points on the light. Coordinates are rounded to
/// floats, as Embree takes them.
class EmbreeVisibility {
 public:
  EmbreeVisibility(const AreaLight& light, std::span<const ConvexBlocker> blockers);
  EmbreeVisibility(EmbreeVisibility&&) noexcept;
  EmbreeVisibility& operator=(EmbreeVisibility&&) noexcept;
  ~EmbreeVisibility();

  /// Places k * k points from a fixed seed.
  /// Requires: k is positive.
  void place(Placing placing, std::size_t k, Rays rays = Rays::single);

  /// Fraction: the share of points that are not hidden. Region: lit or umbra where all points agree.
  /// Requires: for the irradiance, a light wholly above the receiver's horizon.
  VisibilityAnswer visible_from(const Point3& p, const Point3& normal);

  /// What Embree holds for the blockers.
  std::size_t bytes() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace gnomon::report
