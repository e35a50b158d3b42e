#include "gnomon/view_factors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "gnomon/errors.h"
#include "tests/shading/illumination/factor_oracles.h"

namespace gnomon {
namespace {

using factors::parallelogram;
using factors::rectangle_at;

ViewFactors all_of(const std::vector<ViewSurface>& surfaces, const std::vector<ConvexBlocker>& blockers = {},
                   double bound = 1e-9) {
  ViewFactorEffort effort;
  effort.bound = bound;
  return view_factors(surfaces, {blockers, {}}, effort);
}

ViewFactor factor(const ViewFactors& found, std::uint32_t from, std::uint32_t to) {
  for (const ViewFactor& f : found.factors) {
    if (f.from == from && f.to == to) return f;
  }
  return {from, to, 0, 0, true};
}

void expect_row_sums_of_one(const ViewFactors& found, double most) {
  std::vector<double> sums(found.areas.size()), bounds(sums.size());
  for (const ViewFactor& f : found.factors) {
    sums[f.from] += f.value;
    bounds[f.from] += f.error_bound;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    EXPECT_LE(std::fabs(sums[i] - 1), bounds[i] + 1e-15) << i;
    EXPECT_LE(std::fabs(sums[i] - 1), most) << i;
  }
}

const ViewSurface unit_floor = {rectangle_at(0, 0, 1, 1, 0, factors::Facing::up)};
const ViewSurface unit_lid = {rectangle_at(0, 0, 1, 1, 1, factors::Facing::down)};

TEST(ViewFactors, OfSquaresThatSeeEachOtherWhollyAreProvenToFourteenDigits) {
  const ViewFactor apart = factor(all_of({unit_floor, unit_lid}), 0, 1);
  EXPECT_TRUE(apart.is_proven);
  EXPECT_NEAR(apart.value, 0.19982489569838746, apart.error_bound + 1e-16);
  EXPECT_LT(apart.error_bound, 1e-13);
  // Joined along an edge, turned so that no coordinate is short.
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turned = [&](double x, double y, double z) { return Point3{c * x - s * y, s * x + c * y, z}; };
  const Point3 o = turned(0, 0, 0), x = turned(1, 0, 0), y = turned(0, 1, 0), z = turned(0, 0, 1);
  const ViewFactor joined = factor(all_of({{parallelogram(o, x, y)}, {parallelogram(o, y, z)}}), 0, 1);
  EXPECT_TRUE(joined.is_proven);
  EXPECT_NEAR(joined.value, 0.20004377607540313, joined.error_bound + 1e-15);
  EXPECT_LT(joined.error_bound, 1e-12);
}

TEST(ViewFactors, OfPolygonsFarApartAreThoseOfADoubleAreaIntegral) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 12; ++trial) {
    // Nearly level, so that neither plane cuts the other.
    const auto corner = [&](double x, double y, double height) {
      return Point3{x + 0.4 * number(random), y + 0.4 * number(random), height + 0.2 * number(random)};
    };
    const auto triangle = [&](double height) {
      return ConvexPolygon::from_points({corner(-1, -1, height), corner(1, -1, height), corner(0, 1, height)});
    };
    const ConvexPolygon low = triangle(0), high = triangle(4);
    for (const bool low_up : {true, false}) {
      const ConvexPolygon p = factors::turned_to(low, 2, low_up), q = factors::turned_to(high, 2, false);
      const ViewFactors found = all_of({{p}, {q}});
      const ViewFactor there = factor(found, 0, 1);
      EXPECT_TRUE(there.is_proven);
      const double expected = low_up ? factors::double_area_integral(p, q) : 0;
      EXPECT_NEAR(there.value * found.areas[0], expected, there.error_bound * found.areas[0] + 1e-13) << trial;
    }
  }
}

