#include "gnomon/pair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gnomon/errors.h"

namespace gnomon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

BlockerPlane blocker_plane(std::uint32_t edge, std::uint32_t vertex) {
  return {BlockerEdge{edge}, LightVertex{vertex}};
}

LightPlane light_plane(std::uint32_t edge, std::uint32_t vertex) {
  return {LightEdge{edge}, BlockerVertex{vertex}};
}

/// Shines downward: clockwise seen from above.
Light square_lamp() {
  return AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}})};
}

ConvexPolygon square() {
  return ConvexPolygon::from_points({{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}});
}

TEST(ExtremalPlanes, AlignedSquaresShareFourSeparatingPlanesNamedByTheBlockersEdges) {
  const ExtremalPlanes planes = extremal_planes(square_lamp(), square());
  EXPECT_THAT(planes.separating_blocker,
              ElementsAre(blocker_plane(0, 1), blocker_plane(1, 0), blocker_plane(2, 0), blocker_plane(3, 2)));
  EXPECT_THAT(planes.separating_light, IsEmpty());
  EXPECT_THAT(planes.supporting_blocker,
              ElementsAre(blocker_plane(0, 0), blocker_plane(1, 2), blocker_plane(2, 1), blocker_plane(3, 0)));
}

TEST(ExtremalPlanes, SquaresTurnedByAnEighthHaveEightSeparatingPlanes) {
  const ConvexPolygon turned = ConvexPolygon::from_points({{0, -1, 2}, {1, 0, 2}, {0, 1, 2}, {-1, 0, 2}});
  const ExtremalPlanes planes = extremal_planes(square_lamp(), turned);
  EXPECT_THAT(planes.separating_blocker,
              ElementsAre(blocker_plane(0, 1), blocker_plane(1, 0), blocker_plane(2, 3), blocker_plane(3, 2)));
  EXPECT_THAT(planes.separating_light,
              ElementsAre(light_plane(0, 1), light_plane(1, 0), light_plane(2, 3), light_plane(3, 2)));
  EXPECT_EQ(planes.supporting_blocker.size(), 4u);
}

TEST(ExtremalPlanes, WindingOfTheBlockerChangesNamesAlone) {
  const ConvexPolygon reversed = ConvexPolygon::from_points({{-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, {-1, -1, 2}});
  const ExtremalPlanes planes = extremal_planes(square_lamp(), reversed);
  EXPECT_THAT(planes.separating_blocker,
              ElementsAre(blocker_plane(0, 0), blocker_plane(1, 0), blocker_plane(2, 1), blocker_plane(3, 2)));
}

TEST(ExtremalPlanes, PointLightHoldsEveryPlaneBothWays) {
  const ExtremalPlanes planes = extremal_planes(PointLight{{0, 0, 4}}, square());
  EXPECT_EQ(planes.separating_blocker, planes.supporting_blocker);
  EXPECT_EQ(planes.separating_blocker.size(), 4u);
  EXPECT_THAT(planes.separating_light, IsEmpty());
}

TEST(ExtremalPlanes, LinearLightHasTwoTangentPlanesUnlessItsLineMeetsTheBlocker) {
  const ExtremalPlanes beside = extremal_planes(LinearLight{{-3, -5, 4}, {3, -6, 5}}, square());
  EXPECT_EQ(beside.separating_light.size(), 2u);
  const ExtremalPlanes above = extremal_planes(LinearLight{{0, 0, 4}, {0.25, 0, 5}}, square());
  EXPECT_THAT(above.separating_light, IsEmpty());
  EXPECT_EQ(above.separating_blocker.size(), 4u);
}

TEST(ExtremalPlanesDegenerate, CollinearVerticesAreNamedByTheLowestIndexAndListedOnce) {
  const ConvexPolygon blocker =
      ConvexPolygon::from_points({{0, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}, {-1, -1, 2}, {-0.5, -1, 2}});
  const ExtremalPlanes planes = extremal_planes(square_lamp(), blocker);
  EXPECT_THAT(planes.separating_blocker,
              ElementsAre(blocker_plane(1, 0), blocker_plane(2, 0), blocker_plane(3, 2), blocker_plane(0, 1)));
}

TEST(ExtremalPlanes, RefusesAPairThatIsNotInStandardPosition) {
  EXPECT_THROW(extremal_planes(PointLight{{0, 0, 2}}, square()), PreconditionError);
  EXPECT_THROW(extremal_planes(DirectionalLight{{0, 0, -1}}, square()), PreconditionError);
}

}  // namespace
}  // namespace gnomon
