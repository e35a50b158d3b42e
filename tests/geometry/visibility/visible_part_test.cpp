#include "geometry/visibility/visible_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/visibility_cases.h"
#include "apps/proof/laws/visibility_definition.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::draw;
using laws::LightKind;
using laws::VisibilityCase;
using testing::IsEmpty;
using testing::SizeIs;

VisiblePart part_of(const VisibilityCase& drawn) {
  std::vector<std::vector<HidingCondition>> hidden;
  for (const ConvexBlocker& blocker : drawn.blockers) hidden.push_back(hiding_conditions(blocker, exact(drawn.point)));
  return visible_part(drawn.light, hidden, exact(drawn.point));
}

bool is_hidden(const VisibilityCase& drawn, const laws::ExactVector& l) {
  return std::any_of(drawn.blockers.begin(), drawn.blockers.end(), [&](const ConvexBlocker& blocker) {
    return laws::is_blocked(laws::walls(blocker), laws::exact(drawn.point), l);
  });
}

laws::ExactVector in_laws(const ExactVector& v) {
  return {v.x, v.y, v.z};
}

/// A point inside: a mean of the vertices with drawn weights, none of them 0. Odd parts keep it off the lines on which
/// a contact without area hides single points.
ExactVector draw_inside(const ExactPolygon& polygon) {
  ExactVector sum;
  Rational weights = 0;
  int odd = 1009;
  for (const ExactVector& v : polygon) {
    const Rational weight = draw(1, 50) + Rational(1, odd += 26);
    sum = sum + weight * v;
    weights += weight;
  }
  return Rational(1 / weights) * sum;
}

/// -1, 0, +1: strictly inside a convex polygon of the same plane, on its boundary, outside.
int side_of(const ExactPolygon& polygon, const ExactVector& l) {
  const ExactVector normal = doubled_area(polygon);
  int result = -1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactVector& a = polygon[i];
    const Rational turn = dot(cross(polygon[(i + 1) % polygon.size()] - a, l - a), normal);
    result = std::max(result, turn > 0 ? -1 : turn == 0 ? 0 : 1);
  }
  return result;
}

void check_pieces(const VisibilityCase& drawn) {
  for (const VisibleFacet& seen : part_of(drawn).facets) {
    for (const ExactPolygon& piece : seen.visible) {
      RC_ASSERT(dot(doubled_area(piece), doubled_area(seen.facet)) > 0);
      RC_ASSERT(!is_hidden(drawn, in_laws(draw_inside(piece))));
    }
    for (int k = 0; k < 4; ++k) {
      const ExactVector l = draw_inside(seen.facet);
      const auto in = [&](int side) {
        return std::ranges::count_if(seen.visible, [&](const auto& piece) { return side_of(piece, l) == side; });
      };
      RC_ASSERT(in(-1) <= 1);
      if (in(0) == 0) RC_ASSERT(is_hidden(drawn, in_laws(l)) == (in(-1) == 0));
    }
  }
}

const std::vector<BlockerKind> every_blocker = {BlockerKind::polygon, BlockerKind::solid, BlockerKind::rounded_polygon};

RC_GTEST_PROP(VisiblePartProperty, PiecesOfAnAreaLightAreDisjointAndHoldWhatIsNotHidden, ()) {
  const Domain domain = laws::once_in(2) ? Domain::near_degenerate : Domain::random;
  check_pieces(*laws::visibility_cases(domain, {{LightKind::polygon, LightKind::rounded_polygon}, every_blocker, 4}));
}

RC_GTEST_PROP(VisiblePartProperty, IntervalsOfALinearLightAreDisjointAndHoldWhatIsNotHidden, ()) {
  const Domain domain = laws::once_in(2) ? Domain::near_degenerate : Domain::random;
  const VisibilityCase drawn = *laws::visibility_cases(domain, {{LightKind::segment}, every_blocker, 4});
  const auto& light = std::get<LinearLight>(drawn.light);
  const laws::ExactVector start = laws::exact(light.start), step = laws::exact(light.end) - start;
  Rational last = 0;
  for (const auto& [from, to] : part_of(drawn).intervals) {
    RC_ASSERT(last <= from);
    RC_ASSERT(from < to);
    RC_ASSERT(to <= 1);
    RC_ASSERT(!is_hidden(drawn, start + Rational(from + (to - from) * draw(1, 99) / 100) * step));
    if (last < from) RC_ASSERT(is_hidden(drawn, start + Rational(last + (from - last) * draw(1, 99) / 100) * step));
    last = to;
  }
  if (last < 1) RC_ASSERT(is_hidden(drawn, start + Rational(last + (1 - last) * draw(1, 99) / 100) * step));
}