TEST(ViewFactors, BehindASquareAreThoseOfARuleOnItsExactFaces) {
  struct Case {
    double x0, x1, y0, y1, z, known;
  };
  // Shapiro's, published; the others by the oracle alone.
  for (const Case& c : {Case{.25, .75, .25, .75, .25, 0.11562060213242}, Case{.25, .75, .25, .75, .5, 0.09950629459898},
                        Case{0, .5, 0, .5, .5, 0}, Case{0, 1, .25, .75, .25, 0}, Case{.5, 1.5, -.5, .5, .75, 0}}) {
    const double expected = factors::behind_rectangle(c.x0, c.x1, c.y0, c.y1, c.z);
    if (c.known > 0) {
      EXPECT_NEAR(expected, c.known, 1e-13);
    }
    const auto board = rectangle_at(c.x0, c.y0, c.x1, c.y1, c.z, factors::Facing::up);
    const ViewFactor found = factor(all_of({unit_floor, unit_lid}, {board}, 1e-13), 0, 1);
    EXPECT_NEAR(found.value, expected, 1e-12) << c.x0;
    EXPECT_NEAR(found.value, expected, found.error_bound + 1e-15) << c.x0;
    EXPECT_LT(found.error_bound, 1e-12);
  }
}

/// By the definition: between the middles of many small rectangles of both, where the fin lets them see each other.
double past_a_fin() {
  constexpr int n = 28;
  double sum = 0;
  for (int i = 0; i < n * n; ++i) {
    const double x = -1 + (i / n + 0.5) * 2 / n, y = 2 + (i % n + 0.5) / n;
    for (int k = 0; k < n * n; ++k) {
      const double u = -1 + (k / n + 0.5) * 2 / n, z = (k % n + 0.5) * 2 / n;
      // Where the way crosses the fin's plane x = 0, the fin is the triangle 2 y + z < 2.
      const double share = (0 - x) / (u - x);
      if (share > 0 && share < 1 && 2 * y * (1 - share) + z * share < 2) continue;
      const double square = (x - u) * (x - u) + y * y + z * z;
      sum += y * z / (square * square);
    }
  }
  return sum / (n * n) / (n * n) * 4 / std::numbers::pi;
}

/// The fin touches the pane along an edge and ends on its lower corner line; some of its shadow's boundary lies on
/// lines of sight that end where it does.
TEST(ViewFactors, BehindAFinThatStandsOnTheOtherSurfaceKnowWhereItTouches) {
  const ViewSurface pane{ConvexPolygon::from_points({{-1, 0, 0}, {-1, 0, 2}, {1, 0, 2}, {1, 0, 0}})};
  const ViewSurface patch{rectangle_at(-1, 2, 1, 3, 0, factors::Facing::up)};
  const auto fin = ConvexPolygon::from_points({{0, 0, 0}, {0, 1, 0}, {0, 0, 2}});
  const ViewFactor found = factor(all_of({pane, patch}, {fin}, 1e-10), 1, 0);
  EXPECT_NEAR(found.value, past_a_fin(), 2e-4);
  EXPECT_LT(found.error_bound, 1e-10);
}

TEST(ViewFactors, BehindABoardThatHidesAllAreLeftOut) {
  const auto board = rectangle_at(-1, -1, 2, 2, .5, factors::Facing::up);
  EXPECT_TRUE(all_of({unit_floor, unit_lid}, {board}).factors.empty());
  // And surfaces that do not face each other, or lie in one plane.
  EXPECT_TRUE(all_of({unit_floor, {rectangle_at(0, 0, 1, 1, 1, factors::Facing::up)}}).factors.empty());
  EXPECT_TRUE(all_of({unit_floor, {rectangle_at(2, 0, 3, 1, 0, factors::Facing::up)}}).factors.empty());
}

TEST(ViewFactors, CountOnlyWhatLiesBeforeTheOther) {
  // A wall that reaches below the floor's plane, and stands on a part of the floor's border.
  const auto wall = [](double low) {
    return ConvexPolygon::from_points({{0, .25, low}, {0, .75, low}, {0, .75, 1}, {0, .25, 1}});
  };
  const ViewFactor whole = factor(all_of({unit_floor, {wall(0)}}), 0, 1);
  const ViewFactor cut = factor(all_of({unit_floor, {wall(-1)}}), 0, 1);
  EXPECT_GT(whole.value, 0.1);
  EXPECT_NEAR(whole.value, cut.value, whole.error_bound + cut.error_bound);
  EXPECT_LT(whole.error_bound, 1e-12);
}

