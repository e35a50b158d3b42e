#include "geometry/spatial/contact_walk.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "apps/proof/laws/spatial_cases.h"

namespace gnomon {
namespace {

/// Orientations that one walk around the pair takes.
std::size_t orientations(const StandardPair& pair, int outward) {
  std::size_t calls = 0;
  const auto counting = [&](const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
    ++calls;
    return exact_orientation(p, q, r, s);
  };
  walk_area_light(pair.light, pair.blocker, outward, counting, [](std::uint32_t, const TouchedCorners&) {});
  return calls;
}

std::size_t most_orientations(const StandardPair& pair) {
  return std::size_t{2} * pair.light.size() + pair.blocker.size();
}

ConvexPolygon regular_polygon(std::uint32_t corners, double radius, double height) {
  std::vector<Point3> points;
  for (std::uint32_t k = 0; k < corners; ++k) {
    const double angle = 0.1 + 2 * std::numbers::pi * k / corners;
    points.push_back({radius * std::cos(angle), -radius * std::sin(angle), height});
  }
  return ConvexPolygon::from_points(std::move(points));
}

TEST(ContactWalk, ManyCornersTakeAsManyOrientationsAsBothPolygonsHaveCorners) {
  for (const std::uint32_t n : {3u, 16u, 1000u}) {
    for (const std::uint32_t m : {3u, 17u, 1000u}) {
      const Light light = AreaLight{regular_polygon(n, 1, 4)};
      const ConvexPolygon blocker = regular_polygon(m, 1.5, 2);
      const StandardPair pair = standard_pair(light, blocker);
      for (const int outward : {-1, +1}) {
        EXPECT_LE(orientations(pair, outward), most_orientations(pair)) << n << "/" << m;
        EXPECT_GE(orientations(pair, outward), n + m) << n << "/" << m;
      }
    }
  }
}

void check_every_pair(laws::Domain domain) {
  const laws::SpatialCase drawn = *laws::spatial_cases(domain, laws::Lights::with_extent);
  const StandardPair pair = standard_pair(drawn.light, drawn.blocker);
  if (pair.light.size() < 3) return;  // a linear light is not walked around
  RC_ASSERT(orientations(pair, -1) <= most_orientations(pair));
  RC_ASSERT(orientations(pair, +1) <= most_orientations(pair));
}

RC_GTEST_PROP(ContactWalkProperty, TakesAtMostTwoOrientationsPerLightCornerAndOnePerBlockerCorner, ()) {
  check_every_pair(laws::Domain::random);
}

RC_GTEST_PROP(ContactWalkDegenerate, TiesCostNoFurtherOrientation, ()) {
  check_every_pair(laws::Domain::near_degenerate);
}

}  // namespace
}  // namespace gnomon
