#include "gnomon/shadow_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/numbers/kernel.h"

namespace gnomon {
namespace {

/// The side on which the exact coefficients of all half-spaces see a point.
Side side_by_coefficients(const ConvexVolume& volume, const Point3& p) {
  Side side = Side::inside;
  for (const HalfSpace& half_space : volume.half_spaces) {
    const auto [a, b, c, d] = plane_coefficients(half_space);
    const Rational value = Rational(a.exact) * Rational(p.x) + Rational(b.exact) * Rational(p.y) +
                           Rational(c.exact) * Rational(p.z) + Rational(d.exact);
    if (value > 0) return Side::outside;
    if (value == 0) side = Side::boundary;
  }
  return side;
}

const Light lights[] = {
    AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}})},
    AreaLight{ConvexPolygon::from_points({{0.1, -0.3, 5}, {-0.7, 1.1, 5.5}, {1.3, 0.9, 4.5}}), true},
    LinearLight{{-1, 0.25, 4}, {2, 0.5, 6}}, PointLight{{0.1, 0.2, 4}}, DirectionalLight{{0.1, -0.3, -1}}};
const ConvexBlocker coefficient_blockers[] = {
    ConvexPolygon::from_points({{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}),
    ConvexPolygon::from_points({{0.1, 0.1, 1}, {1.7, -0.2, 2}, {0.3, 1.9, 1.5}}),
    ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {1, 1, 1}})};

TEST(PlaneCoefficients, AreNegativeJustWhereTheHalfSpaceIs) {
  std::mt19937 random(19);
  const auto coordinate = [&] { return static_cast<double>(random() % 33) / 4 - 4; };
  int boundaries = 0;
  for (const Light& light : lights) {
    for (const ConvexBlocker& blocker : coefficient_blockers) {
      const ShadowVolumes shadow = shadow_volumes(light, blocker);
      for (int i = 0; i < 400; ++i) {
        const Point3 p = i % 8 == 0 ? shadow.occlusion.half_spaces[static_cast<std::size_t>(i) % 3].plane[0]
                                    : Point3{coordinate(), coordinate(), coordinate()};
        for (const ConvexVolume* volume : {&shadow.occlusion, &shadow.umbra}) {
          if (volume->empty) continue;
          const Side side = volume->oriented_side(p);
          EXPECT_EQ(side_by_coefficients(*volume, p), side);
          boundaries += side == Side::boundary ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(boundaries, 100);
}

TEST(PlaneCoefficients, AreCorrectlyRounded) {
  const HalfSpace half_space{{FacetKind::blocker_face}, {Point3{0, 0, 0.1}, {1, 0, 0.1}, {0, 3, 0.1}}, false};
  const auto [a, b, c, d] = plane_coefficients(half_space);
  EXPECT_EQ(a.exact, "0");
  EXPECT_EQ(c.exact, "3");
  EXPECT_EQ(d.nearest, -3 * 0.1);
  EXPECT_EQ(Rational(d.exact), -3 * Rational(0.1));
}

TEST(PlaneCoefficientsDegenerate, OfHugeAndTinyPlanesAreMultipliedByOnePowerOfTwo) {
  for (const double size : {1e200, 1e307, 1e-200, 1e-300}) {
    const HalfSpace half_space{
        {FacetKind::blocker_face}, {Point3{0, 0, size}, {size, 0, size}, {0, 3 * size, size}}, false};
    const auto [a, b, c, d] = plane_coefficients(half_space);
    EXPECT_EQ(a.exact, "0");
    EXPECT_TRUE(std::isnormal(c.nearest)) << size;
    EXPECT_EQ(Rational(d.exact), -Rational(c.exact) * Rational(size));
    const int exponent = std::ilogb(std::max(std::abs(c.nearest), std::abs(d.nearest)));
    EXPECT_TRUE(exponent == -1 || exponent == 0 || exponent == 1) << size << ": " << exponent;
  }
}

}  // namespace
}  // namespace gnomon
