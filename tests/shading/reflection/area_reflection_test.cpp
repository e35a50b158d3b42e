#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "gnomon/reflection.h"
#include "tests/shading/reflection/definition_oracle.h"
#include "tests/shading/reflection/drawn_views.h"

namespace gnomon {
namespace {

using namespace test_support;

struct PolygonCase {
  std::vector<Point3> corners;
  View view;
  int exponent = 0;
};

std::string told(const PolygonCase& c) {
  std::ostringstream text;
  text << std::hexfloat;
  for (const Point3& p : c.corners) text << " {" << p.x << ", " << p.y << ", " << p.z << "}";
  for (const Point3& p : {c.view.point, c.view.normal, c.view.to_eye}) {
    text << " / {" << p.x << ", " << p.y << ", " << p.z << "}";
  }
  text << ' ' << c.exponent;
  return text.str();
}

/// A triangle or parallelogram, whose corners are exactly in one plane, and a point before it.
PolygonCase drawn_polygon(Dice& dice) {
  constexpr std::array exponents = {0, 1, 2, 3, 5, 10, 11, 32, 50, 64};
  PolygonCase c;
  c.exponent = dice.one_of(exponents);
  const auto grid = [&] {
    return Point3{dice.draw(-40, 40) / 16.0, dice.draw(-40, 40) / 16.0, dice.draw(0, 64) / 16.0};
  };
  const Point3 a = grid(), b = grid(), d = grid();
  c.corners = {a, b, d};
  if (dice.once_in(2)) c.corners = {a, b, added(b, 1, added(d, -1, a)), d};
  c.view.point = {between(dice, -1, 1), between(dice, -1, 1), between(dice, -3, 0.5)};
  const Point3 towards = added(added(a, 0.3, added(b, -1, a)), 1, added({0, 0, 0}, -1, c.view.point));
  c.view.normal = added(drawn_vector(dice), dice.draw(0, 2), towards);
  c.view.to_eye =
      dice.once_in(3) ? drawn_vector(dice) : added(mirrored(towards, c.view.normal), 0.3, drawn_vector(dice));
  return c;
}

/// A triangle, as rounded corners of more are not in one plane.
void make_tiny(PolygonCase& c) {
  c.corners.resize(3);
  for (std::size_t k = 1; k < 3; ++k) c.corners[k] = added(c.corners[0], 1e-7, added(c.corners[k], -1, c.corners[0]));
}

/// With small integers; a corner or an edge lies in the horizon, R's plane, or on R.
PolygonCase bent_polygon(Dice& dice) {
  PolygonCase c = drawn_polygon(dice);
  c.view.point = {double(dice.draw(-2, 2)), double(dice.draw(-2, 2)), double(dice.draw(-3, 0))};
  c.view.normal = {double(dice.draw(-1, 1)), double(dice.draw(-1, 1)), double(dice.draw(0, 2))};
  c.view.to_eye = {double(dice.draw(-2, 2)), double(dice.draw(-2, 2)), double(dice.draw(0, 2))};
  const Point3 corner = added(c.corners[0], -1, c.view.point), next = added(c.corners[1], -1, c.view.point);
  switch (dice.draw(0, 7)) {
    case 0:
      c.view.to_eye = mirrored(corner, c.view.normal);
      break;  // R through a corner
    case 1:
      c.view.to_eye = mirrored(added(corner, 0.5, next), c.view.normal);
      break;  // or an edge
    case 2:
      c.view.normal = {corner.y, -corner.x, 0};
      break;  // horizon through a corner
    case 3:
      c.view.normal = added({corner.y * next.z - corner.z * next.y, corner.z * next.x - corner.x * next.z,
                             corner.x * next.y - corner.y * next.x},
                            0, corner);
      break;  // along an edge
    case 4:
      c.view.to_eye = {-c.view.normal.y, c.view.normal.x, 1e-6};
      break;  // a grazing eye
    case 5:
      make_tiny(c);
      break;
    case 6:
      c.view.to_eye = added({0, 0, 0}, -1, corner);
      break;  // the eye opposite to a corner
    default:
      break;
  }
  return c;
}

double volume(const PolygonCase& c) {
  const Point3 a = added(c.corners[0], -1, c.view.point), b = added(c.corners[1], -1, c.corners[0]),
               d = added(c.corners[2], -1, c.corners[0]);
  return a.x * (b.y * d.z - b.z * d.y) + a.y * (b.z * d.x - b.x * d.z) + a.z * (b.x * d.y - b.y * d.x);
}

bool has_sense(PolygonCase& c) {
  if (c.view.normal == Point3{} || c.view.to_eye == Point3{} || std::fabs(volume(c)) < 0x1p-60) return false;
  return !ConvexPolygon::defect(c.corners) && product(c.view.normal, c.view.to_eye) > 0;
}

double length(const Point3& a) {
  return std::sqrt(product(a, a));
}

/// What the quadrature may lose with 64 bits: up to 40,000 nodes, the area of a sliver, and where it cuts a tiny light.
long double slack_of(const PolygonCase& c) {
  const Point3 a = added(c.corners[1], -1, c.corners[0]), b = added(c.corners[2], -1, c.corners[0]);
  const Point3 area{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return 4e-16L + 4e-19L * length(a) * length(b) / length(area) + 2e-18L / length(a) + 2e-18L / length(b);
}

struct Tally {
  int tried = 0, positive = 0, unsure = 0;
};

void expect_within_bound(const PolygonCase& c, ReflectionModel model, Tally& tally) {
  const Integrated<long double> exact = integrated_polygon(c.corners, c.view, model, c.exponent);
  ++tally.tried;
  if (!exact.is_certain) {
    ++tally.unsure;
    return;
  }
  tally.positive += exact.lobe > 1e-9L * exact.across;
  const AreaLight light{ConvexPolygon::from_points(c.corners), true};
  const Reflection r = LightReflection(light, PreparedObstacles({})).at(c.view, model, c.exponent);
  const long double slack = slack_of(c) * exact.across;
  ASSERT_LE(std::fabs(exact.received - r.received.value), r.received.error_bound + slack)
      << told(c) << ": " << r.received.value << " for " << exact.received;
  ASSERT_LE(std::fabs(exact.lobe - r.lobe.value), r.lobe.error_bound + slack)
      << told(c) << " model " << static_cast<int>(model) << ": " << r.lobe.value << " +- " << r.lobe.error_bound
      << " for " << exact.lobe;
  ASSERT_LE(r.received.error_bound, 1.01e-9L * exact.across) << told(c);
  ASSERT_LE(r.lobe.error_bound, 1.01e-9L * exact.across) << told(c) << " model " << static_cast<int>(model);
}

class AreaReflectionAgreement : public ::testing::TestWithParam<ReflectionModel> {
 protected:
  Tally compare(std::uint32_t seed, int count, PolygonCase (*draw)(Dice&)) {
    Dice dice(seed);
    Tally tally;
    while (tally.tried - tally.unsure < (GNOMON_LONG ? 20 : 1) * count && !HasFatalFailure()) {
      PolygonCase c = draw(dice);
      if (has_sense(c)) expect_within_bound(c, GetParam(), tally);
    }
    return tally;
  }
};

TEST_P(AreaReflectionAgreement, BoundsHoldTheIntegralOfTheDefinition) {
  const Tally tally = compare(31, 500, drawn_polygon);
  EXPECT_GT(tally.positive, 250);
  EXPECT_LT(tally.unsure, tally.tried / 10);
}

TEST_P(AreaReflectionAgreement, BoundsHoldWhereCornersHorizonAndEyeAreInSpecialPosition) {
  const Tally tally = compare(32, 500, bent_polygon);
  EXPECT_GT(tally.positive, 150);
  EXPECT_LT(tally.unsure, tally.tried / 5);
}

INSTANTIATE_TEST_SUITE_P(Models, AreaReflectionAgreement, ::testing::ValuesIn(all_models));

}  // namespace
}  // namespace gnomon
