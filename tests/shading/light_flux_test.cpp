#include "shading/light_flux.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gnomon {
namespace {

constexpr double pi = std::numbers::pi;
constexpr LengthUnit metre = length_units[2];

double flux_of(const Light& light, double strength = 1, const LengthUnit& unit = metre) {
  return light_flux(light, strength, unit).value();
}

void expect_flux(const Light& light, double exact) {
  EXPECT_NEAR(flux_of(light), exact, 1e-12 * exact);
}

TEST(LightFlux, IsWhatALightEmitsInAllDirections) {
  expect_flux(PointLight{{1, 2, 3}}, 4 * pi);
  const ConvexPolygon square = ConvexPolygon::from_points({{1e6, 0, 1}, {1e6, 2, 1}, {1e6 + 2, 2, 1}, {1e6 + 2, 0, 1}});
  expect_flux(AreaLight{square}, 4 * pi);
  expect_flux(AreaLight{square, true}, 8 * pi);
  EXPECT_FALSE(light_flux(DirectionalLight{{0, 0, -1}}, 1, metre));
}

/// [P93] 3.2.2 keeps 4 pi k with the cosine, which emits pi/4 of that.
TEST(LightFlux, OfALinearLightGoesWithItsEmission) {
  const Point3 a{0, 0, 0}, b{0, 0, 3};
  expect_flux(LinearLight{a, b}, 3 * 4 * pi);
  expect_flux(LinearLight{a, b, {.exponent = 1}}, 3 * pi * pi);
  expect_flux(LinearLight{a, b, {.exponent = 2}}, 3 * 2 * pi * 4 / 3);
  expect_flux(LinearLight{a, b, {.flaps = 30}}, 3 * 2 * pi);
  expect_flux(LinearLight{a, b, {.exponent = 1, .flaps = 45}}, 3 * 2 * pi * (pi / 4 + 0.5));
  expect_flux(LinearLight{a, b, {.shade = Shade{{1, 0, 0}, {0, 1, 5}}}}, 3 * pi);
  expect_flux(LinearLight{a, b, {.shade = Shade{{0, 1, 5}, {1, 0, 0}}}}, 3 * 3 * pi);
  expect_flux(LinearLight{a, b, {.shade = Shade{{1, 0, 0}, {-1, 0, 0}}}}, 3 * 2 * pi);
}

TEST(LightFlux, IsNotToldBeyondTheRangeOfDoubles) {
  EXPECT_FALSE(light_flux(PointLight{{1, 2, 3}}, 1e308, metre));
}

TEST(LightFlux, KnowsTheUnitOfLength) {
  const LengthUnit centimetre = *length_unit_named("cm");
  const Light lamp = AreaLight{ConvexPolygon::from_points({{0, 0, 1}, {0, 2, 1}, {2, 2, 1}, {2, 0, 1}})};
  EXPECT_NEAR(flux_of(lamp, 10, centimetre), 4 * pi * 1e-3, 1e-15);
  EXPECT_NEAR(flux_of(LinearLight{{0, 0, 0}, {0, 0, 3}}, 10, centimetre), 1.2 * pi, 1e-12);
}

}  // namespace
}  // namespace gnomon
