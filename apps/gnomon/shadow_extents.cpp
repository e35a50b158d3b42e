#include "apps/gnomon/shadow_extents.h"

namespace gnomon {
namespace {

std::array<ShadowExtent, 3> spatial_extents(const PairResult& pair) {
  const ShadowVolumes& volumes = pair.volumes;
  const ShadowMeshes& meshes = pair.meshes;
  return {{{"occlusion", volumes.occlusion_facts, meshes.occlusion.volume.nearest},
           {"umbra", volumes.umbra_facts, meshes.umbra.volume.nearest},
           {"penumbra", volumes.penumbra_facts, meshes.penumbra.volume.nearest}}};
}

VolumeFacts facts(const planar::PlanarRegion& region) {
  return {region.empty(), region.bounded(), region.components};
}

std::array<ShadowExtent, 3> planar_extents(const PlanarPairResult& pair) {
  return {{{"occlusion", facts(pair.regions.occlusion), pair.in_box.occlusion.area.nearest},
           {"umbra", facts(pair.regions.umbra), pair.in_box.umbra.area.nearest},
           {"penumbra", facts(pair.regions.penumbra), pair.in_box.penumbra.area.nearest}}};
}

}  // namespace

std::array<ShadowExtent, 3> shadow_extents(const ShadowResult& result, std::size_t pair) {
  return result.pairs.empty() ? planar_extents(result.planar_pairs[pair]) : spatial_extents(result.pairs[pair]);
}

}  // namespace gnomon
