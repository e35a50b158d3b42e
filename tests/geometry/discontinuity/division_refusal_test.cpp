#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gnomon/errors.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon {
namespace {

using testing::HasSubstr;

ConvexPolygon triangle(double size, double lift = 0) {
  return ConvexPolygon::from_points({{0, 0, 0}, {size, 0, 0}, {size, size, lift}, {0, size, 0}});
}

TEST(DivisionRefusal, TellsLightsThatAreNotFlat) {
  const ConvexPolygon rounded = triangle(1, 1e-12);
  ASSERT_FALSE(rounded.is_flat());
  EXPECT_THAT(division_refusal(AreaLight{rounded}), HasSubstr("not exactly coplanar"));
  EXPECT_EQ(division_refusal(AreaLight{triangle(1)}), "");
}

TEST(DivisionRefusal, TellsLightsInsideOfAClosedMesh) {
  const ClosedSurface tetrahedron{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}},
                                  {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  EXPECT_THAT(division_refusal(PointLight{{1, 1, 1}}, {&tetrahedron, 1}), HasSubstr("inside a closed mesh"));
  EXPECT_EQ(division_refusal(PointLight{{4, 4, 4}}, {&tetrahedron, 1}), "");
  EXPECT_EQ(division_refusal(DirectionalLight{{0, 0, -1}}, {&tetrahedron, 1}), "");
}

TEST(DivisionRefusal, TellsCoordinatesOutOfRangeAndTheDivisionRefusesThem) {
  for (const double size : {0x1p-201, 0x1p201}) {
    EXPECT_THAT(range_refusal(triangle(size).points()), HasSubstr("2^-200"));
    EXPECT_THAT(range_refusal(DirectionalLight{{0, 0, -size}}), HasSubstr("2^-200"));
    EXPECT_THAT(range_refusal(LinearLight{{0, 0, 1}, {0, size, 1}}), HasSubstr("2^-200"));
    const ConvexPolygon floor = triangle(size);
    EXPECT_THROW(ReceiverDivision(PointLight{{0, 0, 1}}, {}, {&floor, 1}), PreconditionError);
  }
  EXPECT_EQ(range_refusal(triangle(0x1p-200).points()), "");
  EXPECT_EQ(range_refusal(PointLight{{0, -0x1p200, 1}}), "");
}

}  // namespace
}  // namespace gnomon
