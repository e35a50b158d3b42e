#include "geometry/visibility/fast_visibility.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/numbers/kernel.h"
#include "gnomon/visibility.h"
#include "tests/geometry/visibility/splitting_oracle.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;

/// Builds something that must be legal out of drawn points, or draws again.
template <class Make>
auto drawn_until(const Make& make) {
  for (;;) {
    if (auto made = make()) return *made;
  }
}

Point3 draw_point(Dice& dice, int reach, int low, int high) {
  const double x = dice.draw(-reach, reach);
  const double y = dice.draw(-reach, reach);
  return {x, y, static_cast<double>(dice.draw(low, high))};
}

std::optional<ConvexPolygon> polygon_of(std::vector<Point3> points) {
  if (ConvexPolygon::defect(points)) return std::nullopt;
  return ConvexPolygon::from_points(std::move(points));
}

std::optional<ConvexPolygon> draw_polygon(Dice& dice, int reach, int low, int high) {
  const Point3 a = draw_point(dice, reach, low, high);
  const Point3 b = draw_point(dice, reach, low, high);
  const Point3 c = draw_point(dice, reach, low, high);
  if (dice.once_in(2)) return polygon_of({a, b, c});
  return polygon_of({a, b, c, {a.x + c.x - b.x, a.y + c.y - b.y, a.z + c.z - b.z}});
}

std::optional<ConvexBlocker> draw_solid(Dice& dice, int reach, int low, int high) {
  std::vector<Point3> points;
  const int count = dice.draw(4, 7);
  for (int i = 0; i < count; ++i) points.push_back(draw_point(dice, reach, low, high));
  try {
    return ConvexSolid::hull_of(std::move(points));
  } catch (const std::logic_error&) {
    return std::nullopt;
  }
}

/// A scene on small integers: ties, shared edges, repeated blockers and touching ones are common.
struct Drawn {
  AreaLight light;
  std::vector<ConvexBlocker> blockers;
};

AreaLight draw_light(Dice& dice) {
  const double h = 8;
  if (dice.once_in(2)) {
    return {ConvexPolygon::from_points({{-2, -2, h}, {-2, 2, h}, {2, 2, h}, {2, -2, h}}), dice.once_in(2)};
  }
  return {drawn_until([&] { return draw_polygon(dice, 4, 7, 9); }), dice.once_in(2)};
}

std::vector<ConvexBlocker> draw_blockers(Dice& dice, int count, int high) {
  std::vector<ConvexBlocker> blockers;
  std::vector<Point3> strip = {draw_point(dice, 3, 1, high), draw_point(dice, 3, 1, high)};
  while (static_cast<int>(blockers.size()) < count) {
    const int kind = dice.draw(0, 9);
    if (kind == 0 && !blockers.empty()) {
      blockers.push_back(ConvexBlocker(dice.one_of(blockers)));
    } else if (kind <= 2) {
      blockers.push_back(drawn_until([&] { return draw_solid(dice, 3, 1, high); }));
    } else if (kind <= 6) {
      strip.push_back(draw_point(dice, 3, 1, high));
      const auto end = strip.end();
      if (auto triangle = polygon_of({*(end - 3), *(end - 2), *(end - 1)})) blockers.push_back(*triangle);
    } else {
      blockers.push_back(drawn_until([&] { return draw_polygon(dice, 3, 1, high); }));
    }
  }
  return blockers;
}

Point3 some_vertex(Dice& dice, const ConvexBlocker& blocker) {
  const auto points = std::visit([](const auto& shape) { return shape.points(); }, blocker);
  return dice.one_of(points);
}

/// Behind a blocker's vertex, seen from a vertex of the light: on several extremal planes at once.
Point3 draw_aligned_point(Dice& dice, const Drawn& scene) {
  const Point3 b = some_vertex(dice, dice.one_of(scene.blockers));
  const Point3 l = dice.one_of(scene.light.polygon.points());
  const double t = dice.draw(1, 4) / 2.0;
  return {b.x + t * (b.x - l.x), b.y + t * (b.y - l.y), b.z + t * (b.z - l.z)};
}

