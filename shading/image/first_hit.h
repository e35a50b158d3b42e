#pragma once

/// What a ray meets first. Private to the libraries.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "shading/image/surfaces.h"

namespace gnomon::image {

/// From a point through another one.
struct Ray {
  Point3 eye;
  Point3 through;
};

struct Hit {
  std::uint32_t facet = 0;         ///< index among the facets
  std::uint32_t triangle = 0;      ///< of the facet's fan from its corner 0: corners 0, triangle + 1, triangle + 2
  bool is_front = true;            ///< the side that the eye sees
  Point3 place;                    ///< rounded
  std::array<double, 3> shares{};  ///< of the triangle's corners in the place; they are positive and add up to 1
};

/// The facets of a scene, made ready for rays.
///
/// Definition: the hit is the nearest one; of several at exactly the same place it is that of the lowest facet. Facets
///             that the ray runs along are not met; a light is met at its front, at both sides if it is two-sided.
/// Exactness:  which facets a ray meets and which of them is nearest is exact for the doubles of ray and corners.
/// Cost:       a hierarchy of boxes (CGAL's AABB tree); every facet behind the first one is looked at as well. Rays may
///             be asked for from several threads.
class FirstHit {
 public:
  /// Requires: facets that outlive this.
  explicit FirstHit(std::span<const Facet> facets);
  FirstHit(FirstHit&&) noexcept;
  ~FirstHit();

  std::optional<Hit> along(const Ray& ray) const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace gnomon::image
