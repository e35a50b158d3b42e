#include "geometry/scene/receiver_facets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::ElementsAre;

std::vector<std::string> names(const std::vector<SceneReceiver>& pieces) {
  std::vector<std::string> result;
  for (const SceneReceiver& facet : pieces) result.push_back(facet.name);
  return result;
}

const ConvexPolygon triangle = ConvexPolygon::from_points({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}});

TEST(ReceiverFacets, APolygonIsItself) {
  const auto pieces = receiver_facets("floor", triangle, ReceiverSides::front);
  EXPECT_THAT(names(pieces), ElementsAre("floor"));
  EXPECT_EQ(pieces[0].side, "floor");
}

TEST(ReceiverFacets, TheBackIsTurnedRoundAndBothAreCalledByTheReceiversName) {
  const auto pieces = receiver_facets("pane", triangle, ReceiverSides::both);
  EXPECT_THAT(names(pieces), ElementsAre("pane/front", "pane/back"));
  EXPECT_THAT(pieces[1].shape.points(), ElementsAre(Point3{0, 0, 0}, Point3{0, 1, 0}, Point3{2, 0, 0}));
  EXPECT_TRUE(pieces[1].is_called("pane"));
  EXPECT_TRUE(pieces[1].is_called("pane/back"));
  EXPECT_FALSE(pieces[1].is_called("pane/front"));
}

TEST(ReceiverFacets, APolytopeShowsItsFacetsFromOutside) {
  const Polytope tent{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto pieces = receiver_facets("tent", tent, ReceiverSides::front);
  EXPECT_THAT(names(pieces), ElementsAre("tent#0", "tent#1", "tent#2", "tent#3"));
  for (const SceneReceiver& facet : pieces) {
    const auto p = facet.shape.points();
    const Point3 u{p[1].x - p[0].x, p[1].y - p[0].y, p[1].z - p[0].z};
    const Point3 v{p[2].x - p[0].x, p[2].y - p[0].y, p[2].z - p[0].z};
    const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    EXPECT_GT(n.x * (p[0].x - 0.2) + n.y * (p[0].y - 0.2) + n.z * (p[0].z - 0.2), 0) << facet.name;
  }
}

TEST(ReceiverFacets, OfMeshesAndConcavePolygonsAreNamedAsPartsOfBlockersAre) {
  const ConcavePolygon board{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}};
  EXPECT_THAT(names(receiver_facets("board", board, ReceiverSides::front)), ElementsAre("board#0", "board#1"));
  const Mesh mesh{"m.obj", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}, {0, 4, 1}}, false};
  EXPECT_THAT(names(receiver_facets("m", mesh, ReceiverSides::both)),
              ElementsAre("m/front#0", "m/front#1", "m/back#0", "m/back#1"));
}

TEST(ReceiverFacets, GroupsAreThoseOfTheFileAndTheirSides) {
  std::vector<SceneReceiver> all = receiver_facets("a", triangle, ReceiverSides::both);
  for (SceneReceiver& facet : receiver_facets("b", triangle, ReceiverSides::front)) all.push_back(facet);
  EXPECT_EQ(receiver_elements(all).size(), 2U);
  EXPECT_EQ(receiver_sides(all).size(), 3U);
}

}  // namespace
}  // namespace gnomon
