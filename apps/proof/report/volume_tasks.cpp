#include "apps/proof/report/volume_tasks.h"

#include <cmath>

#include "apps/proof/report/vectors.h"
#include "apps/proof/report/volume_peers.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon::report {
namespace {

/// So wide that only the floor at z = -4 cuts the volumes.
constexpr Box3 box{{-999, -998, -4}, {997, 999, 99}};
constexpr ShadowParts surfaces{.penumbra = false, .cells = false, .planes = false, .volumes = false};
constexpr ShadowParts with_volumes{.penumbra = false, .cells = false, .planes = false, .volumes = true};

double volume_of(const VolumeMesh& mesh) {
  double sum = 0;
  for (const MeshTriangle& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t k) { return mesh.vertices[triangle.vertices[k]]; };
    sum += dot(corner(0), cross(corner(1), corner(2)));
  }
  return sum / 6;
}

using Way = std::function<double()>;

/// `way` is timed; `value` is the volume that it finds.
Measurement measured(const std::string& task, const std::string& method, std::size_t n, double truth, Effort effort,
                     const Way& value, const Way& way) {
  Measurement result;
  result.task = task;
  result.method = method;
  result.size = n;
  result.errors.add(std::fabs(value() / truth - 1), truth);
  result.errors.finish();
  volatile double used = 0;
  result.bytes = memory_growth([&] { used = way(); });
  const Care care = effort == Effort::quick ? Care{3, 0.002} : Care{5, 0.02};
  result.seconds = time_per_result([&] { used = used + way(); }, 1, care);
  return result;
}

std::vector<Measurement> volume_measurements(std::uint32_t n, Effort effort) {
  const PolygonPair pair = generic_pair(n);
  const ConvexBlocker blocker = pair.blocker;
  const auto meshes = [&](const ShadowParts& parts) { return shadow_meshes(pair.light, blocker, box, parts); };
  const ShadowMeshes exact = meshes(with_volumes);
  const double occlusion = exact.occlusion.volume.nearest, umbra = exact.umbra.volume.nearest;
  const auto occluded = [&](const char* method, const Way& value, const Way& way) {
    return measured("occlusion_volume", method, n, occlusion, effort, value, way);
  };
  const auto dark = [&](const char* method, const Way& way) {
    return measured("umbra_volume", method, n, umbra, effort, way, way);
  };
  const Way exactly = [&] { return meshes(with_volumes).occlusion.volume.nearest; };
  const Way by_mesh = [&] { return volume_of(meshes(surfaces).occlusion); };
  const Way by_hull = [&] { return static_cast<double>(facets_of_vertex_shadow_hull(pair)); };
  std::vector<Measurement> all = {occluded("exact", exactly, exactly), occluded("gnomon", by_mesh, by_mesh),
                                  occluded(
                                      "convex_hull_3", [&] { return volume_of_vertex_shadow_hull(pair); }, by_hull),
                                  dark("exact", [&] { return meshes(with_volumes).umbra.volume.nearest; }),
                                  dark("gnomon", [&] { return volume_of(meshes(surfaces).umbra); })};
  // Nef polyhedra take most of a second for 16 vertices, and twenty times as long for four times as many.
  if (n <= (effort == Effort::quick ? 4U : 16U))
    all.push_back(dark("nef_3", [&] { return volume_of_nef_umbra(pair); }));
  return all;
}

}  // namespace

std::vector<Task> volume_tasks(Effort effort) {
  const std::vector<std::uint32_t> sizes =
      effort == Effort::quick ? std::vector<std::uint32_t>{3, 4, 16} : std::vector<std::uint32_t>{3, 4, 8, 16, 64, 128};
  std::vector<Task> tasks;
  for (const std::uint32_t n : sizes) {
    tasks.push_back({std::to_string(n) + " vertices", [=] { return volume_measurements(n, effort); }});
  }
  return tasks;
}

}  // namespace gnomon::report
