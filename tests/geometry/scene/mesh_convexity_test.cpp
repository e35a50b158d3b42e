#include "geometry/scene/mesh_convexity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gnomon/scene.h"

namespace gnomon {
namespace {

/// The cube [0, 1]³ with its facets as squares, and a vertex that no facet has.
Mesh cube() {
  Mesh mesh{"cube.obj", {}, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}, true};
  for (unsigned i = 0; i < 8; ++i) mesh.vertices.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  mesh.vertices.push_back({9, 9, 9});
  return mesh;
}

TEST(MeshConvexity, OfACubeItIsExact) {
  EXPECT_EQ(deviation_from_convex(cube().vertices, cube().facets), 0);
}

TEST(MeshConvexity, DoesNotAskWhichWayFacetsRun) {
  Mesh mesh = cube();
  for (auto& facet : mesh.facets) std::reverse(facet.begin(), facet.end());
  EXPECT_EQ(deviation_from_convex(mesh.vertices, mesh.facets), 0);
}

/// A square that is bent along the diagonal from its first corner, inward by `dent`.
std::optional<double> dented(double dent) {
  Mesh mesh = cube();
  mesh.vertices[7] = {1, 1, 1 - dent};
  mesh.facets[1] = {5, 7, 6, 4};
  return deviation_from_convex(mesh.vertices, mesh.facets);
}

TEST(MeshConvexity, DentsUpToANanometrePerMetreOfItsDiameterAreRounding) {
  const double limit = 1e-9 * std::sqrt(3.0);
  EXPECT_NEAR(dented(-1e-10).value(), 1e-10, 1e-10);
  EXPECT_TRUE(dented(-0.9 * limit));
  EXPECT_FALSE(dented(-4 * limit));
  EXPECT_FALSE(dented(-0.1));
}

TEST(MeshConvexityDegenerate, AFlatMeshAndTwoShellsAreNoSolid) {
  const std::vector<Point3> triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::vector<std::uint32_t>> both = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_FALSE(deviation_from_convex(triangle, both));
  Mesh mesh = cube();
  const Mesh inner = cube();
  for (const Point3& p : inner.vertices) mesh.vertices.push_back({(p.x + 1) / 3, (p.y + 1) / 3, (p.z + 1) / 3});
  for (auto facet : inner.facets) {
    for (std::uint32_t& i : facet) i += 9;
    std::reverse(facet.begin(), facet.end());
    mesh.facets.push_back(facet);
  }
  EXPECT_FALSE(deviation_from_convex(mesh.vertices, mesh.facets));
}

TEST(MeshConvexity, AConvexMeshIsOnePartOfTheVerticesInItsFacets) {
  Mesh mesh = cube();
  EXPECT_EQ(convex_parts({"box", mesh}).size(), 6U);
  EXPECT_TRUE(enclosed_space({"box", mesh}));
  mesh.dents = 0;
  const auto parts = convex_parts({"box", mesh});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].name, "box");
  EXPECT_EQ(std::get<ConvexSolid>(parts[0].shape).points().size(), 8U);
  EXPECT_FALSE(enclosed_space({"box", mesh}));
  // With dents it is the hull for volumes alone.
  mesh.dents = 1e-10;
  EXPECT_EQ(convex_parts({"box", mesh}, PartsFor::volumes).size(), 1U);
  EXPECT_EQ(convex_parts({"box", mesh}).size(), 6U);
  EXPECT_TRUE(enclosed_space({"box", mesh}));
}

}  // namespace
}  // namespace gnomon
