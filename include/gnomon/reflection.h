#pragma once

/// @file
/// How much light a surface sends to an eye, each number with a bound of its error.
///
///     #include <gnomon/reflection.h>
///     int main() {
///       using namespace gnomon;
///       const Light tube = LinearLight{{-1, 0, 2}, {1, 0, 2}};
///       const Material lacquer{.diffuse = {.5, .5, .5}, .specular = {.3, .3, .3}, .exponent = 50};
///       const View view{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}};  // a point, its normal, and the way to the eye
///       const Rgb watts{10, 10, 10};                       // W/(sr m)
///       const RadianceRgb r = light_radiance(tube, watts, {}, view, lacquer);
///       return r[0].value > 0 && r[0].error_bound < 1e-9 ? 0 : 1;
///     }

#include <array>
#include <cstddef>
#include <memory>
#include <span>

#include "gnomon/irradiance.h"
#include "gnomon/light.h"
#include "gnomon/point.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// Red, green and blue; each linear.
using Rgb = std::array<double, 3>;

/// How a surface reflects beside diffusely. N is its unit normal, E points to the eye, L to the light, R = 2 (N . E) N
/// - E is the mirrored eye, H halves the way from L to E; n is the exponent; powers count where R . L > 0, for n = 0
/// too. With E_p the irradiance of a surface across L:
enum class ReflectionModel {
  phong,          ///< (n+2)/(2 pi) times the integral of (R . L)^n (N . L) over dE_p: keeps energy, reciprocal; [LW94]
  blinn,          ///< (n+2)(n+4)/(8 pi (n + 2^(-n/2))) times that of (N . H)^n (N . L): reciprocal
  phong_classic,  ///< the integral of (R . L)^n over dE_p, as [PA90] §4 and [P93] (3.11) have it
  blinn_classic,  ///< that of (N . H)^n: [P93] (3.4)
};

/// What a surface is made of. Of `phong` and `blinn`, diffuse and specular together reflect at most their sum.
struct Material {
  Rgb diffuse{.5, .5, .5};  ///< k_d, from 0 to 1
  Rgb specular{0, 0, 0};    ///< k_s, from 0 to 1; of the classic models any number that is not negative [1/sr]
  Rgb ambient{0, 0, 0};     ///< k_a, from 0 to 1
  int exponent = 32;        ///< n, from 0 to 10000
  ReflectionModel model = ReflectionModel::phong;
};

/// A point of a surface and who looks at it. Lengths of the two vectors mean nothing.
struct View {
  Point3 point;
  Point3 normal;  ///< to the side that receives and is looked at
  Point3 to_eye;
};

/// True if the eye is above the surface's plane: below it or in it nothing is seen.
/// Exactness: exact. Throws: PreconditionError as LightReflection.
bool eye_is_above(const View& view);

/// Radiance [W/(m² sr)].
/// Exactness: |value - exact| is at most `error_bound`, which includes every rounding.
struct Radiance {
  double value = 0;
  double error_bound = 0;
};

using RadianceRgb = std::array<Radiance, 3>;

/// What a light of strength 1 gives: the geometry of a reflection, the same for all colours.
struct Reflection {
  Irradiance received;  ///< the integral of N . L over dE_p, the irradiance
  Irradiance lobe;      ///< the integral of the model's lobe, without its norm
};

/// What a model's lobe is multiplied by: its norm c(n).
/// Requires: n from 0 to 10000.
double lobe_norm(ReflectionModel model, int exponent);

/// The radiance that a material reflects: (k_d / pi) times what is received and k_s c(n) times the lobe, times
/// strength.
///
/// Requires: numbers that are not negative.
/// Exactness: the bound grows by that of the products.
RadianceRgb reflected_radiance(const Reflection& reflection, const Material& material, const Rgb& strength);

/// The sum over several lights.
RadianceRgb total_radiance(std::span<const RadianceRgb> parts);

/// The exponent for which a highlight, cos^n of the angle from its middle, falls to a threshold at an angle [rad]:
/// log(threshold) / log(cos(angle)).
/// Requires: 0 < angle < pi/2, 0 < threshold < 1.
/// After:    [P93] (5.13).
double exponent_of_highlight(double angle, double threshold);

/// What one light gives to surfaces behind obstacles.
///
/// Definition: the integrals of Reflection over what is visible of the light above the surface's horizon. dE_p is dω
///             for an area light of radiance 1, dl/r² for a linear light of intensity 1 per length, times what its
///             emission is that way, 1/r² for a point light, 1 for a direction.
/// Degenerate: zero, with bound 0, where the eye is not above the surface. Infinite at a visible point of a point or
///             linear light. What is visible is the limit from the front (exact_received).
/// Exactness:  with error bounds. What is visible is exact. Where doubles do not decide on which side of the horizon or
///             of R's plane an end lies, or have no bound below 1e-9 of the integral's peak, emission not counted,
///             rational ends and intervals of rising precision answer.
/// Units:      those of Irradiance for strength 1.
/// Cost:       memory is kept for the next question, so one object per thread.
/// After:      [PA90] §3-4, [P93] §3.2-3.3, [Arvo95] §4; Blinn's lobe of area lights as an integral along the boundary.
class LightReflection {
 public:
  LightReflection(Light light, PreparedObstacles obstacles, const LinearSearch& search = {});
  LightReflection(LightReflection&&) noexcept;
  LightReflection& operator=(LightReflection&&) noexcept;
  ~LightReflection();

  /// Requires: finite coordinates; vectors that are not zero; an exponent from 0 to 10000.
  /// Throws:   PreconditionError.
  Reflection at(const View& view, ReflectionModel model, int exponent);

  /// The same of a receiver's point whose front is given otherwise, as a facet's plane; the view's normal is then that
  /// of the facet up to rounding.
  Reflection received(const ReceiverPoint& receiver, const View& view, ReflectionModel model, int exponent);

  /// How many questions were asked, and how many of them went to the exact level.
  std::size_t answers() const;
  std::size_t exact_answers() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// What one light of a strength gives for one view alone, nothing kept.
RadianceRgb light_radiance(const Light& light, const Rgb& strength, const Obstacles& obstacles, const View& view,
                           const Material& material);

}  // namespace gnomon
