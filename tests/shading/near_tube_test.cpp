#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/visibility/visible_part.h"
#include "gnomon/irradiance.h"
#include "shading/small_lights.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;
using Long =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<400>, boost::multiprecision::et_off>;

struct LongVector {
  Long x, y, z;
};

LongVector difference(const Point3& a, const Point3& b) {
  return {Long(a.x) - b.x, Long(a.y) - b.y, Long(a.z) - b.z};
}

Long dot(const LongVector& a, const LongVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

LongVector moved(const LongVector& a, const Long& s, const LongVector& d) {
  return {a.x + s * d.x, a.y + s * d.y, a.z + s * d.z};
}

/// The closed form with so many digits that nothing is lost in differences: cut at the horizon, then the integral of
/// N . (s d + h e) / r³.
Long irradiance(const LinearLight& light, const Point3& p, const Point3& normal) {
  LongVector from = difference(light.start, p), to = difference(light.end, p);
  const LongVector n = difference(normal, {0, 0, 0}), whole = difference(light.end, light.start);
  const Long from_height = dot(n, from), to_height = dot(n, to);
  if (from_height <= 0 && to_height <= 0) return 0;
  if (from_height < 0) from = moved(from, from_height / (from_height - to_height), whole);
  if (to_height < 0) to = moved(difference(light.start, p), from_height / (from_height - to_height), whole);
  const Long length = sqrt(dot(whole, whole)), size = sqrt(dot(n, n));
  const Long s1 = dot(from, whole) / length, s2 = dot(to, whole) / length;
  const LongVector foot = moved(from, -dot(from, whole) / (length * length), whole);
  const Long h = sqrt(dot(foot, foot)), r1 = sqrt(dot(from, from)), r2 = sqrt(dot(to, to));
  return (dot(n, whole) / length * (1 / r1 - 1 / r2) + dot(n, foot) / (h * h) * (s2 / r2 - s1 / r1)) / size;
}

std::string told(const Point3& p) {
  std::ostringstream text;
  text << std::hexfloat << " (" << p.x << ", " << p.y << ", " << p.z << ")";
  return text.str();
}

void expect_finite_bound_that_holds(const LinearLight& light, const Point3& p, const Point3& normal,
                                    const char* where) {
  const Long exact = irradiance(light, p, normal);
  LightIrradiance received(light, 1, PreparedObstacles({}));
  const std::array<Rational, 2> whole{0, 1};
  for (const Irradiance& e : {received.at(p, normal), linear_irradiance(light, {&whole, 1}, p, normal)}) {
    ASSERT_TRUE(std::isfinite(e.error_bound))
        << where << told(light.start) << told(light.end) << told(p) << told(normal);
    ASSERT_LE(abs(exact - e.value), Long(e.error_bound)) << where << ' ' << e.value;
    // What can be said of a sum of two parts: each to a few units in its last place.
    const Long nearest = 1 / sqrt(std::min(dot(difference(light.start, p), difference(light.start, p)),
                                           dot(difference(light.end, p), difference(light.end, p))));
    ASSERT_LE(Long(e.error_bound), 1e-6 + 1e-13 * (exact + nearest)) << where;
  }
}

/// A few units in the last place away; next to zero, of numbers that are about 1.
Point3 draw_near(Dice& dice, const Point3& p, int steps) {
  std::array<double, 3> c{p.x, p.y, p.z};
  for (double& x : c) x += dice.draw(-steps, steps) * std::fmax(std::fabs(x), 0x1p-6) * 0x1p-52;
  return {c[0], c[1], c[2]};
}

TEST(NearTube, BoundsAreFiniteAnUlpFromATubeBesideItAndBeyondItsEnds) {
  Dice dice(20);
  int tried = 0;
  for (int round = 0; round < 1500; ++round) {
    const auto draw = [&] {
      return Point3{dice.draw(-30, 30) / 8.0, dice.draw(-30, 30) / 8.0, dice.draw(-30, 30) / 8.0};
    };
    const LinearLight light{draw(), draw()};
    const Point3 normal = draw();
    if (light.start == light.end || normal == Point3{}) continue;
    const double share = dice.draw(-16, 24) / 8.0;
    const Point3 on_line{light.start.x + share * (light.end.x - light.start.x),
                         light.start.y + share * (light.end.y - light.start.y),
                         light.start.z + share * (light.end.z - light.start.z)};
    const Point3 p = draw_near(dice, on_line, dice.draw(1, 3));
    const LongVector across = difference(p, light.start), along = difference(light.end, light.start);
    const Long c = dot(across, along);
    if (dot(across, across) * dot(along, along) == c * c) continue;  // on the line: infinite, or seen end-on
    ++tried;
    expect_finite_bound_that_holds(light, p, normal, "near its line");
  }
  EXPECT_GT(tried, 700);
}

TEST(NearTube, BoundsAreFiniteForCoordinatesOfEverySize) {
  for (const double size : {1e-150, 1e-20, 1.0, 1e20, 1e150}) {
    for (const double distance : {0x1p-52, 0x1p-200, 0x1p-500}) {
      for (const double place : {-3.0, -1.0, 0.5, 1.0, 2.0}) {
        const LinearLight light{{0, 0, 0}, {size, 0, 0}};
        for (const Point3& normal : {Point3{0, -1, 0}, Point3{1, -1, 0}, Point3{-1, 0, 0}, Point3{1, 1e-9, 3}}) {
          expect_finite_bound_that_holds(light, {place * size, distance * size, 0}, normal, "beside an axis");
        }
      }
    }
  }
}

/// A point next to the origin that looks up, and a tube above its horizon that is `length` long or little more.
LinearLight tiny_tube(Dice& dice, double length) {
  const auto draw = [&](int low, int high) { return dice.draw(low * 1000, high * 1000) / 1000.0 + 1e-3 / 7; };
  const Point3 start{draw(-3, 3), draw(-3, 3), draw(1, 4)};
  return {start, {start.x + length * draw(-1, 1), start.y + length * draw(-1, 1), start.z + length * draw(0, 1)}};
}

TEST(TinyTube, KeepsItsDigitsHoweverShortItIs) {
  Dice dice(8);
  const std::array<Rational, 2> whole{0, 1};
  for (int round = 0; round < 2000; ++round) {
    const LinearLight light = tiny_tube(dice, std::pow(10.0, -dice.draw(0, 9)));
    const Point3 p{dice.draw(-9, 9) / 9.0, dice.draw(-9, 9) / 9.0, 0};
    if (light.start == light.end) continue;
    const Long exact = irradiance(light, p, {0.3, 0.2, 2});
    const LongVector from = difference(light.start, p), along = difference(light.end, light.start);
    const Long across = sqrt(dot(along, along)) / dot(from, from);  // roughly, without the cosine
    LightIrradiance received(light, 1, PreparedObstacles({}));
    for (const Irradiance& e :
         {received.at(p, {0.3, 0.2, 2}), linear_irradiance(light, {&whole, 1}, p, {0.3, 0.2, 2})}) {
      ASSERT_LE(abs(exact - e.value), Long(e.error_bound)) << round;
      ASSERT_LE(abs(exact - e.value), 8e-14 * across) << round;
      ASSERT_LE(Long(e.error_bound), 1e-11 * across) << round;
    }
  }
}

TEST(NearTubeDegenerate, OnTheTubeItselfNothingElseIsKnown) {
  LightIrradiance received(LinearLight{{0, 0, 0}, {1, 0, 0}}, 1, PreparedObstacles({}));
  EXPECT_EQ(received.at({0.5, 0, 0}, {1, 0, 0}).value, HUGE_VAL);
  EXPECT_TRUE(std::isfinite(received.at({2, 0, 0}, {-1, 0, 0}).error_bound)) << "end-on";
}

}  // namespace
}  // namespace gnomon