/// The eight triangles between six drawn points, two of them poles, run one way round: a surface without boundary that
/// may pass through itself and be inside out.
std::optional<std::vector<ConvexBlocker>> draw_closed_surface(Dice& dice, int high) {
  std::vector<Point3> points;
  for (int i = 0; i < 6; ++i) points.push_back(draw_point(dice, 3, 1, high));
  std::vector<ConvexBlocker> facets;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3 &a = points[i], &b = points[(i + 1) % 4];
    const auto upper = polygon_of({a, b, points[4]});
    const auto lower = polygon_of({b, a, points[5]});
    if (!upper || !lower) return std::nullopt;
    facets.insert(facets.end(), {*upper, *lower});
  }
  return facets;
}

/// Closed surfaces that may meet each other and the light, and now and then a triangle beside them.
std::vector<ConvexBlocker> draw_closed_surfaces(Dice& dice, int high) {
  std::vector<ConvexBlocker> blockers;
  for (int i = dice.draw(1, 3); i > 0; --i) {
    const auto surface = drawn_until([&] { return draw_closed_surface(dice, high); });
    blockers.insert(blockers.end(), surface.begin(), surface.end());
  }
  if (dice.once_in(3)) blockers.push_back(drawn_until([&] { return draw_polygon(dice, 3, 1, high); }));
  return blockers;
}

/// The fast level decides and agrees, or it may leave the question open: true if it decided.
bool agrees(const Drawn& scene, const Point3& p, FastVisibility& fast) {
  const std::optional<VisibleAreaLight> seen = fast.visible_from(p);
  if (!seen) return false;
  const test_support::SplitView exact = test_support::split_view(scene.light, scene.blockers, p);
  RC_ASSERT(name(seen->region) == name(exact.region));
  RC_ASSERT(abs(Rational(Rational(seen->fraction) - exact.fraction)) <= Rational(seen->error_bound));
  RC_ASSERT(seen->error_bound <= 1e-8);  // slivers of lights among them
  return true;
}

/// How a point is drawn.
enum class Where { anywhere, aligned };

template <class DrawBlockers>
void check_agreement_behind(const DrawBlockers& draw_some, int high, Where where) {
  int decided = 0;
  int asked = 0;
  const bool holds = rc::check("agreement", [&] {
    Dice dice;
    const Drawn scene{draw_light(dice), draw_some(dice, high)};
    FastVisibility fast(scene.light, BlockerSet(scene.blockers));
    for (int i = 0; i < 50; ++i) {
      const Point3 p = where == Where::aligned ? draw_aligned_point(dice, scene) : draw_point(dice, 4, -2, 1);
      decided += agrees(scene, p, fast) ? 1 : 0;
      ++asked;
    }
  });
  EXPECT_TRUE(holds);
  // Where blocker and light cut each other's planes the question is left to the exact level.
  EXPECT_GE(decided, asked * (high < 7 ? 6 : 1) / 10) << "of " << asked;
}

void check_agreement(int count, int high, Where where) {
  check_agreement_behind([&](Dice& dice, int reach) { return draw_blockers(dice, count, reach); }, high, where);
}

/// A plate with the light straight above it: its lower side is turned away, its upper one lies under the point that is
/// asked for, so the lower one alone hides the light.
TEST(FastVisibilityDegenerate, AClosedSurfaceHidesTheLightAlsoWithoutTheFacetUnderThePoint) {
  const AreaLight light{ConvexPolygon::from_points({{-1, -1, 8}, {-1, 1, 8}, {1, 1, 8}, {1, -1, 8}})};
  const std::array<Point3, 4> lower{{{-2, -2, 1}, {2, -2, 1}, {2, 2, 1}, {-2, 2, 1}}};
  std::array<Point3, 4> upper = lower;
  for (Point3& p : upper) p.z = 2;
  std::vector<ConvexBlocker> plate = {ConvexPolygon::from_points({upper.begin(), upper.end()}),
                                      ConvexPolygon::from_points({lower.rbegin(), lower.rend()})};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    plate.push_back(ConvexPolygon::from_points({lower[i], lower[next], upper[next], upper[i]}));
  }
  FastVisibility fast(light, BlockerSet(plate));
  const ReceiverPoint below{{0, 0, 0}, FacingNormal{{0, 0, 1}}, {0}};
  const std::optional<VisibleAreaLight> seen = fast.visible_by(below);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->region, Region::umbra);
  EXPECT_EQ(exact_received(light, {plate, {}}, below).region, Region::umbra);
}

