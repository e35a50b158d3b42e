#include "gnomon/light_parts.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "apps/proof/laws/definition.h"
#include "apps/proof/laws/exact.h"
#include "apps/proof/laws/visibility_definition.h"
#include "gnomon/errors.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;

/// A part with its area, which is a whole number.
struct KnownPart {
  AreaLight light;
  int area = 0;
};

/// A rectangle at right angles to an axis, its front towards larger coordinates or smaller ones.
KnownPart rectangle(std::size_t axis, int at, std::array<int, 2> low, std::array<int, 2> high, bool up) {
  const auto corner = [&](int u, int v) {
    std::array<double, 3> p{};
    p[axis] = at;
    p[(axis + 1) % 3] = u;
    p[(axis + 2) % 3] = v;
    return Point3{p[0], p[1], p[2]};
  };
  std::vector<Point3> points{corner(low[0], low[1]), corner(high[0], low[1]), corner(high[0], high[1]),
                             corner(low[0], high[1])};
  if (!up) std::swap(points[1], points[3]);
  return {AreaLight{ConvexPolygon::from_points(points)}, (high[0] - low[0]) * (high[1] - low[1])};
}

/// The letter L, its front downwards.
std::vector<KnownPart> letter(Dice& dice) {
  const int x = dice.draw(-3, 3), y = dice.draw(-3, 3), w = dice.draw(1, 3), h = dice.draw(1, 3);
  return {rectangle(2, 6, {x, y}, {x + w, y + h + 2}, false), rectangle(2, 6, {x + w, y}, {x + w + 2, y + h}, false)};
}

/// The faces of a box, seen from outside.
std::vector<KnownPart> box(Dice& dice) {
  std::array<int, 3> low{}, high{};
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = dice.draw(-2, 2);
    high[k] = low[k] + dice.draw(1, 3);
  }
  std::vector<KnownPart> parts;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    for (const bool up : {false, true}) {
      parts.push_back(rectangle(k, up ? high[k] : low[k], {low[u], low[v]}, {high[u], high[v]}, up));
    }
  }
  return parts;
}

/// What the definition says: of the parts that show the point their front, in rational numbers.
struct Defined {
  Region region = Region::unlit;
  Rational fraction = 0;
};

Defined defined(const std::vector<KnownPart>& parts, const std::vector<ConvexBlocker>& blockers, const Point3& p) {
  std::vector<laws::Walls> walls;
  for (const ConvexBlocker& blocker : blockers) walls.push_back(laws::walls(blocker));
  Rational visible = 0;
  int area = 0;
  for (const KnownPart& part : parts) {
    const Light light = part.light;
    if (laws::is_unlit(light, laws::exact(p))) continue;
    area += part.area;
    visible += part.area * laws::visible_area_share(laws::vertices(light), walls, laws::exact(p));
  }
  if (area == 0) return {};
  const Rational f = visible / area;
  return {f == 0 ? Region::umbra : f == 1 ? Region::lit : Region::penumbra, f};
}

std::vector<Light> shapes(const std::vector<KnownPart>& parts) {
  std::vector<Light> lights;
  for (const KnownPart& part : parts) lights.emplace_back(part.light);
  return lights;
}

void check_against_definition(std::vector<KnownPart> (*draw)(Dice&)) {
  std::array<int, 4> met{};
  EXPECT_TRUE(rc::check("parts act as one light", [&] {
    Dice dice;
    const std::vector<KnownPart> parts = draw(dice);
    const auto at = [&](int reach) {
      return Point3{1.0 * dice.draw(-reach, reach), 1.0 * dice.draw(-reach, reach), 1.0 * dice.draw(-reach, reach)};
    };
    std::vector<ConvexBlocker> blockers;
    while (blockers.size() < 2) {
      const std::vector<Point3> triangle = {at(5), at(5), at(5)};
      if (!ConvexPolygon::defect(triangle)) blockers.emplace_back(ConvexPolygon::from_points(triangle));
    }
    PartsVisibility seen(shapes(parts), PreparedObstacles({blockers, {}}));
    for (int i = 0; i < 5; ++i) {
      const Point3 p = at(7);
      const Defined expected = defined(parts, blockers, p);
      const Visibility found = seen.at(p);
      ++met[static_cast<std::size_t>(expected.region)];
      RC_ASSERT(name(found.region) == name(expected.region));
      RC_ASSERT(abs(Rational(Rational(found.fraction) - expected.fraction)) <= Rational(found.error_bound));
      RC_ASSERT(found.before_receiver == (expected.region == Region::unlit ? 0 : 1));
    }
  }));
  for (const Region region : {Region::lit, Region::penumbra, Region::umbra}) {
    EXPECT_GT(met[static_cast<std::size_t>(region)], 0) << name(region);
  }
}

TEST(PartsVisibilityAgreement, OfAConcaveLightIsTheDefinitionInRationalNumbers) {
  check_against_definition(letter);
}

TEST(PartsVisibilityAgreement, OfABoxThatShinesOutwardIsTheDefinitionInRationalNumbers) {
  check_against_definition(box);
}

TEST(PartsVisibility, CountsBeforeAReceiverWhatLiesBeforeItsPlane) {
  const std::vector<Light> parts{rectangle(2, 4, {0, 0}, {2, 1}, false).light,
                                 rectangle(2, 4, {-2, 0}, {0, 1}, false).light};
  PartsVisibility seen(parts, PreparedObstacles({{}, {}}));
  const Visibility wall = seen.received({{0, 0, 0}, FacingNormal{{1, 0, 0}}});
  EXPECT_EQ(wall.region, Region::lit);
  EXPECT_NEAR(wall.before_receiver, 0.5, 1e-15);
  EXPECT_EQ(wall.fraction, wall.before_receiver);
  EXPECT_EQ(seen.received({{0, 0, 0}, FacingNormal{{0, 0, -1}}}).region, Region::unlit);
}

TEST(PartsVisibility, OfOneLightIsThatOfTheLight) {
  const ConvexPolygon board = ConvexPolygon::from_points({{0, -9, 1}, {9, -9, 1}, {9, 9, 1}, {0, 9, 1}});
  const PreparedObstacles obstacles({{board}, {}});
  for (const Light& light : {Light(LinearLight{{-1, 0, 2}, {2, 0, 2}}), Light(PointLight{{1, 0, 2}})}) {
    EXPECT_EQ(PartsVisibility({light}, obstacles).at({0, 0, 0}), LightVisibility(light, obstacles).at({0, 0, 0}));
  }
}

TEST(PartsVisibility, RefusesPartsThatAreNoFlatPolygons) {
  const PreparedObstacles none({{}, {}});
  EXPECT_THROW(PartsVisibility({}, none), PreconditionError);
  EXPECT_THROW(PartsVisibility({PointLight{{0, 0, 1}}, PointLight{{0, 0, 2}}}, none), PreconditionError);
}

}  // namespace
}  // namespace gnomon
