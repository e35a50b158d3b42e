#include "geometry/visibility/blocker_content.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::ElementsAre;

ConvexBlocker cube_at(double x) {
  std::vector<Point3> corners;
  for (const double dx : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 1.0}) corners.push_back({x + dx, y, z});
    }
  }
  return ConvexSolid::hull_of(corners);
}

ConvexBlocker board_at(double x) {
  return ConvexPolygon::from_points({{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}});
}

TEST(FewBlockers, LeavesOutSolidsWhoseBoxesAPointOrALineDoesNotMeet) {
  const std::vector<ConvexBlocker> blockers{cube_at(0), cube_at(5), board_at(9)};
  const BlockerSet set(blockers);
  std::vector<std::uint32_t> found;
  set.content().collect_near({6, 0.5, 0.5}, found);
  EXPECT_THAT(found, ElementsAre(1, 2)) << "one cube has the point; boards cost no more than their boxes";
  set.content().collect_near({-1e-15, 1, 1}, found);
  EXPECT_THAT(found, ElementsAre(0, 2)) << "within rounding of a corner";
  set.content().collect_near({3, 0.5, 0.5}, found);
  EXPECT_THAT(found, ElementsAre(2));
  set.content().collect_along({{-1, 0.5, 0.5}, {3, 0.5, 0.5}}, found);
  EXPECT_THAT(found, ElementsAre(0, 2)) << "it ends before the other cube";
  set.content().collect_along({{-1, 0.5, 0.5}, {1, 0, 0}, false}, found);
  EXPECT_THAT(found, ElementsAre(0, 1, 2));
}

}  // namespace
}  // namespace gnomon