// Positions by name. The lamp is the square [-1, 1]^2 at height 4 that shines downward.

Light lamp(bool two_sided = false) {
  return AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}}), two_sided};
}

ConvexPolygon square(double half, double z) {
  return ConvexPolygon::from_points({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
}

ConvexSolid cube(const Point3& least, double side) {
  std::vector<Point3> points;
  for (unsigned i = 0; i < 8; ++i) {
    points.push_back({least.x + side * (i & 1), least.y + side * (i >> 1 & 1), least.z + side * (i >> 2)});
  }
  return ConvexSolid::hull_of(points);
}

Region region(const Light& light, const std::vector<ConvexBlocker>& blockers, const Point3& p) {
  return part_of({light, blockers, p}).region;
}

TEST(VisiblePart, PointOnAFlatBlockerSeesBothSides) {
  EXPECT_EQ(region(lamp(), {square(2, 1)}, {0, 0, 1}), Region::lit);
  EXPECT_EQ(region(PointLight{{0, 0, -3}}, {square(2, 1)}, {0.5, 0, 1}), Region::lit);
  EXPECT_EQ(region(DirectionalLight{{0, 0, -1}}, {square(2, 1)}, {2, 2, 1}), Region::lit);
  // Along the blocker it sees nothing.
  EXPECT_EQ(region(PointLight{{3, 0, 1}}, {square(2, 1)}, {0.5, 0, 1}), Region::umbra);
  EXPECT_EQ(region(PointLight{{3, 0, 1}}, {square(2, 1)}, {2, 0, 1}), Region::lit);
}

TEST(VisiblePart, PointInsideASolidSeesNothing) {
  EXPECT_EQ(region(lamp(), {cube({0, 0, 0}, 1)}, {0.5, 0.5, 0.5}), Region::umbra);
  EXPECT_EQ(region(PointLight{{0.5, 0.5, 0.5}}, {cube({0, 0, 0}, 1)}, {0.5, 0.5, 0.5}), Region::umbra);
  EXPECT_EQ(region(lamp(), {cube({-2, -2, 3}, 4)}, {0, 0, 4.5}), Region::unlit);
}

TEST(VisiblePart, PointOnASolidSeesWhatIsAboveItsFacets) {
  const ConvexSolid solid = cube({-1, -1, 0}, 2);
  EXPECT_EQ(region(lamp(), {solid}, {0, 0, 2}), Region::lit);
  EXPECT_EQ(region(lamp(), {solid}, {0, 0, 0}), Region::umbra);
  EXPECT_EQ(region(lamp(), {solid}, {1, 0, 1}), Region::umbra);
  EXPECT_EQ(region(lamp(), {solid}, {1, 1, 2}), Region::lit);
  EXPECT_EQ(region(PointLight{{5, 0, 2}}, {solid}, {0, 0, 2}), Region::umbra);
  EXPECT_EQ(region(PointLight{{5, 0, 2}}, {solid}, {1, 0, 2}), Region::lit);
  EXPECT_EQ(region(PointLight{{5, 1, 2}}, {solid}, {1, 1, 2}), Region::lit);
  EXPECT_EQ(region(PointLight{{1, 0, 2}}, {solid}, {1, 0, 2}), Region::lit);
  const Light beside = AreaLight{ConvexPolygon::from_points({{0, -1, 4}, {0, 1, 4}, {3, 1, 4}, {3, -1, 4}})};
  EXPECT_EQ(region(beside, {solid}, {1, 0, 0.5}), Region::penumbra);
}

TEST(VisiblePart, LightsPlaneAndBackAreUnlit) {
  EXPECT_EQ(region(lamp(), {}, {3, 0, 4}), Region::unlit);
  EXPECT_EQ(region(lamp(), {}, {0, 0, 5}), Region::unlit);
  EXPECT_EQ(region(lamp(true), {}, {0, 0, 5}), Region::lit);
  EXPECT_EQ(region(lamp(true), {}, {0, 0, 4}), Region::unlit);
  EXPECT_THAT(part_of({lamp(), {}, {0, 0, 5}}).facets, IsEmpty());
}

TEST(VisiblePart, FlushBlockersBehindAndBesideTheLightHideNothing) {
  EXPECT_EQ(region(lamp(), {square(5, 4)}, {0, 0, 0}), Region::lit);
  EXPECT_EQ(region(lamp(), {square(5, 5)}, {0, 0, 0}), Region::lit);
  EXPECT_EQ(region(lamp(), {square(5, -1)}, {0, 0, 0}), Region::lit);
  // On a facet of a solid that faces the point; half sunk in; inside.
  EXPECT_EQ(region(lamp(), {cube({-2, -2, 4}, 4)}, {0, 0, 0}), Region::lit);
  EXPECT_EQ(region(lamp(), {cube({0, -2, 2}, 4)}, {0, 0, 0}), Region::penumbra);
  EXPECT_EQ(region(lamp(), {cube({-2, -2, 2}, 4)}, {0, 0, 0}), Region::umbra);
}

TEST(VisiblePart, BlockerThatCrossesTheLightHidesWhatIsBehindIt) {
  const ConvexPolygon wall = ConvexPolygon::from_points({{0, -2, 3}, {0, 2, 3}, {0, 2, 5}, {0, -2, 5}});
  EXPECT_EQ(region(lamp(), {wall}, {0, 0, 0}), Region::lit);
  const VisiblePart part = part_of({lamp(), {wall}, {4, 0, 0}});
  EXPECT_EQ(part.region, Region::penumbra);
  ASSERT_THAT(part.facets, SizeIs(1));
  // The wall's lower edge is seen at x = -4/3, beyond the lamp: all of x < 0 is hidden.
  Rational area = 0;
  for (const ExactPolygon& piece : part.facets[0].visible) area += abs(doubled_area(piece).z);
  EXPECT_EQ(area, 4);
}

TEST(VisiblePart, GrazingContactHidesPointsAndDirectionsAndNothingElse) {
  EXPECT_EQ(region(PointLight{{0, 0, 4}}, {square(1, 2)}, {2, 0, 0}), Region::umbra);
  EXPECT_EQ(region(PointLight{{0, 0, 4}}, {square(1, 2)}, {2, 2, 0}), Region::umbra);
  EXPECT_EQ(region(DirectionalLight{{0, 0, -1}}, {square(1, 2)}, {1, 1, 0}), Region::umbra);
  EXPECT_EQ(region(lamp(), {square(1, 2)}, {3, 0, 0}), Region::lit);
  EXPECT_EQ(region(lamp(), {square(1, 2)}, {2, 1, 0}), Region::penumbra);
  EXPECT_EQ(region(LinearLight{{0, -1, 4}, {0, 1, 4}}, {square(1, 2)}, {2, 3, 0}), Region::lit);
  // An edge coplanar with a linear light and the point hides a length.
  EXPECT_EQ(region(LinearLight{{0, -1, 4}, {0, 1, 4}}, {square(1, 2)}, {2, 0, 0}), Region::umbra);
  // An edge-on square hides from an area light nothing, from a linear light in its plane much.
  const ConvexPolygon upright = ConvexPolygon::from_points({{-1, 0, 1}, {1, 0, 1}, {1, 0, 2}, {-1, 0, 2}});
  EXPECT_EQ(region(lamp(), {upright}, {0, 0, 0}), Region::lit);
  EXPECT_EQ(region(LinearLight{{-1, 0, 4}, {1, 0, 4}}, {upright}, {0, 0, 0}), Region::umbra);
}

}  // namespace
}  // namespace gnomon