TEST(ViewFactors, AddUpOverPiecesOfASurface) {
  const ViewSurface halves = {rectangle_at(0, 0, .5, 1, 1, factors::Facing::down),
                              rectangle_at(.5, 0, 1, 1, 1, factors::Facing::down)};
  const auto board = rectangle_at(.25, .25, .625, .75, .5, factors::Facing::up);
  const ViewFactor once = factor(all_of({unit_floor, unit_lid}, {board}, 1e-11), 0, 1);
  const ViewFactor in_two = factor(all_of({unit_floor, halves}, {board}, 1e-11), 0, 1);
  const ViewFactors apart = all_of({unit_floor, {halves[0]}, {halves[1]}}, {board}, 1e-11);
  EXPECT_NEAR(once.value, in_two.value, once.error_bound + in_two.error_bound);
  EXPECT_NEAR(once.value, factor(apart, 0, 1).value + factor(apart, 0, 2).value, 4e-11);
}

TEST(ViewFactors, OfAClosedRoomAddUpToOne) {
  std::vector<ViewSurface> room = factors::cube_walls(2);
  expect_row_sums_of_one(all_of(room), 1e-12);
  std::vector<ConvexBlocker> box;
  factors::add_box(room, box, {.375, .375, .25}, {.625, .75, .5});
  const ViewFactors found = all_of(room, box, 1e-12);
  expect_row_sums_of_one(found, 1e-12);
  EXPECT_GT(found.divided_pairs, 20U);
  for (const ViewFactor& f : found.factors) {
    EXPECT_NE(f.from, f.to);
    EXPECT_LE(f.value * found.areas[f.from], std::min(found.areas[f.from], found.areas[f.to]) + 1e-12);
  }
}

TEST(ViewFactors, OfARoomInTheShapeOfAnLAddUpToOne) {
  // Walls are no blockers: those at the inner corner hide what is round it.
  const auto [walls, corner] = factors::l_shaped_room();
  expect_row_sums_of_one(all_of(walls, corner, 1e-12), 1e-12);
}

TEST(ViewFactors, AreReciprocalWhereBothAreWorkedOut) {
  std::vector<ViewSurface> room = factors::cube_walls(1);
  std::vector<ConvexBlocker> box;
  factors::add_box(room, box, {.25, .375, .125}, {.5, .625, .75});
  ViewFactorEffort effort;
  effort.bound = 1e-10;
  effort.twice = true;
  const ViewFactors found = view_factors(room, {box, {}}, effort);
  EXPECT_GT(found.reciprocity_residual, 0);
  EXPECT_LT(found.reciprocity_residual, 1e-10);
  for (const ViewFactor& f : found.factors) {
    const ViewFactor back = factor(found, f.to, f.from);
    const double a = found.areas[f.from], b = found.areas[f.to];
    EXPECT_NEAR(f.value * a, back.value * b, f.error_bound * a + back.error_bound * b);
  }
  effort.from = 3;
  for (const ViewFactor& f : view_factors(room, {box, {}}, effort).factors) EXPECT_EQ(f.from, 3U);
}

TEST(ViewFactors, OfLongStripsAreThoseOfCrossedStrings) {
  // Hottel: of infinite strips, (crossed - uncrossed) / (2 width). The middle of the lower one sees the ends only to
  // the order of 1 / length².
  const double length = 4000, hidden_to = .5;
  const ViewSurface low = {rectangle_at(0, -.5, 1, .5, 0, factors::Facing::up)};
  const ViewSurface high = {rectangle_at(0, -length, 1, length, 1, factors::Facing::down)};
  const auto board = rectangle_at(-1, -length, hidden_to, length, .5, factors::Facing::up);
  const ViewFactor found = factor(all_of({low, high}, {board}, 1e-8), 0, 1);
  const double corner = std::hypot(hidden_to, .5);
  // Strings about the board's edge: crossed ones from each end of one to the far end of the other, the rest not.
  const double crossed = corner + corner + std::sqrt(2.0), uncrossed = 2 * corner + 1;
  EXPECT_NEAR(found.value, (crossed - uncrossed) / 2, 1e-6);
}

