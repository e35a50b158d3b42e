#include "gnomon/flatland_regions.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "apps/proof/laws/planar_cases.h"
#include "apps/proof/laws/planar_definition.h"
#include "geometry/planar/exact_polygon.h"
#include "gnomon/errors.h"
#include "gnomon/flatland_pair.h"

namespace gnomon::planar {
namespace {

using Points = std::vector<Point2>;

constexpr Box2 wide_box{{-10, -10}, {10, 10}};

ShadowRegionsInBox cut(const Points& light, const Box2& box = wide_box) {
  return regions_in_box(shadow_regions(Pair::from_points(light, Points{{-1, 0}, {1, 0}})), box);
}

laws::PlanarCase draw_case() {
  return *laws::planar_cases(*rc::gen::element(laws::Domain::random, laws::Domain::near_degenerate), laws::Stand::any);
}

/// A box about the pair; now and then its sides run through an end of it.
Box2 draw_box(const laws::PlanarCase& drawn) {
  const Point2 center = *rc::gen::element(drawn.blocker[0], drawn.blocker[1], drawn.light[0], drawn.point);
  const double reach = std::hypot(drawn.blocker[0].x - drawn.blocker[1].x, drawn.blocker[0].y - drawn.blocker[1].y);
  const auto extent = [&] {
    const double size = reach * *rc::gen::inRange(0, 6);
    return size;
  };
  Box2 box{center, center};
  box.min.x -= extent();
  box.min.y -= extent();
  box.max.x += extent();
  box.max.y += extent();
  RC_PRE(box.min.x < box.max.x && box.min.y < box.max.y);
  return box;
}

Rational exact_area(const ExactNumber& number) {
  return Rational(number.exact);
}

Rational area(const Box2& box) {
  return (Rational(box.max.x) - Rational(box.min.x)) * (Rational(box.max.y) - Rational(box.min.y));
}

bool is_on(const ExactPoint& p, const Point2& a, const Point2& b) {
  return laws::side_of(laws::exact(a), laws::exact(b), {p.x, p.y, 0}) == 0;
}

/// True if a point is on the line that a side's name says.
bool is_on(const ExactPoint& p, const SideName& name, const Pair& pair, const Box2& box) {
  switch (name.kind) {
    case SideKind::blocker:
    case SideKind::blocker_line:
      return is_on(p, pair.blocker()[0], pair.blocker()[1]);
    case SideKind::separating:
    case SideKind::supporting:
      return is_on(p, pair.blocker_end(name.blocker_end.value()), pair.light_end(name.light_end.value()));
    default:
      break;
  }
  const double sides[] = {box.min.x, box.max.x, box.min.y, box.max.y};
  return (name.box_side < 2 ? p.x : p.y) == sides[name.box_side.value()];
}

ExactPoint middle(const ExactPolygon& polygon) {
  ExactPoint sum{0, 0};
  for (const ExactPoint& p : polygon.vertices) sum = {sum.x + p.x, sum.y + p.y};
  const Rational count = static_cast<double>(polygon.vertices.size());
  return {sum.x / count, sum.y / count};
}

std::vector<ExactPolygon> polygons(const ShadowRegions& regions, const PlanarRegion& region, const Box2& box) {
  std::vector<ExactPolygon> result;
  for (const ConvexPiece& piece : region.pieces) {
    ExactPolygon polygon = clipped(regions.pair, piece, box);
    if (!polygon.vertices.empty()) result.push_back(std::move(polygon));
  }
  return result;
}

RC_GTEST_PROP(RegionsInBox, TileTheBoxExactly, ()) {
  const laws::PlanarCase drawn = draw_case();
  const Box2 box = draw_box(drawn);
  RC_LOG() << laws::description(drawn);
  const ShadowRegionsInBox regions = regions_in_box(shadow_regions(drawn.pair()), box);
  const Rational hidden = exact_area(regions.penumbra.area) + exact_area(regions.umbra.area);
  RC_ASSERT(hidden == exact_area(regions.occlusion.area));
  RC_ASSERT(exact_area(regions.lit.area) + hidden == area(box));
}

RC_GTEST_PROP(RegionsInBox, HaveEveryVertexOnItsNamedLines, ()) {
  const laws::PlanarCase drawn = draw_case();
  const Box2 box = draw_box(drawn);
  RC_LOG() << laws::description(drawn);
  const ShadowRegions regions = shadow_regions(drawn.pair());
  for (const PlanarRegion* region : {&regions.lit, &regions.penumbra, &regions.umbra, &regions.occlusion}) {
    for (const ExactPolygon& polygon : polygons(regions, *region, box)) {
      const std::size_t size = polygon.vertices.size();
      for (std::size_t k = 0; k < size; ++k) {
        RC_ASSERT(is_on(polygon.vertices[k], polygon.sides[k], regions.pair, box));
        RC_ASSERT(is_on(polygon.vertices[(k + 1) % size], polygon.sides[k], regions.pair, box));
      }
    }
  }
}

RC_GTEST_PROP(RegionsInBox, HoldOnlyPointsOfTheirRegion, ()) {
  const laws::PlanarCase drawn = draw_case();
  const Box2 box = draw_box(drawn);
  RC_LOG() << laws::description(drawn);
  const ShadowRegions regions = shadow_regions(drawn.pair());
  const auto visible = [&](const ExactPolygon& polygon) {
    const ExactPoint p = middle(polygon);
    return laws::visible_fraction(drawn.light, drawn.blocker, {p.x, p.y, 0});
  };
  for (const ExactPolygon& polygon : polygons(regions, regions.lit, box)) RC_ASSERT(visible(polygon) == 1);
  for (const ExactPolygon& polygon : polygons(regions, regions.umbra, box)) RC_ASSERT(visible(polygon) == 0);
  for (const ExactPolygon& polygon : polygons(regions, regions.penumbra, box)) {
    RC_ASSERT(visible(polygon) > 0 && visible(polygon) < 1);
  }
}

bool holds_inside(const ExactPolygon& polygon, const Point2& p) {
  const std::size_t size = polygon.vertices.size();
  for (std::size_t k = 0; k < size; ++k) {
    const auto& [a, b] = std::pair(polygon.vertices[k], polygon.vertices[(k + 1) % size]);
    if (laws::side_of({a.x, a.y, 0}, {b.x, b.y, 0}, laws::exact(p)) <= 0) return false;
  }
  return true;
}

RC_GTEST_PROP(RegionsInBox, AgreeWithTheRegionOfAPoint, ()) {
  const laws::PlanarCase drawn = draw_case();
  const Box2 box = draw_box(drawn);
  RC_LOG() << laws::description(drawn);
  const ShadowRegions regions = shadow_regions(drawn.pair());
  const std::pair<Region, const PlanarRegion*> all[] = {
      {Region::lit, &regions.lit}, {Region::penumbra, &regions.penumbra}, {Region::umbra, &regions.umbra}};
  for (const auto& [region, pieces] : all) {
    for (const ExactPolygon& polygon : polygons(regions, *pieces, box)) {
      if (holds_inside(polygon, drawn.point)) RC_ASSERT(region_of(regions.pair, drawn.point) == region);
    }
  }
}

/// The sides of all polygons that tile the box, each from one vertex to the next.
RC_GTEST_PROP(RegionsInBox, ShareWholeSidesInOppositeDirections, ()) {
  const laws::PlanarCase drawn = draw_case();
  const Box2 box = draw_box(drawn);
  RC_LOG() << laws::description(drawn);
  const ShadowRegions regions = shadow_regions(drawn.pair());
  using Place = std::pair<Rational, Rational>;
  std::map<std::pair<Place, Place>, SideName> sides;
  for (const PlanarRegion* region : {&regions.lit, &regions.penumbra, &regions.umbra}) {
    for (const ExactPolygon& polygon : polygons(regions, *region, box)) {
      const std::size_t size = polygon.vertices.size();
      for (std::size_t k = 0; k < size; ++k) {
        const ExactPoint &a = polygon.vertices[k], &b = polygon.vertices[(k + 1) % size];
        RC_ASSERT(sides.emplace(std::pair(Place(a.x, a.y), Place(b.x, b.y)), polygon.sides[k]).second);
      }
    }
  }
  for (const auto& [key, name] : sides) {
    const auto& ends = key;  // a lambda cannot capture `key` in clang 14
    const bool on_the_box = [&] {
      const auto both = [&](auto claim) { return claim(ends.first) && claim(ends.second); };
      return both([&](const Place& p) { return p.first == box.min.x; }) ||
             both([&](const Place& p) { return p.first == box.max.x; }) ||
             both([&](const Place& p) { return p.second == box.min.y; }) ||
             both([&](const Place& p) { return p.second == box.max.y; });
    }();
    RC_ASSERT(on_the_box || sides.contains(std::pair(ends.second, ends.first)));
  }
}

TEST(RegionsInBox, HaveTheAreasOfTheFigure) {
  const ShadowRegionsInBox regions = cut({{-3, 2}, {3, 2}});
  EXPECT_EQ(regions.umbra.area.exact, "1");
  EXPECT_EQ(regions.umbra.area.nearest, 1.0);
  EXPECT_FALSE(regions.umbra.truncated);
  EXPECT_TRUE(regions.penumbra.truncated);
  EXPECT_EQ(regions.occlusion.area.exact, "319/2");
  EXPECT_EQ(regions.penumbra.area.nearest, 158.5);
}

TEST(RegionsInBox, RoundConstructedVerticesOnce) {
  const ShadowRegionsInBox regions = cut({{-2.5, 2}, {2.5, 2}});
  ASSERT_EQ(regions.umbra.polygons.size(), 1u);
  const Points& triangle = regions.umbra.polygons.front().vertices;
  ASSERT_EQ(triangle.size(), 3u);
  EXPECT_TRUE(std::ranges::count(triangle, Point2{0, -4.0 / 3}) == 1);
  EXPECT_EQ(regions.umbra.area.exact, "4/3");
  EXPECT_EQ(regions.umbra.area.nearest, 4.0 / 3);
}

TEST(RegionsInBox, CutTheExtremalLinesToo) {
  const ShadowRegionsInBox regions = cut({{-1, 2}, {1, 2}});
  ASSERT_EQ(regions.lines.size(), 4u);
  EXPECT_EQ(regions.lines[2].name, (ExtremalLine{Contact::supporting, BlockerVertex{0}, LightVertex{0}}));
  EXPECT_EQ(regions.lines[2].start, (Point2{-1, 10}));
  EXPECT_EQ(regions.lines[2].end, (Point2{-1, -10}));
}

TEST(RegionsInBox, LeaveOutWhatMissesTheBox) {
  const ShadowRegionsInBox regions = cut({{-1, 2}, {1, 2}}, {{-3, 1}, {-2, 2}});
  EXPECT_EQ(regions.lit.area.exact, "1");
  EXPECT_TRUE(regions.umbra.polygons.empty());
  EXPECT_TRUE(regions.penumbra.polygons.empty());
  EXPECT_EQ(regions.umbra.area.exact, "0");
  EXPECT_TRUE(regions.lines.empty());
}

TEST(RegionsInBoxDegenerate, ASideOfTheBoxAlongTheBlocker) {
  const ShadowRegionsInBox regions = cut({{-3, 2}, {3, 2}}, {{-10, -1}, {10, 0}});
  EXPECT_EQ(regions.umbra.area.exact, "1");
  EXPECT_FALSE(regions.umbra.truncated);
}

TEST(RegionsInBoxDegenerate, ABoxInsideTheUmbra) {
  const ShadowRegionsInBox regions = cut({{-1, 2}, {1, 2}}, {{-0.5, -2}, {0.5, -1}});
  EXPECT_EQ(regions.umbra.area.exact, "1");
  EXPECT_TRUE(regions.umbra.truncated);
  EXPECT_EQ(regions.lit.area.exact, "0");
}

TEST(RegionsInBox, NeedABoxWithInterior) {
  EXPECT_THROW(cut({{0, 2}}, {{0, 0}, {0, 1}}), PreconditionError);
  EXPECT_THROW(cut({{0, 2}}, {{0, 1}, {1, 0}}), PreconditionError);
  EXPECT_THROW(cut({{0, 2}}, {{0, 0}, {1, HUGE_VAL}}), PreconditionError);
}

}  // namespace
}  // namespace gnomon::planar
