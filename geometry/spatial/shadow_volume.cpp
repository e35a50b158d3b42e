#include "geometry/spatial/shadow_volume.h"

#include <algorithm>

#include "geometry/spatial/pair.h"
#include "geometry/spatial/shadow_polyhedra.h"

namespace gnomon {
namespace {

/// Two components exactly when the light's line misses the blocker, both tangent planes through it hold a blocker edge,
/// and the umbra reaches infinity within both: then nothing joins the penumbra's halves (theory S14).
/// `line_meets_blocker` is light_line_meets_blocker(pair), which needs the common rounding mode.
std::uint32_t penumbra_components(const PairHalfSpaces& half_spaces, const ShadowPolyhedra& polyhedra,
                                  std::uint32_t light_corners, bool line_meets_blocker) {
  if (light_corners == 1) return 0;
  if (light_corners > 2 || line_meets_blocker) return 1;
  int closed_off = 0;
  for (const auto& face : polyhedra.umbra.faces) {
    for (std::size_t k = 0; k < half_spaces.supporting.size(); ++k) {
      if (half_spaces.supporting[k].holds_light && face.plane == polyhedra.supporting_blocker[k]) {
        closed_off += reaches_infinity(polyhedra.space, face);
      }
    }
  }
  return closed_off == 2 ? 2 : 1;
}

}  // namespace

Side ConvexVolume::oriented_side(const Point3& point) const {
  Side side = Side::inside;
  for (const HalfSpace& half_space : half_spaces) {
    const auto& [a, b, c] = half_space.plane;
    const int sign = exact_orientation(a, b, c, point);
    if (sign > 0) return Side::outside;
    if (sign == 0) side = Side::boundary;
  }
  return side;
}

ShadowVolumes shadow_volumes(const Light& light, const ConvexPolygon& blocker) {
  const StandardPair pair = standard_pair(light, blocker);
  const PairHalfSpaces half_spaces(pair);
  const bool line_meets_blocker = light_line_meets_blocker(pair);
  ShadowVolumes volumes;
  volumes.planes = extremal_planes(pair);
  volumes.occlusion.half_spaces.push_back(half_spaces.blocker_face);
  volumes.umbra.half_spaces.push_back(half_spaces.blocker_face);
  const auto append = [](std::vector<HalfSpace>& to, const std::vector<HalfSpace>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(volumes.occlusion.half_spaces, half_spaces.separating_blocker);
  append(volumes.occlusion.half_spaces, half_spaces.separating_light);
  append(volumes.umbra.half_spaces, half_spaces.supporting_blocker);

  const CGAL::Protect_FPU_rounding<true> protection;
  const ShadowPolyhedra polyhedra(pair, half_spaces);
  const std::uint32_t components = penumbra_components(half_spaces, polyhedra, pair.light.size(), line_meets_blocker);
  volumes.occlusion_facts = {false, false, 1};
  volumes.umbra_facts = {false, !reaches_infinity(polyhedra.space, polyhedra.umbra), 1};
  volumes.penumbra_facts = {components == 0, components == 0, components};
  return volumes;
}

}  // namespace gnomon
