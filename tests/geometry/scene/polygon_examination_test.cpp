#include "geometry/scene/polygon_examination.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Optional;
using Points = std::vector<Point3>;

/// A kite of diameter 100 in the plane z = 0 with its last vertex at some height.
Points kite(double height) {
  return {{0, 0, 0}, {50, -10, 0}, {100, 0, 0}, {50, 10, height}};
}

Flatness flatness(const Points& points) {
  return examined_polygon(points, whole_ring(points.size())).plane.flatness;
}

TEST(PolygonExamination, ComparesTheDeviationWithItsLimitsExactly) {
  EXPECT_EQ(flatness(kite(0)), Flatness::flat);
  EXPECT_EQ(flatness(kite(0x1p-1000)), Flatness::rounded);
  EXPECT_EQ(flatness(kite(1)), Flatness::bent);
  EXPECT_EQ(flatness(kite(std::nextafter(1, 2))), Flatness::crooked);
  // 1e-7 is no double: the nearest one is a little smaller, the next one larger.
  EXPECT_EQ(flatness(kite(1e-7)), Flatness::rounded);
  EXPECT_EQ(flatness(kite(std::nextafter(1e-7, 1))), Flatness::bent);
}

TEST(PolygonExamination, TakesEdgesThatRunBothWaysOutOfTheBoundary) {
  const Points points = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {1, 1, 0}, {1, 2, 0}, {2, 1, 0}};
  const PolygonExamination wall = examined_polygon(points, {0, 1, 2, 3, 0, 4, 5, 6, 4});
  EXPECT_FALSE(wall.refusal);
  EXPECT_THAT(wall.rings, ElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(4, 5, 6)));
  // Two seams meet at a corner; the second hole hangs on the first.
  const Points more = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {1, 1, 0},
                       {1, 2, 0}, {2, 1, 0}, {3, 3, 0}, {3, 4, 0}, {4, 3, 0}};
  const PolygonExamination chain = examined_polygon(more, {0, 1, 2, 3, 0, 4, 5, 7, 8, 9, 7, 5, 6, 4});
  EXPECT_FALSE(chain.refusal);
  EXPECT_THAT(chain.rings, ElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(4, 5, 6), ElementsAre(7, 8, 9)));
}

TEST(PolygonExamination, FindsSeamsThatAreWalkedInOneStepOneWayAndInSeveralTheOther) {
  // From the corner up along the side to a window's sill, round the window, and back to the side at once.
  const Points wall = {{0, 0, 0}, {0, 4, 0}, {0, 4, 3}, {0, 0, 3}, {0, 0, 0}, {0, 0, 1},
                       {0, 1, 1}, {0, 1, 2}, {0, 2, 2}, {0, 2, 1}, {0, 0, 1}};
  const PolygonExamination polygon = examined_polygon(wall, whole_ring(wall.size()));
  EXPECT_FALSE(polygon.refusal);
  EXPECT_THAT(polygon.rings, ElementsAre(ElementsAre(0, 1, 2, 3, 5), ElementsAre(6, 7, 8, 9)));
  EXPECT_TRUE(polygon.is_convex);
}

TEST(PolygonExamination, CallsVerticesOfEqualCoordinatesByTheFirst) {
  const Points points = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 0}, {1, 1, 0}, {1, 2, 0}, {2, 1, 0}, {1, 1, 0}};
  EXPECT_THAT(examined_polygon(points, whole_ring(8)).rings, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(4, 5, 6)));
}

TEST(PolygonExamination, PutsTheOuterRingFirst) {
  const Points points = {{1, 1, 0}, {1, 2, 0}, {2, 1, 0}, {0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
  const PolygonExamination polygon = examined_polygon(points, {0, 1, 2, 0, 3, 4, 5, 3});
  EXPECT_FALSE(polygon.refusal);
  EXPECT_THAT(polygon.rings, ElementsAre(ElementsAre(3, 4, 5), ElementsAre(0, 1, 2)));
}

TEST(PolygonExamination, TellsBoundariesWithoutAnAreaFromOthersThatAreRefused) {
  const Points points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const Ring& ring : {Ring{0, 1}, Ring{0, 1, 2}, Ring{0, 3, 2, 3}, Ring{0, 1, 2, 1}}) {
    const PolygonExamination polygon = examined_polygon(points, ring);
    EXPECT_TRUE(polygon.refusal);
    EXPECT_FALSE(polygon.has_area);
  }
  const PolygonExamination bowtie = examined_polygon(points, {0, 3, 4, 1});
  EXPECT_TRUE(bowtie.has_area);
  EXPECT_THAT(bowtie.refusal->found, HasSubstr("edges 0 and 4 meet"));
}

TEST(PolygonExamination, RefusesRingsBesideEachOtherThatASeamJoins) {
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}, {6, 5, 0}, {5, 6, 0}};
  const PolygonExamination islands = examined_polygon(points, {0, 1, 2, 0, 3, 4, 5, 3});
  ASSERT_TRUE(islands.refusal);
  EXPECT_THAT(islands.refusal->found, HasSubstr("beside the outer one"));
  EXPECT_THAT(islands.refusal->vertex, Optional(3u));
}

TEST(PolygonExamination, TellsWhetherTheOuterRingIsConvex) {
  const Points points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 4, 0}, {0, 4, 0}, {1, 2, 0}};
  EXPECT_TRUE(examined_polygon(points, {0, 1, 2, 3, 4}).is_convex);
  EXPECT_FALSE(examined_polygon(points, {0, 1, 2, 3, 4, 5}).is_convex);
}

}  // namespace
}  // namespace gnomon
