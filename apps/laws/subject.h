#pragma once

#include <functional>

#include "geometry/spatial/shadow_volume.h"

namespace gnomon::laws {

/// The functions the laws are about, as values: a test may pass a broken one to see that a law catches it.
struct Subject {
  std::function<ExtremalPlanes(const Light&, const ConvexPolygon&)> extremal_planes = gnomon::extremal_planes;
  std::function<ShadowVolumes(const Light&, const ConvexPolygon&)> shadow_volumes = gnomon::shadow_volumes;
};

}  // namespace gnomon::laws