/// All its facets have the light behind them, and it winds around the light.
TEST(FastVisibilityDegenerate, AClosedSurfaceAroundTheLightHidesItFromOutside) {
  const AreaLight light{ConvexPolygon::from_points({{-1, -1, 8}, {-1, 1, 8}, {1, 1, 8}, {1, -1, 8}}), true};
  const std::array<Point3, 4> equator{{{6, 0, 8}, {0, 6, 8}, {-6, 0, 8}, {0, -6, 8}}};
  std::vector<ConvexBlocker> shell;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3 &a = equator[i], &b = equator[(i + 1) % 4];
    shell.push_back(ConvexPolygon::from_points({a, b, {0, 0, 14}}));
    shell.push_back(ConvexPolygon::from_points({b, a, {0, 0, 2}}));
  }
  FastVisibility fast(light, BlockerSet(shell));
  for (const Point3& p : {Point3{0, 0, 0}, Point3{1, 2, -3}, Point3{5, 5, 1}}) {
    const std::optional<VisibleAreaLight> seen = fast.visible_from(p);
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->region, Region::umbra);
  }
}

TEST(FastVisibilityAgreement, ClosedSurfacesMatchSplitting) {
  check_agreement_behind(draw_closed_surfaces, 6, Where::anywhere);
}
TEST(FastVisibilityAgreement, ClosedSurfacesMatchSplittingWhereVerticesAlign) {
  check_agreement_behind(draw_closed_surfaces, 6, Where::aligned);
}
TEST(FastVisibilityAgreement, ClosedSurfacesThatHoldLightMatchSplittingOrAreLeftOpen) {
  check_agreement_behind(draw_closed_surfaces, 9, Where::anywhere);
}
TEST(FastVisibilityAgreement, OneBlockerMatchesSplitting) {
  check_agreement(1, 6, Where::anywhere);
}
TEST(FastVisibilityAgreement, FourBlockersMatchSplitting) {
  check_agreement(4, 6, Where::anywhere);
}
TEST(FastVisibilityAgreement, SixteenBlockersMatchSplitting) {
  check_agreement(16, 6, Where::anywhere);
}
TEST(FastVisibilityAgreement, OneBlockerMatchesSplittingWhereVerticesAlign) {
  check_agreement(1, 6, Where::aligned);
}
TEST(FastVisibilityAgreement, FourBlockersMatchSplittingWhereVerticesAlign) {
  check_agreement(4, 6, Where::aligned);
}
TEST(FastVisibilityAgreement, SixteenBlockersMatchSplittingWhereVerticesAlign) {
  check_agreement(16, 6, Where::aligned);
}
TEST(FastVisibilityAgreement, BlockersThatReachTheLightsPlaneMatchSplittingOrAreLeftOpen) {
  check_agreement(4, 9, Where::anywhere);
}

/// Small triangles, 64 of them, before one lamp: most of them overlap others as seen.
TEST(FastVisibilityAgreement, SixtyFourTrianglesMatchSplitting) {
  EXPECT_TRUE(rc::check("agreement", [&] {
    Dice dice;
    Drawn scene{{ConvexPolygon::from_points({{-8, -8, 32}, {-8, 8, 32}, {8, 8, 32}, {8, -8, 32}})}, {}};
    while (scene.blockers.size() < 64) {
      const Point3 m = draw_point(dice, 12, 6, 24);
      const auto near = [&] {
        const Point3 d = draw_point(dice, 2, -2, 2);
        return Point3{m.x + d.x, m.y + d.y, m.z + d.z};
      };
      scene.blockers.push_back(drawn_until([&] { return polygon_of({near(), near(), near()}); }));
    }
    FastVisibility fast(scene.light, BlockerSet(scene.blockers));
    for (int i = 0; i < 3; ++i) RC_ASSERT(agrees(scene, draw_point(dice, 8, -2, 0), fast));
  }));
}

ConvexPolygon rectangle(double x0, double x1, double y0, double y1, double z) {
  return ConvexPolygon::from_points({{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}});
}

/// A triangle of random size below `radius`, turned any way, about a point above [-1,1]^2 between heights 1 and 3.
ConvexBlocker random_triangle(Dice& dice, double radius) {
  const auto real = [&] { return dice.draw(-1'000'000, 1'000'000) / 1e6; };
  return drawn_until([&] {
    const Point3 m{real(), real(), 2 + real()};
    const auto near = [&] { return Point3{m.x + radius * real(), m.y + radius * real(), m.z + radius * real()}; };
    return polygon_of({near(), near(), near()});
  });
}

