#include "shading/illumination/standing_between.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "gnomon/visibility.h"

namespace gnomon::illumination {
namespace {

/// Places on a small grid, so that touching, crossing and coplanar things are common.
class GridDraw {
 public:
  explicit GridDraw(unsigned seed) : random_(seed) {}

  double number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Point3 point(int low, int high) { return {number(-2, 2), number(-2, 2), number(low, high)}; }

  ConvexPolygon triangle(int low, int high) {
    for (;;) {
      const std::vector<Point3> points = {point(low, high), point(low, high), point(low, high)};
      if (!ConvexPolygon::defect(points)) return ConvexPolygon::from_points(points);
    }
  }
  ConvexBlocker blocker() {
    if (number(0, 1) == 0) return triangle(1, 3);
    const Point3 p = point(1, 2);
    return ConvexSolid::hull_of(
        {p, {p.x + 1, p.y, p.z}, {p.x, p.y + 1, p.z}, {p.x, p.y, p.z + 1}, {p.x + 1, p.y + number(0, 1), p.z + 1}});
  }
  /// Inside of a triangle.
  Point3 within(const ConvexPolygon& t) {
    const auto p = t.points();
    const double u = number(1, 14) / 16, v = (1 - u) * number(1, 15) / 16, w = 1 - u - v;
    return {u * p[0].x + v * p[1].x + w * p[2].x, u * p[0].y + v * p[1].y + w * p[2].y,
            u * p[0].z + v * p[1].z + w * p[2].z};
  }

 private:
  std::mt19937 random_;
};

TEST(StandingBetween, LeavesOutNothingThatHides) {
  std::size_t hiding = 0, left_out = 0;
  for (unsigned seed = 1; seed <= 600; ++seed) {
    GridDraw draw(seed);
    const ConvexPolygon low = draw.triangle(0, 1), high = draw.triangle(3, 4);
    std::vector<ConvexBlocker> blockers;
    for (int n = 0; n < 4; ++n) blockers.push_back(draw.blocker());
    std::vector<std::uint32_t> found;
    StandingBetween(blockers).find(low, high, found);
    EXPECT_TRUE(std::ranges::is_sorted(found));
    left_out += blockers.size() - found.size();
    const auto hides = [&](std::uint32_t b, const Point3& p, const Point3& q) {
      // Of what lies before both, as surfaces send and receive with their fronts.
      const FacetFront at_p = facet_front(low);
      const Visibility seen =
          LightVisibility(PointLight{q}, PreparedObstacles({{blockers[b]}, {}})).received({p, at_p, {}});
      const FacetFront at_q = facet_front(high);
      const Visibility back =
          LightVisibility(PointLight{p}, PreparedObstacles({{blockers[b]}, {}})).received({q, at_q, {}});
      return seen.region == Region::umbra && back.region == Region::umbra;
    };
    for (std::uint32_t b = 0; b < blockers.size(); ++b) {
      if (std::ranges::binary_search(found, b)) continue;
      for (int n = 0; n < 12; ++n) EXPECT_FALSE(hides(b, draw.within(low), draw.within(high))) << seed << ' ' << b;
    }
    for (const std::uint32_t b : found) hiding += hides(b, draw.within(low), draw.within(high)) ? 1 : 0;
  }
  EXPECT_GT(hiding, 50U);
  EXPECT_GT(left_out, 500U);
}

}  // namespace
}  // namespace gnomon::illumination
