#include "apps/gnomon/planar_sight.h"

#include <vector>

namespace gnomon {

planar::Sight planar_sight(const Scene& scene, const PlanarLight& light) {
  std::vector<planar::BlockerSegment> segments;
  for (const PlanarBlocker& blocker : scene.planar_blockers) {
    const auto parts = planar::segments_of_polyline(blocker.vertices);
    segments.insert(segments.end(), parts.begin(), parts.end());
  }
  return planar::Sight(planar::Flatland::from_points(light.vertices, segments));
}

}  // namespace gnomon
