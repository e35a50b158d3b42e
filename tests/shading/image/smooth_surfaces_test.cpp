#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shading/image/facet_shading.h"
#include "shading/image/vertex_normals.h"

namespace gnomon::image {
namespace {

constexpr double pi = std::numbers::pi;

/// The sides of a cylinder of radius 1 about z, from z = -1 to 1; one facet's middle is at angle 0.
std::vector<Facet> cylinder(int sides, const Material& material) {
  std::vector<Facet> facets;
  const auto corner = [&](int k, double z) {
    const double angle = (2 * (k % sides) - 1) * pi / sides;  // one number for one corner
    return Point3{std::cos(angle), std::sin(angle), z};
  };
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * k * pi / sides;
    const ConvexPolygon side =
        ConvexPolygon::from_points({corner(k, -1), corner(k + 1, -1), corner(k + 1, 1), corner(k, 1)});
    facets.push_back({side, {std::cos(angle), std::sin(angle), 0}, {}, 0, std::uint32_t(k), {}, &material, {}});
  }
  return facets;
}

/// A scene of one sun, as [Ph73] has it: light and eye far away.
struct FarAway {
  SpaceScene scene;
  Material material;
  std::vector<Facet> facets;
  ShadedScene shaded;
  WorkersLights lights;

  FarAway(int sides, VertexNormals normals, const Material& made_of, const Point3& to_light, const Point3& eye)
      : material(made_of), shaded{scene, PreparedObstacles({}), {}, eye} {
    scene.lights.push_back({"sun", DirectionalLight{{-to_light.x, -to_light.y, -to_light.z}}, pi});
    facets = cylinder(sides, material);
    add_vertex_normals(facets, {normals});
    shaded.lights.push_back(&scene.lights[0]);
    lights.emplace_back(scene.lights[0], shaded.obstacles, ImageOptions{});
  }