TEST(FastVisibilityFallback, LeavesFewerThanOneRandomPointInTenThousandToTheExactLevel) {
  int asked = 0;
  int left = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    Dice dice(seed);
    const int count = 1 << (seed % 4 * 2);
    std::vector<ConvexBlocker> blockers;
    for (int i = 0; i < count; ++i) blockers.push_back(random_triangle(dice, 0.9 / std::sqrt(count) + 0.02));
    FastVisibility fast({rectangle(-0.5, 0.5, -0.5, 0.5, 4)}, BlockerSet(blockers));
    for (int i = 0; i < 1000; ++i, ++asked) {
      const double x = dice.draw(-1'000'000, 1'000'000) / 1e6;
      left += fast.visible_from({x, dice.draw(-1'000'000, 1'000'000) / 1e6, 0}) ? 0 : 1;
    }
  }
  std::cout << left << " of " << asked << " points left to the exact level\n";
  EXPECT_LT(left * 10'000, asked);
}

/// A closed surface of triangles around the light: the octahedron, each face cut into n * n triangles, every vertex
/// drawn out to its own distance. Neighbours share their vertices exactly.
std::vector<ConvexBlocker> draw_shell(Dice& dice, int n) {
  std::map<std::array<int, 3>, Point3> vertices;
  const auto vertex = [&](int x, int y, int z) {
    const auto [found, is_new] = vertices.try_emplace({x, y, z});
    const double r = (4 + dice.draw(0, 1000) / 1777.0) / std::sqrt(x * x + y * y + z * z);
    if (is_new) found->second = {r * x, r * y, 8 + r * z};
    return found->second;
  };
  std::vector<ConvexBlocker> shell;
  const auto add = [&](Point3 a, Point3 b, Point3 c) { shell.push_back(ConvexPolygon::from_points({a, b, c})); };
  for (int face = 0; face < 8; ++face) {
    const auto at = [&](int i, int j) {
      return vertex(face & 1 ? i : -i, face & 2 ? j : -j, face & 4 ? n - i - j : i + j - n);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return shell;
}

RC_GTEST_PROP(FastVisibilityProperty, NoLightLeaksThroughASharedEdge, ()) {
  Dice dice;
  const AreaLight light{ConvexPolygon::from_points({{-1, -1, 8}, {-1, 1, 8}, {1, 1, 8}, {1, -1, 8}}), true};
  FastVisibility fast(light, BlockerSet(draw_shell(dice, 4)));
  for (int i = 0; i < 20; ++i) {
    const Point3 p = dice.once_in(2)
                         ? draw_point(dice, 9, -9, 2)
                         : Point3{dice.draw(-99, 99) / 7.0, dice.draw(-99, 99) / 7.0, dice.draw(-99, 9) / 7.0};
    const std::optional<VisibleAreaLight> seen = fast.visible_from(p);
    RC_ASSERT(seen.has_value());
    RC_ASSERT(name(seen->region) == "umbra");
    RC_ASSERT(seen->fraction == 0.0);
    RC_ASSERT(seen->error_bound == 0.0);
  }
}

/// F5, M1 to M3 and more: what is added hides, what is hidden stays hidden.
RC_GTEST_PROP(FastVisibilityProperty, AddingABlockerNeverRaisesTheFraction, ()) {
  Dice dice;
  const Drawn scene{draw_light(dice), draw_blockers(dice, 12, 6)};
  const Point3 p = draw_point(dice, 4, -2, 1);
  double least = 1;
  for (std::size_t count = 0; count <= scene.blockers.size(); ++count) {
    const std::span<const ConvexBlocker> some(scene.blockers.data(), count);
    FastVisibility fast(scene.light, BlockerSet(some));
    const std::optional<VisibleAreaLight> seen = fast.visible_from(p);
    if (!seen || seen->region == Region::unlit) continue;
    RC_ASSERT(seen->fraction <= least + seen->error_bound);
    least = std::fmin(least, seen->fraction + seen->error_bound);
  }
}

std::optional<Region> region_behind(const AreaLight& light, std::span<const ConvexBlocker> blockers, const Point3& p) {
  const std::optional<VisibleAreaLight> seen = FastVisibility(light, BlockerSet(blockers)).visible_from(p);
  return seen ? std::optional(seen->region) : std::nullopt;
}

/// M1 to M3: what several blockers do together, from what each does alone.
RC_GTEST_PROP(FastVisibilityProperty, ShadowsUniteAndUmbraeComeFromUmbraeOrTwoPenumbrae, ()) {
  Dice dice;
  const Drawn scene{draw_light(dice), draw_blockers(dice, 4, 6)};
  for (int i = 0; i < 10; ++i) {
    const Point3 p = dice.once_in(2) ? draw_aligned_point(dice, scene) : draw_point(dice, 4, -2, 0);
    if (p.z > 0) continue;
    int lit = 0, penumbra = 0, umbra = 0;
    for (const ConvexBlocker& blocker : scene.blockers) {
      const std::optional<Region> alone = region_behind(scene.light, {&blocker, 1}, p);
      if (!alone || alone == Region::unlit) return;
      lit += alone == Region::lit ? 1 : 0;
      penumbra += alone == Region::penumbra ? 1 : 0;
      umbra += alone == Region::umbra ? 1 : 0;
    }
    const std::optional<Region> together = region_behind(scene.light, scene.blockers, p);
    if (!together) return;
    RC_ASSERT((together == Region::lit) == (lit == static_cast<int>(scene.blockers.size())));
    RC_ASSERT(together != Region::penumbra || penumbra > 0);
    RC_ASSERT(umbra == 0 || together == Region::umbra);
    RC_ASSERT(together != Region::umbra || umbra > 0 || penumbra > 1);
  }
}

VisibleAreaLight seen_behind(const AreaLight& light, const std::vector<ConvexBlocker>& blockers, const Point3& p) {
  VisibleAreaLight seen = FastVisibility(light, BlockerSet(blockers)).visible_from(p).value();
  seen.boundary = {};
  return seen;
}

TEST(FastVisibilityRefutedClaim, F5PairsOfBlockersDoNotSuffice) {
  const AreaLight light{rectangle(0, 3, 0, 1, 2)};
  const ConvexBlocker thirds[] = {rectangle(0.75, 1.25, 0.25, 0.75, 1), rectangle(1.25, 1.75, 0.25, 0.75, 1),
                                  rectangle(1.75, 2.25, 0.25, 0.75, 1)};
  const Point3 p{1.5, 0.5, 0};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(seen_behind(light, {thirds[i]}, p).fraction, 2.0 / 3, 1e-14);
    EXPECT_NEAR(seen_behind(light, {thirds[i], thirds[(i + 1) % 3]}, p).fraction, 1.0 / 3, 1e-14);
  }
  const VisibleAreaLight together = seen_behind(light, {thirds[0], thirds[1], thirds[2]}, p);
  EXPECT_EQ(together.region, Region::umbra);
  EXPECT_EQ(together.fraction, 0);
  EXPECT_EQ(together.error_bound, 0);
}

TEST(FastVisibilityRefutedClaim, F7UnitingTheUmbraeOfConvexPiecesMissesTheirJointUmbra) {
  const ConvexBlocker along = rectangle(0, 4, 0, 2, 2);
  const ConvexBlocker across = rectangle(0, 2, 2, 4, 2);
  const AreaLight lamp{rectangle(0, 1, 1, 3, 4)};
  const Point3 p{1, 2, 1};
  EXPECT_EQ(seen_behind(lamp, {along}, p).region, Region::penumbra);
  EXPECT_EQ(seen_behind(lamp, {across}, p).region, Region::penumbra);
  EXPECT_EQ(seen_behind(lamp, {along, across}, p).region, Region::umbra);
}

RC_GTEST_PROP(FastVisibilityProperty, TheOrderOfBlockersDoesNotMatter, ()) {
  Dice dice;
  Drawn scene{draw_light(dice), draw_blockers(dice, 12, 6)};
  const Point3 p = draw_point(dice, 4, -2, 1);
  FastVisibility one(scene.light, BlockerSet(scene.blockers));
  std::reverse(scene.blockers.begin(), scene.blockers.end());
  FastVisibility other(scene.light, BlockerSet(scene.blockers));
  const std::optional<VisibleAreaLight> a = one.visible_from(p);
  const std::optional<VisibleAreaLight> b = other.visible_from(p);
  RC_ASSERT(a.has_value() == b.has_value());
  if (!a) return;
  RC_ASSERT(name(a->region) == name(b->region));
  RC_ASSERT(std::fabs(a->fraction - b->fraction) <= a->error_bound + b->error_bound);
}

}  // namespace
}  // namespace gnomon
