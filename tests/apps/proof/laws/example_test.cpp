#include "apps/proof/laws/example.h"

#include <gtest/gtest.h>

#include "apps/proof/laws/claim_cases.h"
#include "apps/proof/laws/flatland_cases.h"
#include "apps/proof/laws/planar_cases.h"
#include "apps/proof/laws/spatial_cases.h"

namespace gnomon::laws {
namespace {

TEST(Example, OfThePlaneHoldsLightSegmentsAndPoints) {
  const Example shown = example(FlatlandCase{{{0, 1}, {2, 1}}, {{{{0, 0}, {1, 0}}}, {{{1, 0}, {2, 0}}}}, {3, 4}});
  const auto& plane = std::get<PlaneScene>(shown.scene);
  ASSERT_EQ(plane.lights.size(), 1u);
  EXPECT_EQ(plane.lights[0].vertices, (std::vector<Point2>{{0, 1}, {2, 1}}));
  ASSERT_EQ(plane.blockers.size(), 2u);
  EXPECT_EQ(plane.blockers[1].name, "blocker_1");
  EXPECT_EQ(plane.blockers[1].vertices, (std::vector<Point2>{{1, 0}, {2, 0}}));
  EXPECT_EQ(shown.points, (std::vector<Point3>{{3, 4, 0}}));
  EXPECT_EQ(example(PlanarCase{{{0, 1}}, {Point2{0, 0}, Point2{1, 0}}, {3, 4}, {5, 6}}).points.size(), 2u);
}

TEST(Example, OfSpaceHoldsLightBlockersAndPoints) {
  const ConvexPolygon triangle = ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Example flat = example(SpatialCase{PointLight{{0, 0, 2}}, triangle, {1, 2, 3}, {4, 5, 6}});
  const auto& space = std::get<SpaceScene>(flat.scene);
  EXPECT_TRUE(std::holds_alternative<ConvexPolygon>(space.blockers.at(0).shape));
  EXPECT_TRUE(std::holds_alternative<PointLight>(space.lights.at(0).shape));
  EXPECT_EQ(flat.points, (std::vector<Point3>{{1, 2, 3}, {4, 5, 6}}));
  const Example solid = example(pyramid_case({}));
  EXPECT_EQ(std::get<Polytope>(std::get<SpaceScene>(solid.scene).blockers.at(0).shape).vertices.size(), 5u);
  EXPECT_EQ(solid.points.size(), 2u);
}

TEST(Census, CountsRegionsOfAPairAndOfItsPoint) {
  Census census;
  count_regions(PlanarCase{{{-1, 2}, {1, 2}}, {Point2{-1, 0}, Point2{1, 0}}, {0, -1}, {}}, census);
  EXPECT_EQ(census.points, (std::array<std::uint32_t, 4>{0, 0, 1, 0}));
  EXPECT_EQ(census.umbrae, (std::array<std::uint32_t, 3>{0, 1, 0}));
  EXPECT_EQ(census.penumbrae, (std::array<std::uint32_t, 4>{0, 0, 1, 0}));
  EXPECT_EQ(census.pockets, (std::array<std::uint32_t, 3>{0, 0, 0}));
}

TEST(Census, CountsPocketsOfASolid) {
  Census census;
  count_regions(pyramid_case({}), census);
  EXPECT_EQ(census.pockets, (std::array<std::uint32_t, 3>{0, 0, 1}));
}

}  // namespace
}  // namespace gnomon::laws
