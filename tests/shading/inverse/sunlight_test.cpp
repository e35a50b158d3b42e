#include "gnomon/sunlight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gnomon/errors.h"
#include "tests/shading/inverse/design_cases.h"

namespace gnomon {
namespace {

using namespace test_support;
using testing::ElementsAre;
using Kind = SunEventName::Kind;

constexpr double degree = std::numbers::pi / 180;

/// Towards the sun, z up and y north: the textbook's formula.
Point3 sun_at(const SunDay& day, double hour) {
  const double h = (hour - 12) * 15 * degree, phi = day.latitude * degree, delta = day.declination * degree;
  return {-std::cos(delta) * std::sin(h),
          std::cos(phi) * std::sin(delta) - std::sin(phi) * std::cos(delta) * std::cos(h),
          std::sin(phi) * std::sin(delta) + std::cos(phi) * std::cos(delta) * std::cos(h)};
}

/// Asked of visibility at one moment.
bool is_sunlit(const Obstacles& obstacles, const SunDay& day, const SunPoint& point, double hour) {
  const Point3 s = sun_at(day, hour);
  if (s.z <= 0) return false;
  if (point.normal && point.normal->x * s.x + point.normal->y * s.y + point.normal->z * s.z <= 0) return false;
  return exact_visibility(DirectionalLight{{-s.x, -s.y, -s.z}}, obstacles, point.point).region == Region::lit;
}

bool is_in(const SunlitDay& day, double hour) {
  return std::ranges::any_of(day.intervals,
                             [&](const SunInterval& i) { return i.start.hour < hour && hour < i.end.hour; });
}

double distance_from_events(const SunlitDay& day, double hour) {
  double least = 24;
  for (const SunInterval& i : day.intervals) {
    least = std::min({least, std::fabs(i.start.hour - hour), std::fabs(i.end.hour - hour)});
  }
  return least;
}

std::string case_text(const Obstacles& obstacles, const SunDay& day, const SunPoint& point) {
  DesignCase c;
  c.obstacles.obstacles = obstacles;
  return "latitude " + std::to_string(day.latitude) + ", declination " + std::to_string(day.declination) + '\n' +
         told(c, point.point);
}

TEST(SunlightAgreement, IsWhatVisibilitySaysAtEveryMoment) {
  int moments = 0, sunny = 0, shadows = 0;
  for (std::uint32_t seed = 1; seed <= (GNOMON_LONG ? 5000 : 400); ++seed) {
    Dice dice(seed);
    const Numbers numbers = dice.once_in(2) ? Numbers::large : Numbers::small;
    const Obstacles obstacles = drawn_obstacles(dice, numbers, dice.draw(1, 4)).obstacles;
    SunDay day;
    day.latitude = dice.once_in(4) ? 0 : dice.draw(-89, 89);
    // At the equator on an equinox the sun stays in one plane, where walls are seen edge-on for hours.
    day.declination = day.latitude != 0 && dice.once_in(3) ? 0 : dice.draw(1, 23);
    SunPoint point{drawn_point(dice, numbers, -1, 2), {}};
    if (dice.once_in(3)) point.normal = drawn_point(dice, numbers, 1, 3);
    const DaySunlight sun(obstacles, day);
    const SunlitDay there = sun.at(point);
    for (int k = 0; k < 60; ++k) {
      const double hour = 24 * (k + 0.4321) / 60;
      if (distance_from_events(there, hour) < 1e-9) continue;
      ++moments;
      const bool seen = is_sunlit(obstacles, day, point, hour);
      sunny += seen ? 1 : 0;
      ASSERT_EQ(is_in(there, hour), seen) << "seed " << seed << ", hour " << hour << '\n'
                                          << case_text(obstacles, day, point);
    }
    for (const SunInterval& interval : there.intervals) {
      for (const SunEvent& event : {interval.start, interval.end}) {
        if (event.name.kind != Kind::shadow) continue;
        ++shadows;
        EXPECT_NE(is_sunlit(obstacles, day, point, event.hour - 1e-8),
                  is_sunlit(obstacles, day, point, event.hour + 1e-8))
            << "seed " << seed << ", hour " << event.hour;
        EXPECT_LT(event.error_bound, 1e-8);
      }
    }
  }
  EXPECT_GT(moments, 10000);
  EXPECT_GT(sunny, 1000);
  EXPECT_GT(shadows, 40);
}

TEST(Sunlight, LastsHalfADayAtTheEquatorAndOnEquinoxes) {
  for (const auto& [latitude, declination] : {std::pair(0.0, 23.0), {52.5, 0.0}, {-33.0, 0.0}}) {
    const SunlitDay day = DaySunlight({}, {.latitude = latitude, .declination = declination}).at({});
    ASSERT_EQ(day.intervals.size(), 1U);
    EXPECT_NEAR(day.intervals[0].start.hour, 6, 1e-13);
    EXPECT_NEAR(day.intervals[0].end.hour, 18, 1e-13);
    EXPECT_NEAR(day.hours, 12, day.error_bound);
    EXPECT_LT(day.error_bound, 1e-12);
    EXPECT_EQ(day.intervals[0].start.name.kind, Kind::horizon);
  }
}

TEST(Sunlight, LastsAllDayOrNotAtAllBeyondThePolarCircles) {
  const SunlitDay summer = DaySunlight({}, {.latitude = 80, .declination = 20}).at({});
  ASSERT_EQ(summer.intervals.size(), 1U);
  EXPECT_EQ(summer.intervals[0].start.name.kind, Kind::midnight);
  EXPECT_NEAR(summer.hours, 24, 1e-12);
  EXPECT_TRUE(DaySunlight({}, {.latitude = 80, .declination = -20}).at({}).intervals.empty());
  EXPECT_EQ(DaySunlight({}, {.latitude = -90, .declination = -10}).at({}).hours, summer.hours);
}

/// A style along the pole, at the latitude with the sine 3/5: hour lines have tan θ = 3/5 tan H for every declination.
TEST(Sundial, TellsTheHourWhateverTheDeclination) {
  const auto style = ConvexPolygon::from_points({{0, 0, 0}, {0, 4, 0}, {0, 4, 3}});
  const double latitude = std::asin(0.6) / degree;
  for (const double declination : {-20.0, -7.0, 0.0, 11.0, 23.0}) {
    const DaySunlight sun({{style}, {}}, {.latitude = latitude, .declination = declination});
    for (const double tangent : {-1.0, -0.25, 0.25, 1.0}) {
      // The shadow's edge lies on the dial at (0.6 tan H, 1) from the style's foot, on the side away from the sun.
      const SunlitDay day = sun.at({{0.6 * tangent, 1, 0}, Point3{0, 0, 1}});
      const double hour = 12 + std::atan(tangent) / (15 * degree);
      double least = 24;
      for (const SunInterval& i : day.intervals) {
        for (const SunEvent& event : {i.start, i.end}) {
          if (event.name.kind == Kind::shadow && event.name.edge == 2)
            least = std::min(least, std::fabs(event.hour - hour));
        }
      }
      EXPECT_LT(least, 1e-12) << declination << ' ' << tangent;
    }
  }
}

TEST(Sunlight, ShinesThroughNoSeamBetweenFacets) {
  // A cube of eight squares a side casts one shadow.
  Obstacles wall;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      const double y = i - 4 + 0.1, z = j;
      wall.blockers.emplace_back(
          ConvexPolygon::from_points({{-3, y, z}, {-3, y + 1, z}, {-3, y + 1, z + 1}, {-3, y, z + 1}}));
    }
  }
  const SunlitDay day = DaySunlight(wall, {.latitude = 20, .declination = 10}).at({{0.3, 0.2, 0}, {}});
  ASSERT_EQ(day.intervals.size(), 1U);
  EXPECT_FALSE(day.tied);
  EXPECT_EQ(day.intervals[0].start.name.kind, Kind::horizon);
  EXPECT_EQ(day.intervals[0].end.name.kind, Kind::shadow);
}

