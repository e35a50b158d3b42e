#include "gnomon/blocker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "apps/proof/laws/cone.h"
#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/pair_generator.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

using laws::draw;
using laws::ExactPlane;
using laws::ExactVector;
using laws::once_in;
using testing::ElementsAre;
using testing::SizeIs;
using Points = std::vector<Point3>;
using Indices = std::vector<std::uint32_t>;

/// From the definition: the points that are no combination of the others; of equal points the first.
Indices oracle_corners(const Points& points) {
  Indices corners;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (std::find(points.begin(), points.begin() + i, points[i]) != points.begin() + i) continue;
    std::vector<laws::ExactColumn> others;
    for (const Point3& p : points) {
      if (p != points[i]) others.push_back({Rational(p.x), Rational(p.y), Rational(p.z), 1});
    }
    const Point3& p = points[i];
    if (!laws::is_in_cone(others, {Rational(p.x), Rational(p.y), Rational(p.z), 1})) corners.push_back(i);
  }
  return corners;
}

/// Every plane through three corners that has no point above it, as the set of the corners on it.
std::set<std::set<std::uint32_t>> oracle_facets(const Points& points, const Indices& corners) {
  const std::vector<ExactVector> exact = laws::exact(points);
  std::set<std::set<std::uint32_t>> facets;
  for (const std::uint32_t a : corners) {
    for (const std::uint32_t b : corners) {
      for (const std::uint32_t c : corners) {
        if (a >= b || a >= c || b == c) continue;
        const ExactPlane plane = laws::plane_through(exact[a], exact[b], exact[c]);
        const auto below = [&](const ExactVector& p) { return plane.side(p) <= 0; };
        if (laws::is_zero(plane.normal) || !std::all_of(exact.begin(), exact.end(), below)) continue;
        std::set<std::uint32_t> on;
        for (const std::uint32_t i : corners) {
          if (plane.side(exact[i]) == 0) on.insert(i);
        }
        facets.insert(on);
      }
    }
  }
  return facets;
}

/// Convex and counterclockwise: no point above the plane of any three consecutive vertices, and every vertex strictly
/// to the left of every edge it is not an end of.
bool runs_counterclockwise(const Points& points, const Indices& loop) {
  const std::vector<ExactVector> exact = laws::exact(points);
  const std::size_t n = loop.size();
  const ExactPlane plane = laws::plane_through(exact[loop[0]], exact[loop[1]], exact[loop[2]]);
  if (!std::all_of(exact.begin(), exact.end(), [&](const auto& p) { return plane.side(p) <= 0; })) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const ExactVector from = exact[loop[i]];
    const ExactVector edge = exact[loop[(i + 1) % n]] - from;
    for (std::size_t j = 2; j < n; ++j) {
      const ExactVector turn = laws::cross(edge, exact[loop[(i + j) % n]] - from);
      if (laws::sign(laws::dot(turn, plane.normal)) <= 0) return false;
    }
  }
  return true;
}

bool holds(const ConvexSolid::Facet& facet, std::uint32_t from, std::uint32_t to) {
  const std::size_t n = facet.loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (facet.loop[i] == from && facet.loop[(i + 1) % n] == to) return true;
  }
  return false;
}

void check_edges(const ConvexSolid& solid) {
  std::size_t sides = 0;
  for (const ConvexSolid::Facet& facet : solid.facets()) sides += facet.loop.size();
  RC_ASSERT(sides == 2 * solid.edges().size());
  RC_ASSERT(solid.corners().size() + solid.facets().size() == solid.edges().size() + 2);
  for (const ConvexSolid::Edge& edge : solid.edges()) {
    RC_ASSERT(edge.from < edge.to);
    RC_ASSERT(holds(solid.facets()[edge.left], edge.from, edge.to));
    RC_ASSERT(holds(solid.facets()[edge.right], edge.to, edge.from));
  }
}

bool is_flat(const Points& points) {
  const std::vector<ExactVector> exact = laws::exact(points);
  for (const ExactVector& a : exact) {
    for (const ExactVector& b : exact) {
      const ExactPlane plane = laws::plane_through(exact[0], a, b);
      if (std::any_of(exact.begin(), exact.end(), [&](const auto& p) { return plane.side(p) != 0; })) return false;
    }
  }
  return true;
}

