#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/silhouette_vertices.h"
#include "geometry/numbers/orientation.h"
#include "tests/geometry/discontinuity/side_oracle.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;
using Triangles = std::vector<std::array<Point3, 3>>;

/// A square, so small that what it shows is what is next to v, seen from p; v is in the middle of the way to it.
AreaLight small_light_behind(const Point3& v, const Point3& p) {
  const Point3 c{2 * v.x - p.x, 2 * v.y - p.y, 2 * v.z - p.z};
  const double h = 0x1p-20;
  return {ConvexPolygon::from_points(
              {{c.x - h, c.y - h, c.z}, {c.x - h, c.y + h, c.z}, {c.x + h, c.y + h, c.z}, {c.x + h, c.y - h, c.z}}),
          true};
}

std::vector<ConvexBlocker> blockers_of(const Triangles& triangles) {
  std::vector<ConvexBlocker> blockers;
  for (const auto& t : triangles) blockers.emplace_back(ConvexPolygon::from_points({t[0], t[1], t[2]}));
  return blockers;
}

bool is_on_silhouette(const Point3& v, const Point3& p, const Triangles& triangles) {
  const CGAL::Protect_FPU_rounding<true> upward;
  const event::EventScene scene(small_light_behind(v, p), blockers_of(triangles), {});
  std::vector<event::ShapeId> shapes(triangles.size());
  std::iota(shapes.begin(), shapes.end(), 0U);
  event::SilhouetteVertices seen(scene);
  seen.view({Interval(p.x), Interval(p.y), Interval(p.z)}, shapes);
  const auto vertices = seen.vertices();
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](event::PointId id) { return scene.points[id].input == v && seen.is_on_silhouette(id); });
}

/// By the definition: next to v some light is hidden and some is seen.
bool shows_both(const Point3& v, const Point3& p, const Triangles& triangles) {
  return test_support::region_before_plane(small_light_behind(v, p), blockers_of(triangles), exact(Point3{0, 0, 1}),
                                           exact(p)) == Region::penumbra;
}

/// Triangles between v and points around it, one after the other.
Triangles fan(const Point3& v, const std::vector<Point3>& around, bool is_closed) {
  Triangles triangles;
  const std::size_t n = around.size();
  for (std::size_t k = 0; k + (is_closed ? 0 : 1) < n; ++k) triangles.push_back({v, around[k], around[(k + 1) % n]});
  return triangles;
}

const Point3 below{0.25, 0.5, 0};
const Point3 apex{0, 0, 2};
const std::vector<Point3> square{{2, 0, 1}, {0, 2, 1}, {-2, 0, 1}, {0, -2, 1}};
const std::vector<Point3> level_square{{2, 0, 2}, {0, 2, 2}, {-2, 0, 2}, {0, -2, 2}};

TEST(SilhouetteVertices, DoNotCountInTheMiddleOfAClosedFan) {
  EXPECT_FALSE(is_on_silhouette(apex, below, fan(apex, square, true)));
  EXPECT_FALSE(is_on_silhouette(apex, below, fan(apex, level_square, true)));
}

TEST(SilhouetteVertices, CountWhereAFanIsOpen) {
  EXPECT_TRUE(is_on_silhouette(apex, below, fan(apex, square, false)));
  EXPECT_TRUE(is_on_silhouette(apex, below, fan(apex, level_square, false)));
}

TEST(SilhouetteVertices, CountAtTheSilhouetteOfAClosedFan) {
  const Point3 tip{0, 0, 2};
  const std::vector<Point3> ring{{4, 1, 2}, {4, -1, 2}, {4, 0, 3}};
  EXPECT_TRUE(is_on_silhouette(tip, below, fan(tip, ring, true)));
}

TEST(SilhouetteVertices, CountAtTheEndOfAnEdgeBetweenTwoTriangles) {
  EXPECT_TRUE(is_on_silhouette(apex, below, {{apex, {2, 0, 2}, {0, 2, 2}}, {apex, {0, 2, 2}, {-2, -1, 2}}}));
  // Folded: both lie on one side of their edge.
  EXPECT_TRUE(is_on_silhouette(apex, below, {{apex, {2, 0, 2}, {0, 2, 2}}, {apex, {0, 2, 2}, {2, 1, 3}}}));
}