TEST(ViewFactors, AreTheSameForAnyNumberOfThreads) {
  std::vector<ViewSurface> room = factors::cube_walls(2);
  std::vector<ConvexBlocker> box;
  factors::add_box(room, box, {.375, .375, .25}, {.625, .75, .5});
  ViewFactorEffort effort;
  effort.bound = 1e-6;
  const ViewFactors one = view_factors(room, {box, {}}, effort);
  effort.threads = 3;
  const ViewFactors three = view_factors(room, {box, {}}, effort);
  ASSERT_EQ(one.factors.size(), three.factors.size());
  for (std::size_t k = 0; k < one.factors.size(); ++k) {
    EXPECT_EQ(one.factors[k].value, three.factors[k].value);
    EXPECT_EQ(one.factors[k].error_bound, three.factors[k].error_bound);
  }
}

TEST(ViewFactors, CanBeMadeToFulfilClosureAndReciprocity) {
  ViewFactors found = all_of(factors::cube_walls(2), {}, 1e-6);
  for (ViewFactor& f : found.factors) {
    if (f.from < 4) f.value *= 1.01;
    if (f.to < 4) f.value *= 1.01;
  }
  EXPECT_LT(enforce_closure(found), 1e-12);
  expect_row_sums_of_one(found, 1e-12);
  for (const ViewFactor& f : found.factors) {
    EXPECT_NEAR(f.value * found.areas[f.from], factor(found, f.to, f.from).value * found.areas[f.to], 1e-12);
  }
}

TEST(ViewFactors, ArePeakedWhereSurfacesPierceEachOtherAndTheEstimateKnows) {
  const ConvexPolygon first =
      ConvexPolygon::from_points({{-0.2773185017598594, 0.7112227188227025, -0.6427823604708229},
                                  {-0.4031178109418032, 0.7641290568719996, 0.4004417174702908},
                                  {-0.21115817879319487, -0.7653787811158581, 0.3303039645836856}});
  const ConvexPolygon second =
      ConvexPolygon::from_points({{-0.986015454321499, -0.3906686531304915, 0.9858889718819175},
                                  {-0.7607154846753643, 0.9925196222175485, 0.258875804551002},
                                  {0.08858944893275789, -0.09629362702736954, -0.7505076523548193}});
  const std::vector<ConvexBlocker> blockers = {
      ConvexPolygon::from_points({{-0.05566983300161388, -0.9051524128300426, 0.9553040237469592},
                                  {0.3762957217650402, 0.5065992835974913, -0.16028043146731719},
                                  {0.4311233714075182, 0.3904079580937698, -0.09228823561592336}}),
      ConvexPolygon::from_points({{-0.30769870619542883, 0.807151751962649, -0.9451051771781047},
                                  {-0.9148654261093543, -0.8309358597974157, -0.5359260196527802},
                                  {0.05968234250679072, 0.4356148623464535, -0.31839372293227775}})};
  const double known = 0.00647714380;  // at a bound of 1e-8, from both sides
  ViewFactorEffort effort;
  effort.bound = 1e-5;
  effort.most_evaluations = 3000;
  const std::vector<ViewSurface> surfaces = {{first}, {second}};
  const ViewFactor found = factor(view_factors(surfaces, {blockers, {}}, effort), 0, 1);
  EXPECT_NEAR(found.value, known, found.error_bound);
  EXPECT_LT(found.error_bound, 1e-4);
}