void check_hull(const Points& points) {
  if (points.size() < 4 || is_flat(points)) {
    RC_ASSERT_THROWS_AS(ConvexSolid::hull_of(points), PreconditionError);
    return;
  }
  const ConvexSolid solid = ConvexSolid::hull_of(points);
  const Indices corners = oracle_corners(points);
  RC_ASSERT(Indices(solid.corners().begin(), solid.corners().end()) == corners);
  std::set<std::set<std::uint32_t>> facets;
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    facets.insert({facet.loop.begin(), facet.loop.end()});
    RC_ASSERT(runs_counterclockwise(points, facet.loop));
    RC_ASSERT(facet.loop.front() == *std::min_element(facet.loop.begin(), facet.loop.end()));
  }
  RC_ASSERT(facets.size() == solid.facets().size());
  RC_ASSERT(facets == oracle_facets(points, corners));
  check_edges(solid);
}

Points draw_points(int least, int most, int range) {
  Points points(static_cast<std::size_t>(draw(least, most)));
  for (Point3& p : points) {
    const double x = draw(-range, range), y = draw(-range, range);
    p = {x, y, double(draw(-range, range))};
  }
  return points;
}

/// Whole points of a small grid, moved, stretched and nudged, so that many lie on facets and edges, or nearly.
Points draw_nearly_degenerate() {
  Points points = draw_points(4, 11, draw(1, 2));
  const double stretch = std::ldexp(1.0, draw(-30, 30));
  const double offset = once_in(2) ? 0 : 1e8;
  const bool needle = once_in(3);
  for (Point3& p : points) {
    p = {p.x * (needle ? 1e9 : 1) + offset, p.y * stretch + offset, p.z * stretch};
    if (once_in(3)) p = laws::nudged(p);
  }
  return points;
}

RC_GTEST_PROP(ConvexSolidAgreement, MatchesTheDefinitionOnPointsOfASmallGrid, ()) {
  check_hull(draw_points(4, 12, draw(1, 3)));
}

RC_GTEST_PROP(ConvexSolidAgreement, MatchesTheDefinitionNearDegeneracy, ()) {
  check_hull(draw_nearly_degenerate());
}

RC_GTEST_PROP(ConvexSolidProperty, TheOrderOfThePointsChangesNamesAlone, ()) {
  const Points points = draw_points(4, 12, 2);
  RC_PRE(!is_flat(points));
  Points reversed(points.rbegin(), points.rend());
  const auto sets = [](const ConvexSolid& solid) {
    std::multiset<std::set<std::tuple<double, double, double>>> result;
    for (const ConvexSolid::Facet& facet : solid.facets()) {
      std::set<std::tuple<double, double, double>> on;
      for (const std::uint32_t i : facet.loop)
        on.emplace(solid.points()[i].x, solid.points()[i].y, solid.points()[i].z);
      result.insert(on);
    }
    return result;
  };
  RC_ASSERT(sets(ConvexSolid::hull_of(points)) == sets(ConvexSolid::hull_of(reversed)));
}

/// The unit cube's corners, vertex i at the binary digits of i.
Points cube() {
  Points points;
  for (unsigned i = 0; i < 8; ++i) points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  return points;
}

TEST(ConvexSolid, OfATetrahedronHasFourTrianglesAndSixEdges) {
  const ConvexSolid solid = ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_THAT(solid.corners(), ElementsAre(0, 1, 2, 3));
  const std::vector<ConvexSolid::Facet> facets = {{{0, 1, 3}}, {{0, 2, 1}}, {{0, 3, 2}}, {{1, 2, 3}}};
  EXPECT_TRUE(std::ranges::equal(solid.facets(), facets));
  const std::vector<ConvexSolid::Edge> edges = {{0, 1, 0, 1}, {0, 2, 1, 2}, {0, 3, 2, 0},
                                                {1, 2, 3, 1}, {1, 3, 0, 3}, {2, 3, 3, 2}};
  EXPECT_TRUE(std::ranges::equal(solid.edges(), edges));
}

