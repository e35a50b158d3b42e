#pragma once

/// @file
/// How much light arrives, each number with a bound of its error.
///
///     #include <gnomon/irradiance.h>
///     int main() {
///       using namespace gnomon;
///       const Light bulb = PointLight{{0, 0, 2}};
///       const Irradiance once = light_irradiance(bulb, 100, {}, {0, 0, 0}, {0, 0, 1});  // 100 W/sr, 2 m above
///       LightIrradiance often(bulb, 100, PreparedObstacles({}));                        // made ready for many points
///       const bool is_sure = 25 - once.error_bound <= once.value && once.value <= 25 + once.error_bound;
///       return is_sure && often.at({1, 0, 0}, {0, 0, 1}).value < 25 ? 0 : 1;
///     }

#include <cstddef>
#include <memory>
#include <span>

#include "gnomon/light.h"
#include "gnomon/point.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// Irradiance on a receiver [W/m²].
/// Exactness: |value - exact| is at most `error_bound`, which includes every rounding.
struct Irradiance {
  double value = 0;
  double error_bound = 0;
};

/// The sum of what several lights give to one receiver. Infinite, with an infinite bound, where one of them is.
Irradiance total_irradiance(std::span<const Irradiance> parts);

/// Mean, least and largest of many irradiances, each with a bound of its error.
///
/// Exactness: the bounds hold for mean, least and largest of the exact values, roundings of this class included.
/// Degenerate: infinite values make the mean and the largest infinite, with infinite bounds.
class IrradianceSummary {
 public:
  void add(const Irradiance& irradiance);

  std::size_t count() const { return count_; }

  /// Requires: count() > 0.
  Irradiance mean() const;
  Irradiance least() const;
  Irradiance largest() const;

 private:
  std::size_t count_ = 0;
  Irradiance sum_;
  double least_ = 0, least_low_ = 0, least_high_ = 0;        ///< the exact least lies from low to high
  double largest_ = 0, largest_low_ = 0, largest_high_ = 0;  ///< the exact largest likewise
};

/// The irradiance that one light gives to receivers behind obstacles.
///
/// Definition: what is visible of the light before the receiver (exact_received), above its horizon: lambert_irradiance
///             for area lights, the integral of cosine over squared distance, times what a linear light emits that way,
///             for linear and point lights, the cosine for directional ones; times the light's strength.
/// Degenerate: infinite at a visible point of a point or linear light. Positive exactly where exact_received says lit
///             or penumbra, if the strength is and the light emits that way.
/// Exactness:  with an error bound. What is visible is exact; where the fast level does not decide, or has no bound
///             below 1e-6 of the strength, the exact level makes the polygons.
/// Cost:       memory is kept for the next question, so one object per thread.
class LightIrradiance {
 public:
  /// `strength` is radiance [W/(m² sr)], intensity per length [W/(sr m)], intensity [W/sr] or irradiance [W/m²] of an
  /// area, linear, point or directional light, and not negative.
  LightIrradiance(Light light, double strength, PreparedObstacles obstacles, const LinearSearch& search = {});
  LightIrradiance(LightIrradiance&&) noexcept;
  LightIrradiance& operator=(LightIrradiance&&) noexcept;
  ~LightIrradiance();

  /// Requires: finite coordinates, a normal that is not zero.
  /// Throws:   PreconditionError for a normal without direction.
  Irradiance at(const Point3& p, const Point3& normal);

  /// The same of a receiver's point whose front is given otherwise, as a facet's plane; `normal` is then that of the
  /// facet up to rounding, and gives the cosines.
  Irradiance received(const ReceiverPoint& receiver, const Point3& normal);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// The same for one point alone, nothing kept.
Irradiance light_irradiance(const Light& light, double strength, const Obstacles& obstacles, const Point3& p,
                            const Point3& normal);

/// The irradiance in W/m² of a light whose scene measures lengths in another unit.
///
/// Definition: `e` is worked out as if the unit were the metre, from the strength as the scene file has it [W/(m² sr),
///             W/(sr m), W/sr, W/m²]. With a unit of u metres that of a point light is 1/u² times as large, that of a
///             linear light 1/u; radiance and a sun's irradiance know no distance.
/// Exactness:  the bound grows by that of the conversion.
Irradiance per_square_metre(const Irradiance& e, const Light& light, const LengthUnit& unit);

}  // namespace gnomon