/// Surfaces that share an edge, touch along one and pierce each other, behind a box that stands on one of them:
/// irradiance has many limits where they end, and each side of a pair is worked out on another surface.
TEST(ViewFactors, AreReciprocalUpToTheirEstimatesWhereSurfacesTouch) {
  constexpr unsigned seed = 27;
  std::mt19937 engine(seed);
  const auto some = [&](double low, double high) {
    return std::round(64 * std::uniform_real_distribution<double>(low, high)(engine)) / 64;
  };
  ViewFactorEffort effort;
  effort.twice = true;
  effort.bound = 1e-7;
  std::size_t estimates = 0;
  for (int scene = 0; scene < (GNOMON_LONG ? 300 : 12); ++scene) {
    const Point3 a{some(0.5, 2), some(0.5, 2), 0}, low{some(2.3, 2.8), some(1, 2.5), 0};
    const double u = some(-0.5, 1), v = some(0.5, 1), lean = some(-0.5, 0.5), below = scene % 2 ? some(0.1, 0.5) : 0;
    const ViewSurface board = {
        parallelogram({a.x, a.y, -below}, {a.x + u, a.y + v, -below}, {a.x + lean, a.y - lean, some(0.25, 1)})};
    const ViewSurface floor = {rectangle_at(0, 0, 4, 4, 0, factors::Facing::up)};
    const ViewSurface wall = {parallelogram({4, 0, 0}, {4, 4, 0}, {4, 0, 3})};
    const double w = some(0.25, 0.75), h = some(0.25, 1);
    std::vector<Point3> box;
    for (int c = 0; c < 8; ++c) box.push_back({low.x + (c & 1 ? w : 0), low.y + (c & 2 ? w : 0), c & 4 ? h : 0});
    const ViewFactors found = view_factors(std::vector{floor, wall, board}, {{ConvexSolid::hull_of(box)}, {}}, effort);
    for (const auto& [from, to] : {std::pair(0U, 1U), std::pair(0U, 2U), std::pair(1U, 2U)}) {
      const ViewFactor there = factor(found, from, to), back = factor(found, to, from);
      const double p = found.areas[from], q = found.areas[to];
      EXPECT_LE(std::fabs(p * there.value - q * back.value), p * there.error_bound + q * back.error_bound)
          << "scene " << scene << ": " << from << ' ' << to << ", " << p * there.value - q * back.value << " of "
          << p * there.value;
      estimates += there.is_proven && back.is_proven ? 0 : 1;
    }
  }
  std::cout << estimates << " pairs with an estimate\n";
  EXPECT_GT(estimates, 10U);
}

/// Two rules of Gauss agree by chance on a part of the floor that both miss.
TEST(ViewFactors, BehindTwoBoxesOnEachOtherAreReciprocalUpToTheirEstimates) {
  const ViewSurface floor = {rectangle_at(0, 0, 4, 4, 0, factors::Facing::up)};
  const ViewSurface wall = {parallelogram({0, 4, 0}, {4, 4, 0}, {0, 4, 4})};
  const auto box = [](const Point3& low, const Point3& high) {
    std::vector<Point3> points;
    for (int c = 0; c < 8; ++c) {
      points.push_back({c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z});
    }
    return ConvexSolid::hull_of(std::move(points));
  };
  ViewFactorEffort effort;
  effort.twice = true;
  effort.bound = 1e-7;
  const ViewFactors found = view_factors(
      std::vector{floor, wall},
      {{box({1.25, 0.875, 0.875}, {2.375, 2.375, 2.375}), box({1, 0.75, 0}, {2.125, 2.125, 0.875})}, {}}, effort);
  const ViewFactor there = factor(found, 0, 1), back = factor(found, 1, 0);
  EXPECT_GT(there.value, 0.17);
  EXPECT_LE(std::fabs(there.value - back.value), there.error_bound + back.error_bound);
  EXPECT_LT(there.error_bound + back.error_bound, 1e-7);
}