  /// Halfway up the first facet, at an angle from its middle; of a facet that is flat or not.
  double at(ShadingMode mode, double share) {
    FacetShading shading(shaded, facets, mode);
    // On the diagonal's triangle 0, 1, 2: the lower border from corner 0 to 1.
    const auto& p = facets[0].shape.points();
    const Point3 place{p[0].x, p[0].y + share * (p[1].y - p[0].y), -1};
    return shading.at({0, 0, true, place, {1 - share, share, 0}}, lights).radiance[0].value;
  }
};

/// Worst errors of diffuse light from straight before a facet: flat and Gouraud's are 1 - cos(pi/N), less by normals.
struct Cylinder {
  int sides;
  double gouraud, phong;
};

class DiffuseCylinder : public ::testing::TestWithParam<Cylinder> {};

/// Places along the facet stand for equal parts of the arc.
double worst_error(int sides, ShadingMode mode) {
  const Material white{.diffuse = {1, 1, 1}};
  double worst = 0;
  FarAway scene(sides, VertexNormals::equal, white, {1, 0, 0}, {100, 0, -1});
  for (int s = 0; s <= 256; ++s) {
    const double share = s / 256.0, angle = (2 * share - 1) * pi / sides;
    worst = std::max(worst, std::fabs(scene.at(mode, share) - std::cos(angle)));
  }
  return worst;
}

TEST_P(DiffuseCylinder, IsShadedAsWronglyAsThePictures) {
  const auto [sides, gouraud, phong] = GetParam();
  EXPECT_NEAR(worst_error(sides, ShadingMode::flat), gouraud, 0.02 * gouraud);
  EXPECT_NEAR(worst_error(sides, ShadingMode::gouraud), gouraud, 0.02 * gouraud);
  EXPECT_NEAR(worst_error(sides, ShadingMode::phong), phong, 0.05 * phong);
}

INSTANTIATE_TEST_SUITE_P(Sides, DiffuseCylinder,
                         ::testing::Values(Cylinder{4, .293, .034}, Cylinder{8, .0761, .0020},
                                           Cylinder{12, .0341, 3.9e-4}, Cylinder{16, .0192, 1.2e-4}));

TEST(Gouraud, IsTheMeanOfTheCornersByTheirShares) {
  const Material white{.diffuse = {1, 1, 1}};
  FarAway scene(8, VertexNormals::equal, white, {1, 0.5, 0}, {100, 0, -1});
  const double first = scene.at(ShadingMode::gouraud, 0), second = scene.at(ShadingMode::gouraud, 1);
  EXPECT_GT(second, first + 0.1);
  EXPECT_NEAR(scene.at(ShadingMode::gouraud, 0.25), 0.75 * first + 0.25 * second, 1e-14);
}

/// A highlight in the middle of a facet that faces light and eye is 1; Gouraud has what the corners have.
TEST(Highlight, IsLostByGouraudAndKeptByNormals) {
  const std::array<std::array<double, 3>, 5> expected = {
      {{8, .25, 2e-10}, {12, .56, 1e-4}, {16, .73, .0063}, {32, .93, .29}, {64, .98, .73}}};
  for (const auto& [sides, of_4, of_64] : expected) {
    for (const int n : {4, 64}) {
      const Material metal{
          .diffuse = {0, 0, 0}, .specular = {1 / pi, 0, 0}, .exponent = n, .model = ReflectionModel::phong_classic};
      FarAway scene(int(sides), VertexNormals::equal, metal, {1, 0, 0}, {1e6, 0, -1});
      const double gouraud = scene.at(ShadingMode::gouraud, 0.5), value = n == 4 ? of_4 : of_64;
      EXPECT_NEAR(gouraud, value, std::fmax(0.03 * value, 5e-11)) << sides << ' ' << n;
      EXPECT_NEAR(scene.at(ShadingMode::phong, 0.5), 1, 1e-6);
    }
  }
}

/// Three faces of a cube, one cut by a diagonal: equal weights turn the normal by 19.47 degrees, angles do not.
TEST(VertexNormals, OfACubesCornerDependOnTheWeights) {
  const auto corner_normal = [](const Smoothness& how) {
    std::vector<Facet> facets;
    const auto add = [&](const std::vector<Point3>& p, const Point3& n) {
      facets.push_back({ConvexPolygon::from_points(p), n, {}, 0, 0, {}, nullptr, nullptr});
    };
    add({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {0, 0, 1});
    add({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 0, 1});
    add({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, {1, 0, 0});
    add({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, {0, 1, 0});
    EXPECT_EQ(add_vertex_normals(facets, how), 0u);
    return facets[0].vertex_normals[0];
  };
  const auto off = [](const Point3& n) { return std::acos(std::fmin((n.x + n.y + n.z) / std::sqrt(3), 1)) * 180 / pi; };
  EXPECT_NEAR(off(corner_normal({VertexNormals::equal})), 19.47, 0.01);
  EXPECT_NEAR(off(corner_normal({VertexNormals::angle})), 0, 1e-5);
  EXPECT_NEAR(off(corner_normal({VertexNormals::area})), 0, 1e-5);
  EXPECT_EQ(corner_normal({VertexNormals::angle, 60}), (Point3{0, 0, 1})) << "a crease";
}

TEST(VertexNormals, ThatCancelLeaveTheFacetFlat) {
  std::vector<Facet> facets;
  const std::vector<Point3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  facets.push_back({ConvexPolygon::from_points(p), {0, 0, 1}, {}, 0, 0, {}, nullptr, nullptr});
  facets.push_back({ConvexPolygon::from_points({p[0], p[2], p[1]}), {0, 0, -1}, {}, 0, 1, {}, nullptr, nullptr});
  EXPECT_EQ(add_vertex_normals(facets, {VertexNormals::equal}), 2u);
  EXPECT_TRUE(facets[0].vertex_normals.empty());
}

}  // namespace
}  // namespace gnomon::image
