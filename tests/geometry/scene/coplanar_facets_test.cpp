#include "geometry/scene/coplanar_facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace gnomon {
namespace {

/// A place in the plane of small whole numbers, where doubles are exact.
struct Spot {
  long x, y;
  friend auto operator<=>(const Spot&, const Spot&) = default;
};
using Outline = std::vector<Spot>;

long turn(const Spot& p, const Spot& q, const Spot& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

long doubled_area(const Outline& ring) {
  long sum = 0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) sum += turn(ring[0], ring[k], ring[k + 1]);
  return sum;
}

/// Twice the area of the convex hull, by going around it.
long doubled_hull_area(Outline all) {
  std::ranges::sort(all);
  Outline hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Spot& p : all) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(all);
  }
  return doubled_area(hull);
}

/// 1 inside a convex ring that runs counterclockwise, -1 inside one that runs clockwise, 0 outside; 9 in line with an
/// edge.
int cover(const Outline& ring, const Spot& p) {
  int left = 0, right = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const long side = turn(ring[k], ring[(k + 1) % ring.size()], p);
    if (side == 0) return 9;
    (side > 0 ? left : right) += 1;
  }
  return right == 0 ? 1 : left == 0 ? -1 : 0;
}

/// How often, and from which side, facets cover a place; nothing in line with an edge.
std::optional<std::pair<int, int>> covers(const std::vector<Outline>& rings, const Spot& p) {
  std::pair<int, int> count{0, 0};
  for (const Outline& ring : rings) {
    const int here = cover(ring, p);
    if (here == 9) return std::nullopt;
    count.first += here == 1;
    count.second += here == -1;
  }
  return count;
}

constexpr long cell = 14;
constexpr long cells = 4;

/// Triangles of a grid: halves of cells, some left out, some turned around, some twice.
struct Grid {
  std::vector<Outline> facets;
  bool has_facets_twice = false;

  explicit Grid(std::mt19937& engine) {
    const auto one_of = [&](int n) { return std::uniform_int_distribution(0, n - 1)(engine) == 0; };
    const int gaps = std::uniform_int_distribution(3, 30)(engine);
    for (long i = 0; i < cells; ++i) {
      for (long j = 0; j < cells; ++j) {
        const Spot a{i * cell, j * cell}, b{a.x + cell, a.y}, c{a.x + cell, a.y + cell}, d{a.x, a.y + cell};
        const bool rises = one_of(2);
        for (Outline facet :
             rises ? std::vector<Outline>{{a, b, c}, {a, c, d}} : std::vector<Outline>{{a, b, d}, {b, c, d}}) {
          if (one_of(gaps)) continue;
          if (one_of(3 * gaps)) std::ranges::reverse(facet);
          facets.push_back(facet);
          if (!one_of(200)) continue;
          facets.push_back(facet);
          has_facets_twice = true;
        }
      }
    }
    std::ranges::shuffle(facets, engine);
  }
};

/// The grid in a plane of space, every corner a vertex of its own as STL files have them, and back.
std::vector<Outline> joined(const std::vector<Outline>& facets) {
  std::vector<Point3> points;
  std::vector<Ring> rings;
  for (const Outline& facet : facets) {
    rings.emplace_back();
    for (const Spot& p : facet) {
      rings.back().push_back(static_cast<std::uint32_t>(points.size()));
      const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
      points.push_back({x == 0 && points.size() % 2 == 0 ? -0.0 : x, y - 7 * x, 3 * x + y / 3 * 3 + 5});
    }
  }
  std::vector<Outline> result;
  for (const Ring& ring : joined_facets(points, rings)) {
    result.emplace_back();
    for (const std::uint32_t v : ring) {
      const auto x = static_cast<long>(points[v].x);
      result.back().push_back({x, static_cast<long>(points[v].y) + 7 * x});
    }
  }
  return result;
}

