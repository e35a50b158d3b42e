#pragma once

#include <string>
#include <vector>

#include "gnomon/scene.h"
#include "gnomon/view_factors.h"

namespace gnomon {

/// The surfaces of a scene between which view factors are asked, with their names.
struct ViewSurfaces {
  std::vector<std::string> names;
  std::vector<ViewSurface> shapes;

  void add(std::string name, ViewSurface shape) {
    names.push_back(std::move(name));
    shapes.push_back(std::move(shape));
  }
};

/// The sides of receivers: `floor`, `pane/front`, `pane/back`; all facets of one side together.
ViewSurfaces receiver_surfaces(const SpaceScene& scene);

/// The facets of blockers from outside: `box/facet#0` of a solid, `board/front` and `board/back` of a polygon and of a
/// piece of one or of an open mesh, `vase#12` of a closed mesh.
ViewSurfaces blocker_surfaces(const SpaceScene& scene, const SceneBodies& bodies);

/// Throws: UnsupportedError for coordinates that receivers are not divided for.
void require_range(const SpaceScene& scene, const ViewSurfaces& surfaces, const Obstacles& obstacles);

}  // namespace gnomon
