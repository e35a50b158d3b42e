#include "geometry/numbers/orientation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "apps/proof/laws/draw.h"
#include "geometry/numbers/kernel.h"

namespace gnomon {
namespace {

/// The sign from the definition, in rational arithmetic.
int oracle(const std::array<Point3, 4>& p) {
  const auto difference = [&](std::size_t i, double Point3::*c) {
    return Rational(Rational(p[i].*c) - Rational(p[0].*c));
  };
  const Rational det =
      CGAL::determinant<Rational>(difference(1, &Point3::x), difference(1, &Point3::y), difference(1, &Point3::z),
                                  difference(2, &Point3::x), difference(2, &Point3::y), difference(2, &Point3::z),
                                  difference(3, &Point3::x), difference(3, &Point3::y), difference(3, &Point3::z));
  return CGAL::sign(det);
}

int filtered(const std::array<Point3, 4>& p) {
  OrientationFilter filter;
  filter.include(p);
  filter.close();
  return filter(p[0], p[1], p[2], p[3]);
}

int beside_plane(const std::array<Point3, 4>& p) {
  OrientationFilter filter;
  filter.include(p);
  filter.close();
  return filter.plane(p[0], p[1], p[2]).side(p[3]);
}

/// Four points near a common plane: the last is a combination of the others, rounded, and now and then nudged.
std::array<Point3, 4> draw_nearly_coplanar(double scale) {
  std::array<Point3, 4> p;
  const auto coordinate = [&] { return laws::draw(-99, 99) * scale / laws::draw(1, 9); };
  for (Point3& q : p) {
    const double x = coordinate();
    const double y = coordinate();
    q = {x, y, coordinate()};
  }
  const double s = laws::draw(-9, 9) / 7.0;
  const double t = laws::draw(-9, 9) / 7.0;
  const auto combine = [&](double Point3::*c) { return p[0].*c + s * (p[1].*c - p[0].*c) + t * (p[2].*c - p[0].*c); };
  p[3] = {combine(&Point3::x), combine(&Point3::y), combine(&Point3::z)};
  if (laws::once_in(2)) p[3].z = std::nextafter(p[3].z, HUGE_VAL);
  return p;
}

TEST(OrientationAgreement, FilterMatchesRationalDeterminantNearTies) {
  for (const double scale : {1.0, 0x1p-40, 1e40, 1e-70, 1e80, 1e150, 0x1p-1060}) {
    EXPECT_TRUE(rc::check("scaled", [scale] {
      const std::array<Point3, 4> p = draw_nearly_coplanar(scale);
      RC_ASSERT(filtered(p) == oracle(p));
      RC_ASSERT(beside_plane(p) == oracle(p));
    })) << scale;
  }
}

TEST(OrientationDegenerate, HugeAndTinyCoordinatesAreDecidedExactly) {
  const std::array<Point3, 4> huge = {{{-1e308, 0, 0}, {1e308, 0, 0}, {0, 1e308, 0}, {0, 0, 1e-308}}};
  EXPECT_EQ(filtered(huge), oracle(huge));
  EXPECT_EQ(beside_plane(huge), oracle(huge));
  const std::array<Point3, 4> tiny = {{{0, 0, 0}, {5e-324, 0, 0}, {0, 5e-324, 0}, {0, 0, -5e-324}}};
  EXPECT_EQ(filtered(tiny), -1);
  EXPECT_EQ(beside_plane(tiny), -1);
  EXPECT_EQ(oracle(tiny), -1);
}

TEST(OrientationAgreement, SeenCounterclockwiseIsPositive) {
  EXPECT_EQ(exact_orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(exact_orientation({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
  EXPECT_EQ(exact_orientation({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {5, 7, 0}), 0);
}

}  // namespace
}  // namespace gnomon
