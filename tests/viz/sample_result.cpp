#include "tests/viz/sample_result.h"

#include <array>
#include <utility>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {
namespace {

constexpr double top = 2;
constexpr double bottom = -1;

ConvexPolygon square(double half, double z) {
  return ConvexPolygon::from_points({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
}

/// The corners of a square, counterclockwise seen from above.
void add_corners(std::vector<Point3>& points, double half, double z) {
  const ConvexPolygon corners = square(half, z);
  points.insert(points.end(), corners.points().begin(), corners.points().end());
}

void add_quadrangle(VolumeMesh& mesh, const std::array<std::uint32_t, 4>& corners, FacetName name) {
  const auto facet = static_cast<std::uint32_t>(mesh.facets.size());
  mesh.facets.push_back(name);
  mesh.triangles.push_back({{corners[0], corners[1], corners[2]}, facet});
  mesh.triangles.push_back({{corners[0], corners[2], corners[3]}, facet});
}

/// A frustum from the blocker down to the box: vertices 0 to 3 on top, 4 to 7 at the bottom.
VolumeMesh frustum(double lower_half, FacetKind sides) {
  VolumeMesh mesh;
  add_corners(mesh.vertices, 1, top);
  add_corners(mesh.vertices, lower_half, bottom);
  add_quadrangle(mesh, {0, 1, 2, 3}, {FacetKind::blocker_face});
  add_quadrangle(mesh, {7, 6, 5, 4}, {FacetKind::clip_box, 4});
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    add_quadrangle(mesh, {i, i + 4, next + 4, next}, {sides, static_cast<std::int32_t>(i), 0});
  }
  mesh.truncated = true;
  return mesh;
}

/// Vertices 0 to 3 on top, 4 to 7 outside and 8 to 11 inside at the bottom.
VolumeMesh ring(double outer_half, double inner_half) {
  VolumeMesh mesh;
  add_corners(mesh.vertices, 1, top);
  add_corners(mesh.vertices, outer_half, bottom);
  add_corners(mesh.vertices, inner_half, bottom);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    const auto edge = static_cast<std::int32_t>(i);
    add_quadrangle(mesh, {i, i + 4, next + 4, next}, {FacetKind::separating_blocker_plane, edge, 0});
    add_quadrangle(mesh, {next, next + 8, i + 8, i}, {FacetKind::supporting_blocker_plane, edge, 0});
    add_quadrangle(mesh, {i + 4, i + 8, next + 8, next + 4}, {FacetKind::clip_box, 4});
  }
  mesh.truncated = true;
  return mesh;
}

VolumeCells::Cell frustum_cell() {
  return {{{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}};
}

/// One wedge per side of the ring, in the numbers of ring().
VolumeCells ring_cells(const VolumeMesh& mesh) {
  VolumeCells cells;
  cells.vertices = mesh.vertices;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t n = (i + 1) % 4;
    cells.cells.push_back({{{i, i + 4, n + 4, n},
                            {n, n + 8, i + 8, i},
                            {i + 4, i + 8, n + 8, n + 4},
                            {i, i + 8, i + 4},
                            {n, n + 4, n + 8}}});
  }
  return cells;
}

ShadowMeshes sample_meshes() {
  ShadowMeshes meshes;
  meshes.occlusion = frustum(13.0 / 4, FacetKind::separating_blocker_plane);
  meshes.umbra = frustum(7.0 / 4, FacetKind::supporting_blocker_plane);
  meshes.penumbra = ring(13.0 / 4, 7.0 / 4);
  meshes.occlusion.volume = {59.25, "237/4"};
  meshes.umbra.volume = {23.25, "93/4"};
  meshes.penumbra.volume = {36, "36"};
  meshes.umbra_cells = {meshes.umbra.vertices, {frustum_cell()}};
  meshes.penumbra_cells = ring_cells(meshes.penumbra);
  meshes.extremal_planes.push_back(
      {{FacetKind::separating_blocker_plane, 0, 2}, {{-4, -1, 2}, {4, -1, 2}, {4, -3.25, -1}, {-4, -3.25, -1}}});
  meshes.extremal_planes.push_back({{FacetKind::supporting_blocker_plane, 0, 0}, {}});
  return meshes;
}

}  // namespace

SampleResult::SampleResult(const std::string& light, const std::string& blocker) {
  auto& scene = scene_.emplace<SpaceScene>();
  scene.source = "sample.scene.json";
  const ConvexPolygon lamp =
      ConvexPolygon::from_points({{-0.5, -0.5, 4}, {-0.5, 0.5, 4}, {0.5, 0.5, 4}, {0.5, -0.5, 4}});
  scene.lights.push_back({light, AreaLight{lamp}, 1});
  scene.blockers.push_back({blocker, square(1, top)});
  scene.blockers.push_back({"post", Polytope{{{3, 3, 0}, {3.5, 3, 0}, {3, 3.5, 0}, {3, 3, 1}, {3.1, 3.1, 0.1}}}});
  scene.receivers.push_back({"floor", square(4, 0)});
  result_.scene = &scene_;
  result_.clip_box = {{-5, -5, bottom}, {5, 5, 5}};

  PairResult pair;
  pair.light = light;
  pair.blocker = blocker;
  pair.position = Position::standard;
  pair.supported = true;
  pair.meshes = sample_meshes();
  pair.volumes.occlusion_facts = {false, false, 1};
  pair.volumes.umbra_facts = {false, false, 1};
  pair.volumes.penumbra_facts = {false, false, 1};
  result_.pairs.push_back(pair);

  std::vector<ConvexBlocker> parts;
  for (const SceneBlocker& whole : scene.blockers) {
    for (ConvexPart& part : convex_parts(whole)) parts.push_back(std::move(part.shape));
  }
  const std::vector<ConvexPolygon> receivers = {scene.receivers[0].shape};
  result_.receivers.push_back(
      {0, 0, light, "floor", receiver_division(scene.lights[0].shape, parts, receivers).front()});

  PairResult unsupported;
  unsupported.light = light;
  unsupported.blocker = "post";
  unsupported.blocker_id = 1;
  result_.pairs.push_back(unsupported);
}

void remove_umbra(ShadowResult& result) {
  result.receivers.clear();
  for (PairResult& pair : result.pairs) {
    pair.meshes.umbra = {};
    pair.meshes.umbra_cells = {};
    pair.volumes.umbra_facts = {};
  }
}

}  // namespace gnomon
