#include "apps/proof/report/receiver_tasks.h"

#include <array>
#include <cmath>

#include "apps/proof/report/draws.h"
#include "apps/proof/report/embree_visibility.h"
#include "apps/proof/report/shapes.h"
#include "gnomon/receiver_mesh.h"
#include "gnomon/visibility.h"
#include "shading/receiver_grid.h"

namespace gnomon::report {
namespace {

/// Shares of the floor: lit, penumbra, umbra.
using Shares = std::array<double, 3>;

/// Shares by the exact mesh. What it leaves unresolved is penumbra or umbra: it is counted as the first, and so much
/// may both be off.
struct MeshShares {
  Shares shares{};
  double unresolved = 0;
};

struct FloorScene {
  AreaLight light = square_light(1, 4);
  std::vector<ConvexBlocker> blockers;
  std::vector<ConvexPolygon> receivers = {ConvexPolygon::from_points({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}})};
};

FloorScene floor_scene(std::size_t boards) {
  FloorScene scene;
  Draws draws(boards);
  for (std::size_t i = 0; i < boards; ++i) {
    const double x = draws.between(-1.5, 0.5), y = draws.between(-1.5, 0.5), z = draws.between(0.5, 2.5);
    scene.blockers.push_back(board(x, x + draws.between(0.5, 1.5), y, y + draws.between(0.5, 1.5), z));
  }
  return scene;
}

MeshShares shares_of_mesh(const FloorScene& scene) {
  const ReceiverDivision division(scene.light, scene.blockers, scene.receivers);
  const ReceiverMesh mesh = division.mesh(0);
  const auto areas = mesh.areas();
  const double whole = mesh.area().nearest;
  const double unresolved = areas[static_cast<std::size_t>(ReceiverRegion::unresolved_eee)].nearest;
  return {{areas[0].nearest / whole, (areas[1].nearest + unresolved) / whole, areas[2].nearest / whole},
          unresolved / whole};
}

template <class RegionAt>
Shares shares_of_raster(const FloorScene& scene, std::uint32_t k, RegionAt region_at) {
  const ReceiverGrid grid(scene.receivers[0], {k, k});
  Shares shares{};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    shares[static_cast<std::size_t>(region_at(grid.point(i)))] += 1 / static_cast<double>(grid.size());
  }
  return shares;
}

Measurement measured(const std::string& method, std::size_t boards, std::size_t samples, const Shares& truth,
                     Effort effort, const std::function<Shares()>& way) {
  Measurement result;
  result.task = "receiver_areas";
  result.method = method;
  result.size = boards;
  result.samples = samples;
  Shares found{};
  result.bytes = memory_growth([&] { found = way(); });
  for (std::size_t k = 0; k < found.size(); ++k) result.errors.add(std::fabs(found[k] - truth[k]), truth[k]);
  result.errors.finish();
  const Care care = effort == Effort::quick ? Care{3, 0} : Care{5, 0.02};
  result.seconds = time_per_result([&] { way(); }, 1, care);
  return result;
}

std::vector<Measurement> receiver_measurements(std::size_t boards, Effort effort) {
  const FloorScene scene = floor_scene(boards);
  const auto [truth, unresolved] = shares_of_mesh(scene);
  std::vector<Measurement> all = {
      measured("exact_mesh", boards, 0, truth, effort, [&] { return shares_of_mesh(scene).shares; })};
  all.front().errors.bound = unresolved;
  LightVisibility gnomon(scene.light, PreparedObstacles({scene.blockers, {}}));
  EmbreeVisibility embree(scene.light, scene.blockers);
  embree.place(Placing::regular, 4);
  for (std::uint32_t k = 16; k <= (effort == Effort::quick ? 64U : 512U); k *= 2) {
    const auto by_gnomon = [&] {
      return shares_of_raster(scene, k, [&](const Point3& p) { return gnomon.at(p).region; });
    };
    const auto by_embree = [&] {
      return shares_of_raster(scene, k, [&](const Point3& p) { return embree.visible_from(p, {0, 0, 1}).region; });
    };
    all.push_back(measured("gnomon_raster", boards, std::size_t{k} * k, truth, effort, by_gnomon));
    all.push_back(measured("embree_raster", boards, std::size_t{k} * k, truth, effort, by_embree));
  }
  return all;
}

}  // namespace

std::vector<Task> receiver_tasks(Effort effort) {
  const std::vector<std::size_t> sizes =
      effort == Effort::quick ? std::vector<std::size_t>{1, 4} : std::vector<std::size_t>{1, 2, 4, 8};
  std::vector<Task> tasks;
  for (const std::size_t n : sizes) {
    tasks.push_back({std::to_string(n) + " boards", [=] { return receiver_measurements(n, effort); }});
  }
  return tasks;
}

}  // namespace gnomon::report
