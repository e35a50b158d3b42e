#include <algorithm>
#include <array>
#include <cmath>

#include "apps/proof/report/draws.h"
#include "apps/proof/report/shadow_bsp.h"
#include "apps/proof/report/tables.h"
#include "geometry/visibility/shadow_tree.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon::report {
namespace {

using BoxFacet = std::vector<Point3>;

/// The six faces of a box on the floor, seen from outside: a corner, two sides of its base, its height.
void add_box(const Point3& at, const Point3& u, const Point3& v, double height, std::vector<BoxFacet>& facets) {
  const auto corner = [&](int i, int j, double z) {
    return Point3{at.x + i * u.x + j * v.x, at.y + i * u.y + j * v.y, z};
  };
  const std::array<std::array<int, 2>, 4> round = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  BoxFacet top, bottom;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [i, j] = round[k];
    const auto [m, n] = round[(k + 1) % 4];
    facets.push_back({corner(i, j, 0), corner(m, n, 0), corner(m, n, height), corner(i, j, height)});
    top.push_back(corner(i, j, height));
    bottom.insert(bottom.begin(), corner(i, j, 0));
  }
  facets.push_back(top);
  facets.push_back(bottom);
}

struct Boxes {
  AreaLight lamp;
  std::vector<ConvexPolygon> facets;  ///< six of each box
  std::vector<ConvexBlocker> boxes;
  ConvexPolygon floor;
};

Boxes boxes_scene() {
  std::vector<BoxFacet> facets;
  add_box({1.5, 5.5, 0}, {3, 0, 0}, {0, 2.5, 0}, 1, facets);
  add_box({7, 6, 0}, {1.5, 2, 0}, {-2, 1.5, 0}, 4, facets);
  add_box({5.5, 2, 0}, {1.5, 0, 0}, {0, 1.5, 0}, 1.5, facets);
  Boxes scene{{ConvexPolygon::from_points({{3.5, 3.5, 8}, {3.5, 5.5, 8}, {5.5, 5.5, 8}, {5.5, 3.5, 8}})},
              {},
              {},
              ConvexPolygon::from_points({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}})};
  for (std::size_t first = 0; first < facets.size(); first += 6) {
    BoxFacet corners = facets[first + 4];
    corners.insert(corners.end(), facets[first + 5].begin(), facets[first + 5].end());
    scene.boxes.push_back(ConvexSolid::hull_of(corners));
  }
  for (BoxFacet& facet : facets) scene.facets.push_back(ConvexPolygon::from_points(std::move(facet)));
  return scene;
}

std::vector<Point3> places_in_room(Effort effort) {
  Draws draws(1);
  std::vector<Point3> points;
  for (int i = effort == Effort::quick ? 200 : 2000; i > 0; --i) {
    const double x = draws.between(0, 10), y = draws.between(0, 10);
    points.push_back({x, y, draws.between(0, 8)});
  }
  return points;
}

/// Of the facets that face a part of the lamp.
BspRow volume_row(const std::string& tree, const Boxes& scene, VolumeMesh ShadowMeshes::*volume,
                  const std::vector<Point3>& points) {
  constexpr Box3 around{{-50, -50, -50}, {60, 60, 60}};
  constexpr ShadowParts surfaces{.penumbra = false, .cells = false, .planes = false, .volumes = false};
  ShadowBsp bsp;
  BspRow row{tree};
  for (const ConvexPolygon& facet : scene.facets) {
    const auto is_before = [&](const Point3& p) {
      const Point3 &a = facet.points()[0], &b = facet.points()[1], &c = facet.points()[2];
      return dot(cross(step(a, b), step(a, c)), step(a, p)) > 0;
    };
    if (std::ranges::none_of(scene.lamp.polygon.points(), is_before)) continue;
    const ShadowMeshes meshes = shadow_meshes(scene.lamp, ConvexBlocker(facet), around, surfaces);
    if ((meshes.*volume).triangles.empty()) continue;
    bsp.add(meshes.*volume);
    ++row.volumes;
  }
  row.nodes = static_cast<double>(bsp.nodes());
  row.height = static_cast<double>(bsp.height());
  for (const Point3& p : points) row.path += static_cast<double>(bsp.path(p)) / static_cast<double>(points.size());
  return row;
}

