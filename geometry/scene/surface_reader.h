#pragma once

#include <filesystem>
#include <vector>

#include "geometry/scene/scene_elements.h"
#include "gnomon/scene.h"

namespace gnomon {

/// A number for all three colours, or an array [r, g, b], each at least 0 and at most `most`.
Rgb colour(const JsonNode& node, double most);

/// The keys "ambient_radiance" and "materials" of a scene.
void read_materials(const JsonNode& document, SpaceScene& scene);

/// The name of a material of the scene, under the key "material" of an element; empty without it.
std::string material_name(const SceneElement& element, const SpaceScene& scene);

/// The key "color" of a light.
Rgb light_colour(const SceneElement& element);

/// Materials that reflect more than arrives.
void doubt_materials(const SpaceScene& scene, std::vector<std::string>& doubts);

}  // namespace gnomon