TEST(SunlightDegenerate, NothingShinesInsideASolidAndAllOnItsTop) {
  const auto cube =
      ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
  const DaySunlight sun({{cube}, {}}, {.latitude = 40, .declination = 15});
  EXPECT_TRUE(sun.at({{0.5, 0.25, 0.5}, {}}).intervals.empty());
  EXPECT_EQ(sun.at({{0.5, 0.25, 1}, Point3{0, 0, 1}}).hours,
            DaySunlight({}, {.latitude = 40, .declination = 15}).at({}).hours);
  EXPECT_TRUE(sun.at({{0.5, 0.25, 0}, {}}).intervals.empty());
}

TEST(SunlightDegenerate, ASunThatPassesAlongAnEdgeIsHiddenByIt) {
  const auto solid = ConvexSolid::hull_of({{-2, 0, 1}, {-2, 0, 3}, {-2, 2, 2}, {-4, 1, 2}});
  const SunlitDay day = DaySunlight({{solid}, {}}, {.latitude = 0, .declination = 0}).at({});
  ASSERT_EQ(day.intervals.size(), 2U);
  EXPECT_NEAR(day.intervals[0].end.hour, 18 - std::atan(1.5) / (15 * degree), 1e-12);
  EXPECT_NEAR(day.intervals[1].start.hour, 18 - std::atan(0.5) / (15 * degree), 1e-12);
}