TEST(SilhouetteVertices, CountInAGapLessThanHalfATurn) {
  const std::vector<Point3> ring{{2, 0, 2}, {0, 2, 2}, {-2, 0, 2}, {0, -2, 2}, {1, -2, 2}};
  EXPECT_TRUE(is_on_silhouette(apex, below, fan(apex, ring, false)));
}

TEST(SilhouetteVertices, DoNotCountBehindAnotherBlocker) {
  Triangles triangles = fan(apex, level_square, false);
  triangles.push_back({Point3{-2, -2, 1}, {2, -2, 1}, {0, 3, 1}});
  EXPECT_FALSE(is_on_silhouette(apex, below, triangles));
}

TEST(SeenVerticesDegenerate, WhereAnotherBlockerTouchesDoNotCount) {
  Triangles triangles = fan(apex, level_square, false);
  triangles.push_back({Point3{-1, 0, 2}, {1, 0, 2}, {0, -3, 2}});
  EXPECT_FALSE(is_on_silhouette(apex, below, triangles));
}

TEST(SeenVerticesDegenerate, OfATriangleSeenEdgeOnDoNotCount) {
  EXPECT_FALSE(is_on_silhouette(apex, {0, 0.5, 0}, {{apex, {0, 2, 2}, {0, 0, 3}}}));
}

/// Triangles at v, some of which share edges, and others; of small whole numbers or shaken a little.
Triangles drawn_triangles(Dice& dice, const Point3& v, bool is_shaken) {
  const auto point = [&] {
    const auto shake = [&] { return is_shaken ? dice.draw(-999, 999) * 0x1p-12 : 0; };
    return Point3{dice.draw(-3, 3) + shake(), dice.draw(-3, 3) + shake(), dice.draw(1, 3) + shake()};
  };
  std::vector<Point3> around;
  for (int n = dice.draw(2, 6); n > 0; --n) around.push_back(point());
  Triangles triangles = fan(v, around, dice.once_in(2));
  for (int n = dice.draw(0, 2); n > 0; --n) triangles.push_back({v, dice.one_of(around), dice.one_of(around)});
  if (dice.once_in(2)) triangles.push_back({point(), point(), point()});
  std::erase_if(triangles, [](const auto& t) { return ConvexPolygon::defect(t).has_value(); });
  return triangles;
}

struct OutlineTally {
  unsigned both = 0, neither = 0, missed = 0;
};

OutlineTally compare_outlines(unsigned count, bool is_shaken) {
  OutlineTally tally;
  for (unsigned seed = 1; seed <= count; ++seed) {
    Dice dice(seed);
    const Point3 v{double(dice.draw(-1, 1)), double(dice.draw(-1, 1)), double(dice.draw(2, 3))};
    const Point3 p{dice.draw(-8, 8) / 4.0, dice.draw(-8, 8) / 4.0, 0};
    const Triangles triangles = drawn_triangles(dice, v, is_shaken);
    if (triangles.empty()) continue;
    const bool found = is_on_silhouette(v, p, triangles), expected = shows_both(v, p, triangles);
    EXPECT_TRUE(expected || !found) << "seed " << seed;
    ++(found ? tally.both : expected ? tally.missed : tally.neither);
  }
  std::cout << count << " cases from seed 1: on the outline " << tally.both << ", not " << tally.neither
            << ", not recognized " << tally.missed << "\n";
  return tally;
}

constexpr unsigned fan_count = GNOMON_LONG ? 20000 : 2000;

TEST(SeenVerticesAgreement, ThoseFoundShowHiddenAndOpenLightByDefinition) {
  const OutlineTally tally = compare_outlines(fan_count, false);
  EXPECT_GT(4 * tally.both, fan_count);
  EXPECT_GT(10 * tally.neither, fan_count);
}

TEST(SeenVerticesAgreement, InGeneralPositionAllAreFound) {
  const OutlineTally tally = compare_outlines(fan_count, true);
  EXPECT_GT(4 * tally.both, fan_count);
  EXPECT_GT(10 * tally.neither, fan_count);
  EXPECT_EQ(tally.missed, 0U);
}

}  // namespace
}  // namespace gnomon
