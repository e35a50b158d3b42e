#include "gnomon/flatland_regions.h"

#include <gtest/gtest.h>

#include <vector>

namespace gnomon::planar {
namespace {

using Points = std::vector<Point2>;

ShadowRegions regions_of(const Points& light, const Points& blocker = {{-1, 0}, {1, 0}}) {
  return shadow_regions(Pair::from_points(light, blocker));
}

/// How many regions of each kind there are.
struct Counts {
  std::uint32_t lit;
  std::uint32_t penumbra;
  std::uint32_t umbra;
  std::uint32_t occlusion;

  friend bool operator==(const Counts&, const Counts&) = default;
};

void PrintTo(const Counts& counts, std::ostream* out) {
  *out << counts.lit << " lit, " << counts.penumbra << " penumbra, " << counts.umbra << " umbra, " << counts.occlusion
       << " occlusion";
}

Counts counts_of(const ShadowRegions& regions) {
  return {regions.lit.components, regions.penumbra.components, regions.umbra.components, regions.occlusion.components};
}

SideName light_line(SideKind kind, std::uint32_t blocker_end, std::uint32_t light_end) {
  return {kind, BlockerVertex{blocker_end}, LightVertex{light_end}};
}

std::vector<SideName> side_names(const ConvexPiece& piece) {
  std::vector<SideName> names;
  for (const PieceSide& side : piece.sides) names.push_back(side.name);
  return names;
}

constexpr SideName the_blocker{SideKind::blocker};
const PieceCorner end_0{BlockerVertex{0}};
const PieceCorner end_1{BlockerVertex{1}};

TEST(ShadowRegions, OfALightLongerThanTheBlockerEndTheUmbraAtTheSupportingLines) {
  const ShadowRegions regions = regions_of({{-3, 2}, {3, 2}});
  EXPECT_EQ(counts_of(regions), (Counts{1, 1, 1, 1}));
  EXPECT_TRUE(regions.umbra.bounded());
  EXPECT_FALSE(regions.penumbra.bounded());
  ASSERT_EQ(regions.umbra.pieces.size(), 1u);
  const ConvexPiece& umbra = regions.umbra.pieces.front();
  EXPECT_EQ(side_names(umbra),
            (std::vector{the_blocker, light_line(SideKind::supporting, 0, 0), light_line(SideKind::supporting, 1, 1)}));
  EXPECT_EQ(umbra.corners, (std::vector{end_0, PieceCorner{}, end_1}));
  EXPECT_EQ(regions.penumbra.pieces.size(), 3u);
}

TEST(ShadowRegions, OfALightShorterThanTheBlockerLeaveTwoPenumbrae) {
  const ShadowRegions regions = regions_of({{-0.5, 2}, {0.5, 2}});
  EXPECT_EQ(counts_of(regions), (Counts{1, 2, 1, 1}));
  EXPECT_FALSE(regions.umbra.bounded());
  const ConvexPiece& umbra = regions.umbra.pieces.front();
  EXPECT_EQ(side_names(umbra),
            (std::vector{light_line(SideKind::supporting, 1, 1), the_blocker, light_line(SideKind::supporting, 0, 0)}));
  EXPECT_EQ(umbra.corners, (std::vector{end_1, end_0}));
}

TEST(ShadowRegionsDegenerate, ParallelSupportingLinesLeaveTheUmbraUnbounded) {
  const ShadowRegions regions = regions_of({{-1, 2}, {1, 2}});
  EXPECT_EQ(counts_of(regions), (Counts{1, 2, 1, 1}));
  EXPECT_FALSE(regions.umbra.bounded());
}

TEST(ShadowRegionsDegenerate, ParallelismIsDecidedByTheLastBit) {
  const double longer = 0x1.0000000000001p0;
  EXPECT_TRUE(regions_of({{-1, 2}, {longer, 2}}).umbra.bounded());
  EXPECT_FALSE(regions_of({{-1, 2}, {0x1.fffffffffffffp-1, 2}}).umbra.bounded());
}

TEST(ShadowRegions, OfAPointLightHaveNoPenumbra) {
  const ShadowRegions regions = regions_of({{0, 2}});
  EXPECT_EQ(counts_of(regions), (Counts{1, 0, 1, 1}));
  EXPECT_TRUE(regions.penumbra.empty());
  EXPECT_TRUE(regions.penumbra.bounded());
  EXPECT_FALSE(regions.umbra.bounded());
  EXPECT_EQ(regions.lines.size(), 4u);
}

TEST(ShadowRegions, StayWholeWhereTheLightsLineCrossesTheBlocker) {
  EXPECT_EQ(counts_of(regions_of({{0, 1}, {0, 2}})), (Counts{1, 2, 1, 1}));
}

TEST(ShadowRegionsDegenerate, AnEndOfTheBlockerOnTheLightsLineHasNoPenumbra) {
  const ShadowRegions regions = regions_of({{1, 1}, {1, 2}});
  EXPECT_EQ(counts_of(regions), (Counts{1, 1, 1, 1}));
  ASSERT_EQ(regions.penumbra.pieces.size(), 1u);
  EXPECT_EQ(regions.penumbra.pieces.front().corners, (std::vector{end_0}));
}

TEST(ShadowRegions, HaveNoUmbraWhereTheBlockersLineCrossesTheLight) {
  const ShadowRegions beside = regions_of({{2, -1}, {2, 1}});
  EXPECT_EQ(counts_of(beside), (Counts{1, 2, 0, 2}));
  EXPECT_EQ(beside.lines, (std::vector{ExtremalLine{Contact::separating, BlockerVertex{1}, LightVertex{0}},
                                       ExtremalLine{Contact::separating, BlockerVertex{1}, LightVertex{1}}}));
  EXPECT_EQ(counts_of(regions_of({{1, -1}, {1, 1}})), (Counts{1, 2, 0, 2}));
  const ShadowRegions inside = regions_of({{0, -1}, {0, 1}});
  EXPECT_EQ(counts_of(inside), (Counts{0, 2, 0, 2}));
  EXPECT_TRUE(inside.lit.empty());
  EXPECT_TRUE(inside.lines.empty());
}

TEST(ShadowRegions, OfALightThatTouchesTheBlockerInsideHaveOneUmbraAndTwoPenumbrae) {
  const ShadowRegions regions = regions_of({{0, 0}, {3, 1}});
  EXPECT_EQ(counts_of(regions), (Counts{1, 2, 1, 1}));
  EXPECT_EQ(regions.lines, (std::vector{ExtremalLine{Contact::supporting, BlockerVertex{0}, LightVertex{1}},
                                        ExtremalLine{Contact::supporting, BlockerVertex{1}, LightVertex{1}}}));
}

TEST(ShadowRegions, OfALightThatSharesAnEndWithTheBlockerHaveOneUmbraAndOnePenumbra) {
  const ShadowRegions regions = regions_of({{3, 1}, {1, 0}});
  EXPECT_EQ(counts_of(regions), (Counts{1, 1, 1, 1}));
  EXPECT_EQ(regions.penumbra.pieces.front().corners, (std::vector{end_0}));
}

TEST(ShadowRegions, OfALightThatTouchesTheBlockersLineBesideHaveNoUmbraAndOnePenumbra) {
  const ShadowRegions regions = regions_of({{-2, 0}, {3, 1}});
  EXPECT_EQ(counts_of(regions), (Counts{1, 1, 0, 1}));
  EXPECT_EQ(side_names(regions.penumbra.pieces.front()),
            (std::vector<SideName>{
                {SideKind::blocker_line, BlockerVertex{1}}, the_blocker, light_line(SideKind::separating, 0, 1)}));
}

TEST(ShadowRegions, OfALightOnTheBlockersLineAreLit) {
  EXPECT_EQ(counts_of(regions_of({{2, 0}, {5, 0}})), (Counts{1, 0, 0, 0}));
  EXPECT_EQ(counts_of(regions_of({{1, 0}, {5, 0}})), (Counts{1, 0, 0, 0}));
  EXPECT_EQ(counts_of(regions_of({{1, 0}})), (Counts{1, 0, 0, 0}));
}

TEST(ShadowRegions, AreCutByACommonLineIfNoPointOfItIsLit) {
  EXPECT_EQ(counts_of(regions_of({{0, 0}, {5, 0}})), (Counts{2, 0, 0, 0}));
  EXPECT_EQ(counts_of(regions_of({{-3, 0}, {5, 0}})), (Counts{2, 0, 0, 0}));
  EXPECT_EQ(counts_of(regions_of({{0, 0}})), (Counts{2, 0, 0, 0}));
}

TEST(ShadowRegions, TurnWithTheBlocker) {
  const ShadowRegions regions = regions_of({{3, 2}, {-3, 2}}, {{1, 0}, {-1, 0}});
  EXPECT_EQ(counts_of(regions), (Counts{1, 1, 1, 1}));
  EXPECT_EQ(regions.umbra.pieces.front().corners, (std::vector{end_1, PieceCorner{}, end_0}));
}

}  // namespace
}  // namespace gnomon::planar