TEST(CoplanarFacets, CoverWhatTheyCoveredBeforeFromTheSameSide) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 engine(seed);
    const Grid grid(engine);
    const std::vector<Outline> result = joined(grid.facets);
    EXPECT_LE(result.size(), grid.facets.size());
    int looked_at = 0;
    for (long x = 0; x <= cells * cell; ++x) {
      for (long y = 0; y <= cells * cell; ++y) {
        const auto before = covers(grid.facets, {x, y});
        const auto after = covers(result, {x, y});
        if (!before || !after) continue;
        ++looked_at;
        ASSERT_EQ(before, after) << x << ' ' << y;
      }
    }
    EXPECT_GT(looked_at, 1000);
  }
}

TEST(CoplanarFacets, AreConvexAndNoTwoOfThemMakeAConvexOne) {
  int pairs = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 engine(seed);
    const Grid grid(engine);
    const std::vector<Outline> result = joined(grid.facets);
    for (const Outline& ring : result) {
      ASSERT_EQ(std::abs(doubled_area(ring)), doubled_hull_area(ring));
      ASSERT_GT(doubled_hull_area(ring), 0);
    }
    if (grid.has_facets_twice) continue;
    for (std::size_t a = 0; a < result.size(); ++a) {
      for (std::size_t b = a + 1; b < result.size(); ++b) {
        if ((doubled_area(result[a]) > 0) != (doubled_area(result[b]) > 0)) continue;
        Outline both = result[a];
        both.insert(both.end(), result[b].begin(), result[b].end());
        ++pairs;
        ASSERT_NE(doubled_hull_area(both), std::abs(doubled_area(result[a])) + std::abs(doubled_area(result[b])));
      }
    }
  }
  EXPECT_GT(pairs, 10000);
}

TEST(CoplanarFacets, AroundAVertexThatNoPairMakesConvexAreOnePolygonTogether) {
  // A pentagon from a vertex inside: any two neighbours of it are convex, more than two are not until all are there.
  const std::vector<Point3> points = {{0, 0, 0}, {40, 10, 0}, {10, 40, 0}, {-30, 20, 0}, {-30, -20, 0}, {20, -40, 0}};
  const std::vector<Ring> fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}};
  EXPECT_EQ(joined_facets(points, fan), (std::vector<Ring>{{1, 2, 3, 4, 5}}));
  const std::vector<Ring> gap(fan.begin(), fan.end() - 1);
  EXPECT_GT(joined_facets(points, gap).size(), 1u);
}

TEST(CoplanarFacets, AreJoinedInOnePlaneAloneAndFromOneSideAlone) {
  // The sides of a pyramid have a convex boundary together, its base; so has a triangle with half of it turned around.
  const std::vector<Point3> points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}};
  const std::vector<Ring> roof = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  EXPECT_EQ(joined_facets(points, roof), roof);
  const std::vector<Ring> folded = {{0, 1, 2, 3}, {1, 0, 2}};
  EXPECT_EQ(joined_facets(points, folded), folded);
}

TEST(CoplanarFacets, LeaveVerticesOutAtWhichTheyDoNotTurnOnceJoined) {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(joined_facets(points, std::vector<Ring>{{0, 1, 4, 5}, {1, 2, 3, 4}}), (std::vector<Ring>{{0, 2, 3, 5}}));
  const std::vector<Ring> alone = {{0, 1, 2, 3, 4, 5}};
  EXPECT_EQ(joined_facets(points, alone), alone);
}

TEST(CoplanarFacets, WithoutAnExactPlaneStayAsTheyAre) {
  const double tilted = 0.1;
  const std::vector<Point3> points = {
      {0, 0, 0}, {1, 0, 0}, {1, 1, std::nextafter(0.0, 1.0)}, {0, 1, 0}, {0.3, 0.7, tilted}};
  const std::vector<Ring> halves = {{0, 1, 3}, {1, 2, 3}, {3, 2, 4}};
  EXPECT_EQ(joined_facets(points, halves), halves);
  const std::vector<Ring> concave = {{0, 1, 3, 4}};
  EXPECT_EQ(joined_facets(points, concave), concave);
  EXPECT_TRUE(joined_facets(points, {}).empty());
}

}  // namespace
}  // namespace gnomon
