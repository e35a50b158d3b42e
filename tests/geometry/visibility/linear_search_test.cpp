#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/visibility/common_part.h"
#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/linear_search/occluder_index.h"
#include "geometry/visibility/linear_search/triangle_in_box.h"
#include "gnomon/errors.h"

// That no search misses a blocker and that all lead to the same answers is laws LL1 to LL3. Here is what each is for.

namespace gnomon {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using viewpoint::LightCylinder;

ConvexBlocker square(double x, double y, double z) {
  return ConvexPolygon::from_points({{x, y, z}, {x + 1, y, z}, {x + 1, y + 1, z}, {x, y + 1, z}});
}

std::vector<std::uint32_t> found(const LinearSearch& search, const std::vector<ConvexBlocker>& blockers,
                                 const Point3& p) {
  FastLinearVisibility visibility({{-1, 0, 4}, {1, 0, 4}}, BlockerSet(blockers), search);
  const auto occluders = visibility.occluders(p);
  return occluders ? std::vector<std::uint32_t>(occluders->begin(), occluders->end()) : std::vector<std::uint32_t>{};
}

TEST(LinearSearch, FindsWhatLiesBetweenAndNotWhatLiesFarAside) {
  const std::vector<ConvexBlocker> blockers{square(-0.5, -0.5, 2), square(-0.5, 5, 2), square(9, -0.5, 2),
                                            square(-0.5, -0.5, -2)};
  EXPECT_THAT(found({OccluderSearch::plane}, blockers, {0, 0, 0}), ElementsAre(0, 2, 3)) << "all in the plane";
  EXPECT_THAT(found({OccluderSearch::grid, 10}, blockers, {0, 0, 0}), ElementsAre(0));
  EXPECT_THAT(found({OccluderSearch::light_buffer, 24}, blockers, {0, 0, 0}), ElementsAre(0))
      << "what lies right of the light, or beyond the point, is in no list that is read";
  EXPECT_THAT(found({OccluderSearch::light_hierarchy}, blockers, {0, 0, 0}), ElementsAre(0));
  EXPECT_THAT(found({OccluderSearch::light_hierarchy}, {}, {0, 0, 0}), IsEmpty());
}

TEST(LinearSearch, TakesNoMorePartsThanItSays) {
  EXPECT_THROW(FastLinearVisibility({{-1, 0, 4}, {1, 0, 4}}, BlockerSet({}), {OccluderSearch::grid, 101}),
               PreconditionError);
  EXPECT_THROW(FastLinearVisibility({{-1, 0, 4}, {1, 0, 4}}, BlockerSet({}), {OccluderSearch::plane, 1}),
               PreconditionError);
}

TEST(LinearSearchDegenerate, FindsWhatTheLightsLinePiercesFromEverywhere) {
  const std::vector<ConvexBlocker> gate{ConvexPolygon::from_points({{3, -1, 3}, {3, 1, 3}, {3, 1, 5}, {3, -1, 5}})};
  for (const OccluderSearch search : occluder_searches) {
    EXPECT_THAT(found({search}, gate, {4, 0.5, 3.5}), Contains(0)) << name(search);
    EXPECT_THAT(found({search}, gate, {7, 0, 4 + 1e-9}), Contains(0)) << name(search) << ", next to the line";
  }
}

TEST(LightCylinder, TellsTurnDistanceAndPlaceAlongWithinItsErrors) {
  const LightCylinder cylinder({{1, 2, 3}, {1, 2, 7}});
  const viewpoint::CylinderPlace place = cylinder.place_of({4, 6, 5});
  EXPECT_NEAR(place.distance, 5, place.error);
  EXPECT_NEAR(place.along, 2, place.error);
  EXPECT_NEAR(cylinder.length(), 4, cylinder.length_error());
  const viewpoint::CylinderPlace opposite = cylinder.place_of({-2, -2, 5});
  EXPECT_NEAR(std::fabs(place.turn - opposite.turn), 2, place.turn_error + opposite.turn_error);
  EXPECT_EQ(cylinder.place_of({1, 2, 9}).turn_error, HUGE_VAL) << "on the line";
}

TEST(LightCylinder, PutsABoxAroundAPolygonThatReachesNearerThanItsCorners) {
  const LightCylinder cylinder({{0, 0, 0}, {0, 0, 1}});
  const std::vector<Point3> board{{3, -4, 0}, {3, 4, 0}, {3, 4, 2}, {3, -4, 2}};
  const std::vector<viewpoint::PointPair> edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const viewpoint::CylinderBox box = cylinder.box_of(board, edges);
  EXPECT_NEAR(box.low_distance, 3, 1e-12);
  EXPECT_NEAR(box.high_distance, 5, 1e-12);
  EXPECT_LE(box.low_distance, 3);
  EXPECT_GE(box.high_distance, 5);
  EXPECT_FALSE(box.is_all_round());
  const std::vector<Point3> around{{3, -4, 0}, {3, 4, 0}, {-3, 0, 2}};
  EXPECT_TRUE(cylinder.box_of(around, std::vector<viewpoint::PointPair>{{0, 1}, {1, 2}, {2, 0}}).is_all_round());
}

TEST(TriangleInBox, IsHeldApartByAnAxisAcrossTwoEdges) {
  const Box3 box{{0, 0, 0}, {1, 1, 1}};
  const std::array<Point3, 3> at_corner{Point3{3, -1, 0.5}, Point3{-1, 3, 0.5}, Point3{3, 3, 0.5}};
  EXPECT_TRUE(viewpoint::may_meet(at_corner, box)) << "it touches the edge x = y = 1";
  EXPECT_FALSE(viewpoint::may_meet({Point3{3.1, -1, 0.2}, Point3{-1, 3.1, 0.4}, Point3{3, 3, 0.5}}, box));
  EXPECT_FALSE(viewpoint::may_meet({Point3{2, 0, 0}, Point3{2, 1, 0}, Point3{2, 0, 1}}, box));
}

TEST(CommonPart, IsDecidedExactlyAndHasItsBoundary) {
  const BlockerSet blockers(
      std::vector<ConvexBlocker>{square(0, 0, 0), ConvexSolid::hull_of({{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}})});
  const auto common = [&](std::uint32_t blocker, const std::vector<Point3>& hull) {
    return viewpoint::have_common_point(blockers.content(), blocker, hull);
  };
  EXPECT_TRUE(common(0, {{1, 1, 0}}));
  EXPECT_FALSE(common(0, {{1 + 0x1p-52, 1, 0}}));
  EXPECT_FALSE(common(0, {{0.5, 0.5, 0x1p-1070}}));
  EXPECT_TRUE(common(0, {{0.5, 0.5, -1}, {0.5, 0.5, 1}}));
  EXPECT_TRUE(common(0, {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}})) << "in its plane";
  EXPECT_FALSE(common(0, {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}})) << "in its plane, beside it";
  EXPECT_TRUE(common(1, {{4, 0.25, 0.25}, {7, 0.25, 0.25}}));
  EXPECT_FALSE(common(1, {{6, 1, 0}, {6, 0, 1}}));
}

}  // namespace
}  // namespace gnomon
