#include "geometry/bodies/closed_surface.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/exact.h"
#include "gnomon/blocker.h"

namespace gnomon {
namespace {

using laws::draw;

/// The hull's facets in triangles, inside out if asked for.
ClosedSurface surface_of(const ConvexSolid& solid, bool inside_out = false) {
  ClosedSurface surface{{solid.points().begin(), solid.points().end()}, {}};
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    for (std::size_t i = 2; i < facet.loop.size(); ++i) {
      surface.triangles.push_back({facet.loop[0], facet.loop[i - 1], facet.loop[i]});
      if (inside_out) std::swap(surface.triangles.back()[1], surface.triangles.back()[2]);
    }
  }
  return surface;
}

ClosedSurface united(ClosedSurface a, const ClosedSurface& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({i + offset, j + offset, k + offset});
  return a;
}

Point3 draw_point(int range) {
  const double x = draw(-range, range), y = draw(-range, range);
  return {x, y, double(draw(-range, range))};
}

/// The hull of a tetrahedron and a few more points.
ConvexSolid draw_solid() {
  const int base = draw(-3, 2), top = draw(1, 3);
  std::vector<Point3> points = {
      {-1, -1, double(base)}, {2, 0, double(base)}, {0, 2, double(base)}, {1, 1, base + double(top)}};
  for (int more = draw(0, 5); more > 0; --more) points.push_back(draw_point(3));
  return ConvexSolid::hull_of(points);
}

/// -1, 0, +1 strictly inside, on, outside the solid, from the planes of its facets.
int side(const ConvexSolid& solid, const Point3& p) {
  int result = -1;
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    const auto point = [&](std::size_t i) { return laws::exact(solid.points()[facet.loop[i]]); };
    result = std::max(result, laws::plane_through(point(0), point(1), point(2)).side(laws::exact(p)));
  }
  return result;
}

RC_GTEST_PROP(ClosedSurfaceAgreement, EnclosesTheInsideOfAConvexSolidWhicheverWayItIsWound, ()) {
  const ConvexSolid solid = draw_solid();
  const Point3 p = draw_point(3);
  RC_ASSERT(is_strictly_inside(p, surface_of(solid)) == (side(solid, p) < 0));
  RC_ASSERT(is_strictly_inside(p, surface_of(solid, true)) == (side(solid, p) < 0));
}

RC_GTEST_PROP(ClosedSurfaceAgreement, TwoShellsEncloseWhatEitherDoesButNotTheirSurface, ()) {
  const ConvexSolid one = draw_solid();
  const ConvexSolid two = draw_solid();
  const Point3 p = draw_point(3);
  const bool on_surface = side(one, p) == 0 || side(two, p) == 0;
  const bool inside = side(one, p) < 0 || side(two, p) < 0;
  RC_ASSERT(is_strictly_inside(p, united(surface_of(one), surface_of(two))) == (inside && !on_surface));
}

RC_GTEST_PROP(ClosedSurfaceAgreement, ACavityIsOutside, ()) {
  const ConvexSolid cavity = draw_solid();
  const ConvexSolid block = ConvexSolid::hull_of(
      {{9, 9, 9}, {-9, 9, 9}, {9, -9, 9}, {-9, -9, 9}, {9, 9, -9}, {-9, 9, -9}, {9, -9, -9}, {-9, -9, -9}});
  const Point3 p = draw_point(9);
  const bool inside = side(block, p) < 0 && side(cavity, p) > 0;
  RC_ASSERT(is_strictly_inside(p, united(surface_of(block), surface_of(cavity, true))) == inside);
}

RC_GTEST_PROP(ClosedSurfaceAgreement, RationalPointsAreAskedAsDoublesAre, ()) {
  const ClosedSurface surface = united(surface_of(draw_solid()), surface_of(draw_solid(), true));
  const Point3 p = draw_point(3);
  RC_ASSERT(is_strictly_inside(p, surface) == encloses(surface, gnomon::exact(p)));
  RC_CLASSIFY(is_strictly_inside(p, surface));
}

TEST(ClosedSurfaceDegenerate, RayAlongEdgesThroughVerticesAndPlanesIsCountedOnce) {
  const ClosedSurface octahedron =
      surface_of(ConvexSolid::hull_of({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}));
  EXPECT_TRUE(is_strictly_inside({0, 0, 0}, octahedron));
  EXPECT_TRUE(is_strictly_inside({-0.5, 0, 0.25}, octahedron));
  EXPECT_FALSE(is_strictly_inside({-2, 0, 0}, octahedron));
  EXPECT_FALSE(is_strictly_inside({-2, 0, 1}, octahedron));
  EXPECT_FALSE(is_strictly_inside({1, 0, 0}, octahedron));
}

}  // namespace
}  // namespace gnomon