TEST(SunlightDegenerate, AWallInOnePlaneWithThePointHidesNothing) {
  const auto wall = ConvexPolygon::from_points({{0, 1, 0}, {0, 5, 0}, {0, 5, 9}, {0, 1, 9}});
  const DaySunlight sun({{wall}, {}}, {.latitude = -30, .declination = 0});
  EXPECT_EQ(sun.at({}).intervals.size(), 1U);
  EXPECT_EQ(sun.at({{0.25, 0, 0}, {}}).intervals.size(), 2U);
}

TEST(Sunlight, RefusesAnglesOutOfRange) {
  EXPECT_THROW(DaySunlight({}, {.latitude = 91}), PreconditionError);
  EXPECT_THROW(DaySunlight({}, {.latitude = 9, .declination = 30}), PreconditionError);
  EXPECT_THROW(DaySunlight({}, {.latitude = 9, .declination = 3, .up = {0, 0, 1}, .north = {0, 1, 1}}),
               PreconditionError);
  EXPECT_THROW(DaySunlight({}, {.latitude = std::nan("")}), PreconditionError);
}

TEST(Sunlight, TurnsWithNorth) {
  const auto wall = ConvexPolygon::from_points({{-1, -1, 0}, {-1, 1, 0}, {-1, 1, 2}, {-1, -1, 2}});
  const auto turned = ConvexPolygon::from_points({{1, -1, 0}, {-1, -1, 0}, {-1, -1, 2}, {1, -1, 2}});
  const SunlitDay day = DaySunlight({{wall}, {}}, {.latitude = 30, .declination = 10}).at({{0.1, 0.2, 0}, {}});
  SunDay other{.latitude = 30, .declination = 10, .up = {0, 0, 2}, .north = {-3, 0, 0}};
  const SunlitDay there = DaySunlight({{turned}, {}}, other).at({{-0.2, 0.1, 0}, {}});
  ASSERT_EQ(day.intervals.size(), there.intervals.size());
  for (std::size_t k = 0; k < day.intervals.size(); ++k) {
    EXPECT_NEAR(day.intervals[k].start.hour, there.intervals[k].start.hour, 1e-12);
    EXPECT_NEAR(day.intervals[k].end.hour, there.intervals[k].end.hour, 1e-12);
  }
}

}  // namespace
}  // namespace gnomon