/// The mean over lights that are points of the lamp.
BspRow point_row(const Boxes& scene, const std::vector<Point3>& points) {
  BspRow row{"point visibility (mean of 25 shadow trees)"};
  for (int i = 0; i < 25; ++i) {
    const ShadowTree tree(PointLight{{3.6 + 0.45 * (i % 5), 3.6 + 0.45 * (i / 5), 8}}, scene.boxes);
    row.nodes += static_cast<double>(tree.node_count()) / 25;
    row.height += static_cast<double>(tree.height()) / 25;
    for (const Point3& p : points) {
      row.path += static_cast<double>(tree.tests(p)) / (25 * static_cast<double>(points.size()));
    }
  }
  row.volumes = scene.boxes.size();
  return row;
}

}  // namespace

BoxesResult boxes_trees(Effort effort) {
  const Boxes scene = boxes_scene();
  const std::vector<Point3> points = places_in_room(effort);
  BoxesResult result;
  result.trees = {volume_row("occlusion", scene, &ShadowMeshes::occlusion, points),
                  volume_row("umbra", scene, &ShadowMeshes::umbra, points), point_row(scene, points)};
  std::vector<ConvexPolygon> receivers = scene.facets;
  receivers.push_back(scene.floor);
  for (const ReceiverMesh& mesh : receiver_division(Light(scene.lamp), scene.boxes, receivers)) {
    result.faces += mesh.faces().size();
  }
  result.receivers = receivers.size();
  return result;
}

std::string boxes_section(const BoxesResult& result) {
  if (result.trees.empty()) return {};
  const std::array<std::array<const char*, 3>, 3> printed = {
      {{"395", "17", "12.7"}, {"97", "13", "3.1"}, {"51", "10", "1.8"}}};
  std::vector<Row> table = {{"tree", "volumes", "nodes", "height", "planes on a point's path", "printed nodes",
                             "printed height", "printed kilobytes"}};
  for (std::size_t k = 0; k < result.trees.size(); ++k) {
    const BspRow& row = result.trees[k];
    table.push_back({row.tree, std::to_string(row.volumes), short_text(row.nodes), short_text(row.height),
                     short_text(row.path), printed[k][0], printed[k][1], printed[k][2]});
  }
  const std::vector<Row> seconds = {{"step of [CF91], Figure 28", "seconds", "share"},
                                    {"visibility classification", "9.82", "5.4 %"},
                                    {"occluder culling", "4.82", "2.7 %"},
                                    {"source occlusion, optimisation", "140.78", "77.4 %"},
                                    {"shading, optimisation", "10.06", "5.5 %"},
                                    {"source occlusion, final", "13.30", "7.3 %"},
                                    {"shading, final", "2.47", "1.4 %"},
                                    {"T-vertices", "0.58", "0.3 %"},
                                    {"all", "181.83", "100 %"}};
  return "\n## Figures 28 and 29 of [CF91]: trees of shadow volumes\n\n"
         "The scene Boxes is lost but for its 20 polygons; here it is three boxes on a floor under a square lamp. "
         "Trees of\n"
         "occlusion and umbra are built of all facets that face a part of the lamp, in their order, in plain doubles "
         "with "
         "a\ntolerance: a peer that tells whether some of the lamp, or all of it, is hidden by one blocker, and no "
         "more. The\n"
         "volume trees printed are larger, which is not explained. Printed numbers are odd, as inner nodes and leaves "
         "of "
         "full\nbinary trees are. What gnomon keeps instead is the exact division of all " +
         std::to_string(result.receivers) + " receivers behind all blockers\ntogether, in " +
         std::to_string(result.faces) + " faces, and a hierarchy of boxes for points.\n\n" + markdown_table(table) +
         "\nFor 219 faces on a computer of 1991; eleven times as many points were looked at to place faces as to shade "
         "them:\n\n" +
         markdown_table(seconds) + "\n";
}

}  // namespace gnomon::report
