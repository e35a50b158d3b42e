#include "gnomon/shadow_volume.h"

#include "geometry/spatial/prepared_pair.h"
#include "geometry/spatial/volume_extent.h"
#include "gnomon/pair.h"

namespace gnomon {
namespace {

int side_of(const HalfSpace& half_space, const Point3& point) {
  const auto& [a, b, c] = half_space.plane;
  return half_space.third_is_direction ? -exact_direction_side(a, b, point, c) : exact_orientation(a, b, c, point);
}

template <class Index>
MaybeIndex<Index> named(const std::optional<std::uint32_t>& index) {
  return index ? MaybeIndex<Index>(Index{*index}) : MaybeIndex<Index>();
}

/// The planes of half-spaces that go through an edge of one and a vertex of the other.
ExtremalPlanes named_planes(const PairHalfSpaces& half_spaces) {
  ExtremalPlanes planes;
  const auto add = [&](const HalfSpace& half_space) {
    const auto& [kind, edge, vertex] = half_space.name;
    if (kind == FacetKind::separating_blocker_plane) {
      planes.separating_blocker.push_back({named<BlockerEdge>(edge), LightVertex{vertex.value()}});
    } else if (kind == FacetKind::supporting_blocker_plane) {
      planes.supporting_blocker.push_back({named<BlockerEdge>(edge), LightVertex{vertex.value()}});
    } else if (kind == FacetKind::separating_light_plane) {
      planes.separating_light.push_back({named<LightEdge>(edge), BlockerVertex{vertex.value()}});
    }
  };
  for (const HalfSpace& half_space : half_spaces.occlusion) add(half_space);
  for (const HalfSpace& half_space : half_spaces.umbra) add(half_space);
  return planes;
}

}  // namespace

Side ConvexVolume::oriented_side(const Point3& point) const {
  if (empty) return Side::outside;
  Side side = Side::inside;
  for (const HalfSpace& half_space : half_spaces) {
    const int sign = side_of(half_space, point);
    if (sign > 0) return Side::outside;
    if (sign == 0) side = Side::boundary;
  }
  return side;
}

ShadowVolumes volumes_of(PreparedPair pair, const Light& light, const ConvexBlocker& blocker) {
  ShadowVolumes volumes;
  PairHalfSpaces& half_spaces = pair.half_spaces;
  volumes.planes = pair.standard ? extremal_planes(*pair.standard) : named_planes(half_spaces);
  if (!pair.bodies) pair.bodies.emplace(body(light), body(blocker));
  const VolumeExtents extents = volume_extents(*pair.bodies, half_spaces);
  volumes.occlusion_facts = extents.occlusion;
  volumes.umbra_facts = extents.umbra;
  volumes.penumbra_facts = extents.penumbra;
  volumes.umbra_pockets = extents.umbra_pockets;
  volumes.occlusion = {std::move(half_spaces.occlusion), half_spaces.occlusion_empty};
  volumes.umbra = {std::move(half_spaces.umbra), half_spaces.umbra_empty};
  return volumes;
}

ConvexVolume convex_hull_shadow_volume(const Light& light, const ConvexBlocker& blocker) {
  PairForm form(light, blocker);
  form.require_support();
  PairHalfSpaces half_spaces = pair_half_spaces(form.bodies(), light);
  return {std::move(half_spaces.occlusion), half_spaces.occlusion_empty};
}

}  // namespace gnomon