TEST(ConvexSolidDegenerate, ACubeWithPointsOnFacetsAndEdgesAndInsideAndRepeatedHasSixSquares) {
  Points points = cube();
  points.insert(points.end(), {{0.5, 0.5, 0}, {0.25, 0.5, 0}, {1, 0.5, 0}, {0.5, 0, 0}, {0.5, 0.5, 0.5}, {1, 1, 1}});
  points.insert(points.begin(), {0.5, 0.75, 1});
  const ConvexSolid solid = ConvexSolid::hull_of(points);
  EXPECT_THAT(solid.corners(), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(solid.facets(), SizeIs(6));
  EXPECT_THAT(solid.edges(), SizeIs(12));
  for (const ConvexSolid::Facet& facet : solid.facets()) EXPECT_THAT(facet.loop, SizeIs(4));
  EXPECT_THAT(solid.points(), SizeIs(15));
}

TEST(ConvexSolidDegenerate, OneUlpAboveAFacetMakesARoofAndOneUlpBelowNothing) {
  Points points = cube();
  points.push_back({0.5, 0.5, std::nextafter(1.0, 2.0)});
  EXPECT_THAT(ConvexSolid::hull_of(points).facets(), SizeIs(9));
  points.back().z = std::nextafter(1.0, 0.0);
  EXPECT_THAT(ConvexSolid::hull_of(points).facets(), SizeIs(6));
}

TEST(ConvexSolidDegenerate, OneUlpBeyondAnEdgeWithinTheOtherFacetMakesThatAPentagon) {
  Points points = cube();
  points.push_back({0.5, 0, std::nextafter(1.0, 2.0)});
  const ConvexSolid solid = ConvexSolid::hull_of(points);
  EXPECT_THAT(solid.corners(), SizeIs(9));
  const auto pentagons = std::ranges::count_if(solid.facets(), [](const auto& f) { return f.loop.size() == 5; });
  EXPECT_EQ(pentagons, 1);
}

TEST(ConvexSolidDegenerate, NeedlesAndTinyAndHugeSolidsAreHulls) {
  const ConvexSolid needle = ConvexSolid::hull_of({{0, 0, 0}, {1e9, 0, 0}, {1e9, 1, 0}, {5e8, 0.5, 5e-324}});
  EXPECT_THAT(needle.facets(), SizeIs(4));
  EXPECT_THAT(ConvexSolid::hull_of({{0, 0, 0}, {5e-324, 0, 0}, {0, 5e-324, 0}, {0, 0, 5e-324}}).facets(), SizeIs(4));
  const double huge = std::numeric_limits<double>::max();
  EXPECT_THAT(ConvexSolid::hull_of({{-huge, -huge, -huge}, {huge, 0, 0}, {0, huge, 0}, {0, 0, huge}}).facets(),
              SizeIs(4));
}

TEST(ConvexSolidDegenerate, ZerosOfEitherSignAreOnePoint) {
  EXPECT_THAT(ConvexSolid::hull_of({{0, 0, 0}, {-0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).corners(),
              ElementsAre(0, 2, 3, 4));
}

TEST(ConvexSolid, RefusesFewerThanFourCoplanarAndInfinitePoints) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), PreconditionError);
  EXPECT_THROW(ConvexSolid::hull_of({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}), PreconditionError);
  EXPECT_THROW(ConvexSolid::hull_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), PreconditionError);
  EXPECT_THROW(ConvexSolid::hull_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}), PreconditionError);
  EXPECT_THROW(ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, infinity}}), PreconditionError);
}

TEST(ConvexBlocker, OfAFlatPolygonIsThatAndOfARoundedOneASolid) {
  const ConvexBlocker flat = convex_blocker(ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_TRUE(std::holds_alternative<ConvexPolygon>(flat));
  const ConvexBlocker rounded =
      convex_blocker(ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1e-12}}));
  ASSERT_TRUE(std::holds_alternative<ConvexSolid>(rounded));
  EXPECT_THAT(std::get<ConvexSolid>(rounded).facets(), SizeIs(4));
}

/// A rounded polygon of many vertices, and a prism and a cone over it: a quadratic hull would not come back in time.
TEST(ConvexSolidDegenerate, RoundedTenThousandGonPrismAndConeAreHulls) {
  const int n = 10000;
  Points ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    ring.push_back({std::cos(angle), std::sin(angle), std::cos(angle) / 3 + 0.7 * std::sin(angle)});
  }
  const ConvexSolid solid = ConvexSolid::hull_of(ring);
  EXPECT_EQ(solid.corners().size() + solid.facets().size(), solid.edges().size() + 2);
  Points prism;
  for (const Point3& p : ring) prism.insert(prism.end(), {{p.x, p.y, 0}, {p.x, p.y, 1}});
  EXPECT_THAT(ConvexSolid::hull_of(prism).facets(), SizeIs(n + 2));
  Points cone(prism.size() / 2 + 1, Point3{0, 0, 1});
  for (std::size_t i = 1; i < cone.size(); ++i) cone[i] = prism[2 * i - 2];
  EXPECT_THAT(ConvexSolid::hull_of(cone).facets(), SizeIs(n + 1));
}

}  // namespace
}  // namespace gnomon
