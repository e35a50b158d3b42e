#include "shading/illumination/group_meshes.h"

#include <map>
#include <utility>

#include "geometry/parallel.h"

namespace gnomon::illumination {
namespace {

/// One group of receivers as it is meshed, and the meshes made of it.
class GroupMeshes {
 public:
  GroupMeshes(const Refinement& refined, LightsTogether& lights, unsigned threads)
      : refined_(refined), lights_(lights), threads_(threads) {}

  void write(std::span<const std::uint32_t> receivers, std::vector<IlluminationMesh>& meshes) {
    for (std::uint32_t t = 0; t < refined_.states().size(); ++t) add_face(t, meshes[refined_.receiver_of(t)]);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
    for (const std::uint32_t r : receivers) {
      for (std::uint32_t i = 0; i < meshes[r].points.size(); ++i) all.emplace_back(r, i);
      meshes[r].irradiance.resize(meshes[r].points.size());
      meshes[r].of_lights.assign(lights_.size(), std::vector<Irradiance>(meshes[r].points.size()));
    }
    for_all(all.size(), threads_, [&](std::size_t k, std::size_t worker) {
      const auto& [r, i] = all[k];
      const std::vector<Irradiance> found = lights_.each(worker, r, asked_[r][i]);
      for (std::size_t l = 0; l < found.size(); ++l) meshes[r].of_lights[l][i] = found[l];
      meshes[r].irradiance[i] = total_irradiance(found);
    });
  }

 private:
  std::uint32_t point(std::uint32_t triangle, std::size_t node, IlluminationMesh& mesh) {
    const std::uint32_t receiver = refined_.receiver_of(triangle), place = refined_.place_of(triangle, node);
    const auto fresh = static_cast<std::uint32_t>(mesh.points.size());
    if (!refined_.states()[triangle].is_own[node]) {
      const auto [found, is_new] = shared_.try_emplace({receiver, place}, fresh);
      if (!is_new) return found->second;
    }
    mesh.points.push_back(refined_.mesh().points()[place]);
    asked_[receiver].push_back(refined_.asked_at(triangle, node));
    return fresh;
  }

  void add_face(std::uint32_t triangle, IlluminationMesh& mesh) {
    const TriangleState& state = refined_.states()[triangle];
    const HalvingTriangle& t = refined_.mesh().triangles()[triangle];
    IlluminationFace face{{}, {}, state.error, state.is_met};
    for (std::size_t k = 0; k < 3; ++k) face.corners[k] = point(triangle, k, mesh);
    for (std::size_t k = 3; k < refined_.nodes(); ++k) face.middles[k - 3] = point(triangle, k, mesh);
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_told = t.orders[k] < smooth && (t.beyond[k] == none || triangle < t.beyond[k]);
      if (is_told) mesh.edges.push_back({{face.corners[k], face.corners[(k + 1) % 3]}, t.orders[k]});
    }
    mesh.faces.push_back(face);
  }

  const Refinement& refined_;
  LightsTogether& lights_;
  unsigned threads_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> shared_;
  std::map<std::uint32_t, std::vector<Point3>> asked_;  ///< of each receiver's points, where they were asked for
};

}  // namespace

void write_meshes(const Refinement& refined, LightsTogether& lights, unsigned threads,
                  std::span<const std::uint32_t> receivers, std::vector<IlluminationMesh>& meshes) {
  GroupMeshes(refined, lights, threads).write(receivers, meshes);
}

}  // namespace gnomon::illumination
