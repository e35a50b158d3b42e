#pragma once

/// @file
/// All of gnomon. Programs that write or draw link gnomon::viz; scenes, gnomon::scene; irradiance, gnomon::shading.
///
///     #include <gnomon/gnomon.h>
///     int main() {
///       using namespace gnomon;
///       const Scene scene = parse_scene(default_scene_text(), "default", ".");
///       const auto& space = std::get<SpaceScene>(scene);
///       LightVisibility lamp(space.lights.front().shape, PreparedObstacles(scene_bodies(space).obstacles));
///       return lamp.at({0, 0, 0}).fraction < 1 ? 0 : 1;
///     }

#include "gnomon/blocker.h"
#include "gnomon/convex_polygon.h"
#include "gnomon/discontinuity.h"
#include "gnomon/errors.h"
#include "gnomon/flatland.h"
#include "gnomon/flatland_pair.h"
#include "gnomon/flatland_partition.h"
#include "gnomon/flatland_receiver.h"
#include "gnomon/flatland_regions.h"
#include "gnomon/illumination.h"
#include "gnomon/irradiance.h"
#include "gnomon/light.h"
#include "gnomon/light_design.h"
#include "gnomon/light_parts.h"
#include "gnomon/names.h"
#include "gnomon/paint_fit.h"
#include "gnomon/pair.h"
#include "gnomon/picture.h"
#include "gnomon/point.h"
#include "gnomon/processes.h"
#include "gnomon/receiver_mesh.h"
#include "gnomon/reflection.h"
#include "gnomon/result.h"
#include "gnomon/scene.h"
#include "gnomon/shadow_mesh.h"
#include "gnomon/shadow_volume.h"
#include "gnomon/sunlight.h"
#include "gnomon/view_factors.h"
#include "gnomon/visibility.h"
#include "gnomon/writer.h"
