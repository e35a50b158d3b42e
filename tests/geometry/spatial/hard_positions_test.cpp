#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "geometry/numbers/kernel.h"
#include "gnomon/pair.h"
#include "gnomon/scene.h"
#include "gnomon/shadow_mesh.h"
#include "gnomon/visibility.h"
#include "tests/geometry/spatial/expected_region.h"

// The volumes of every pair of the named hard positions: one ulp off degenerate ones, far away with fine detail,
// needles.
namespace gnomon {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> hard_scenes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(GNOMON_TEST_DATA "/scenes/hard")) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Point3> light_vertices(const Light& light) {
  if (const auto* direction = std::get_if<DirectionalLight>(&light)) {
    const auto& [x, y, z] = direction->direction;
    return {{-8 * x, -8 * y, -8 * z}};
  }
  if (const auto* point = std::get_if<PointLight>(&light)) return {point->position};
  if (const auto* line = std::get_if<LinearLight>(&light)) return {line->start, line->end};
  const auto points = std::get<AreaLight>(light).polygon.points();
  return {points.begin(), points.end()};
}

/// Points on lines through a light vertex and a blocker vertex: on the boundaries of the volumes, up to rounding.
std::vector<Point3> boundary_points(const Light& light, const ConvexBlocker& blocker) {
  const auto corners = std::visit([](const auto& shape) { return shape.points(); }, blocker);
  std::vector<Point3> points;
  for (const Point3& l : light_vertices(light)) {
    for (const Point3& b : corners) {
      for (const double s : {0.5, 2.0}) {
        points.push_back({b.x + s * (b.x - l.x), b.y + s * (b.y - l.y), b.z + s * (b.z - l.z)});
        points.push_back({std::nextafter(points.back().x, HUGE_VAL), points.back().y, points.back().z});
      }
    }
  }
  return points;
}

void check_points(const Light& light, const ConvexBlocker& blocker) {
  const ShadowVolumes volumes = shadow_volumes(light, blocker);
  const Obstacles obstacles{{blocker}, {}};
  std::vector<Point3> points = boundary_points(light, blocker);
  if (points.size() > 120) points.resize(120);
  for (const Point3& p : points) {
    if (is_on_blocker(blocker, p)) continue;
    const Region seen = exact_visibility(light, obstacles, p).region;
    const std::optional<Region> expected = expected_region(light, volumes, p);
    if (seen == Region::unlit || !expected) continue;
    EXPECT_EQ(name(*expected), name(seen)) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

void check_meshes(const Light& light, const ConvexBlocker& blocker, const Box3& box) {
  const ShadowMeshes meshes = shadow_meshes(light, blocker, box);
  const auto volume = [](const VolumeMesh& mesh) { return Rational(mesh.volume.exact); };
  const Rational sum = volume(meshes.umbra) + volume(meshes.penumbra);
  EXPECT_EQ(volume(meshes.occlusion), sum);
  for (const VolumeMesh* mesh : {&meshes.occlusion, &meshes.umbra, &meshes.penumbra, &meshes.umbra_pockets}) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const MeshTriangle& triangle : mesh->triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++edges[{triangle.vertices[i], triangle.vertices[(i + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
  }
}

TEST(VolumesDegenerate, EveryNamedHardPositionAgreesWithTheDefinitionAndHasClosedMeshes) {
  for (const fs::path& file : hard_scenes()) {
    SCOPED_TRACE(file.filename().string());
    const auto scene = std::get<SpaceScene>(read_scene(file.string()));
    const std::optional<Box3> box = default_clip_box(scene);
    ASSERT_TRUE(box);
    for (const SceneLight& light : scene.lights) {
      for (const SceneBlocker& blocker : scene.blockers) {
        for (const ConvexPart& part : convex_parts(blocker)) {
          if (!pair_refusal(light.shape, part.shape).empty()) continue;
          check_points(light.shape, part.shape);
          check_meshes(light.shape, part.shape, *box);
        }
      }
    }
  }
}

ConvexPolygon circle(std::uint32_t corners, double radius, double height, double turn) {
  std::vector<Point3> points;
  for (std::uint32_t k = 0; k < corners; ++k) {
    const double angle = turn * 2 * std::numbers::pi * k / corners;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
  }
  return ConvexPolygon::from_points(points);
}

TEST(VolumesDegenerate, PolygonsOfTenThousandVerticesHaveClosedMeshes) {
  const Light light = AreaLight{circle(10000, 0.7, 4, -1)};
  const ConvexBlocker blocker = circle(9999, 1.1, 2, 1);
  const ShadowMeshes meshes = shadow_meshes(light, blocker, {{-9, -9, -9}, {9, 9, 5}},
                                            {.penumbra = false, .cells = false, .planes = false, .volumes = false});
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const MeshTriangle& triangle : meshes.umbra.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{triangle.vertices[i], triangle.vertices[(i + 1) % 3]}];
  }
  EXPECT_GT(edges.size(), 9999U);
  for (const auto& [edge, count] : edges) ASSERT_EQ(edges.count({edge.second, edge.first}), 1U);
}

}  // namespace
}  // namespace gnomon