TEST(ViewFactors, KnowWhereAnEdgeOfOneSurfacePiercesTheOtherBesideABlocker) {
  const ViewSurface floor = {rectangle_at(0, 0, 4, 4, 0, factors::Facing::up)};
  const ViewSurface board = {ConvexPolygon::from_points({{1.890625, 1.703125, -0.484375},
                                                         {2.390625, 2.5, -0.484375},
                                                         {2.796875, 2.09375, 0.4375},
                                                         {2.296875, 1.296875, 0.4375}})};
  const Point3 low{2.3125, 1.703125, 0}, high{2.921875, 2.3125, 0.59375};
  std::vector<Point3> box;
  for (int c = 0; c < 8; ++c) box.push_back({c & 1 ? low.x : high.x, c & 2 ? low.y : high.y, c & 4 ? low.z : high.z});
  ViewFactorEffort effort;
  effort.twice = true;
  effort.bound = 1e-7;
  const ViewFactors found = view_factors(std::vector{floor, board}, {{ConvexSolid::hull_of(box)}, {}}, effort);
  for (const ViewFactor& f : found.factors) {
    const double area = found.areas[f.from];
    EXPECT_NEAR(area * f.value, 0.117735274012, area * f.error_bound + 1e-11) << f.from;
    EXPECT_LT(f.error_bound, 1e-7);
  }
}

/// A polygon turned by angles that leave no coordinate short.
ConvexPolygon turned_awkwardly(const ConvexPolygon& polygon) {
  std::vector<Point3> points;
  for (const Point3& p : polygon.points()) {
    const double c = std::cos(0.1234), s = std::sin(0.1234), d = std::cos(0.77), e = std::sin(0.77);
    const double x = c * p.x - s * p.y, y = s * p.x + c * p.y;
    points.push_back({x, d * y - e * p.z, e * y + d * p.z});
  }
  return ConvexPolygon::from_points(points);
}

/// As scenes make it a blocker.
ConvexBlocker plate_of(const ConvexPolygon& polygon) {
  if (polygon.is_flat()) return polygon;
  return ConvexSolid::hull_of({polygon.points().begin(), polygon.points().end()});
}

TEST(ViewFactors, OfRoundedWallsThatAreBlockersTooAreThoseOfTheWallsAlone) {
  std::vector<ViewSurface> walls;
  std::vector<ConvexBlocker> blockers;
  std::size_t rounded = 0;
  for (const ViewSurface& wall : factors::cube_walls(1)) {
    walls.push_back({turned_awkwardly(wall.front())});
    blockers.push_back(plate_of(walls.back().front()));
    rounded += walls.back().front().is_flat() ? 0 : 1;
  }
  ASSERT_GT(rounded, 1U);
  ViewFactorEffort effort;
  effort.bound = 1e-4;
  effort.most_evaluations = 1000;
  // The walls across from each other, each as its own blocker.
  for (std::uint32_t k = 0; k < 6; k += 2) {
    const std::vector<ViewSurface> two = {walls[k], walls[k + 1]};
    const ViewFactor found = factor(view_factors(two, {{blockers[k], blockers[k + 1]}, {}}, effort), 0, 1);
    EXPECT_NEAR(found.value, 0.19982489569838746, found.error_bound + 1e-15) << k;
    EXPECT_TRUE(found.is_proven);
    EXPECT_LT(found.error_bound, 1e-12);
  }
}

TEST(ViewFactors, OfTheTwoSidesOfARoundedPlateAreNone) {
  for (const ViewSurface& wall : factors::cube_walls(1)) {
    const ConvexPolygon front = turned_awkwardly(wall.front());
    std::vector<Point3> back(front.points().rbegin(), front.points().rend());
    const std::vector<ViewSurface> sides = {{front}, {ConvexPolygon::from_points(back)}};
    EXPECT_TRUE(all_of(sides, {plate_of(front)}).factors.empty());
    EXPECT_TRUE(all_of(sides).factors.empty());
  }
}

TEST(ViewFactors, NeedAPositiveBound) {
  EXPECT_THROW(all_of({unit_floor, unit_lid}, {}, 0), PreconditionError);
  EXPECT_THROW(all_of({unit_floor, unit_lid}, {}, NAN), PreconditionError);
}

}  // namespace
}  // namespace gnomon
