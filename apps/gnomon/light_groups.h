#pragma once

#include <span>
#include <string>
#include <vector>

#include "gnomon/irradiance.h"
#include "gnomon/scene.h"

namespace gnomon {

/// A light of the file as results name it: itself, or its convex parts, one after the other.
struct LightGroup {
  std::string name;
  std::vector<const SceneLight*> parts;
};

/// The lights of that name, or all of them if it is empty, in file order. The name of a part asks for that part alone.
///
/// Throws: UsageError for a name that the scene does not have.
std::vector<LightGroup> chosen_groups(const SpaceScene& scene, const std::string& name);

/// The shapes of a group's parts.
std::vector<Light> shapes_of(const LightGroup& group);

/// The names of groups, and all their parts in one list.
std::vector<std::string> names_of(std::span<const LightGroup> groups);
std::vector<const SceneLight*> parts_of(std::span<const LightGroup> groups);

/// What each group gives, from what each part gives.
///
/// Requires: as many values as the groups have parts together.
std::vector<Irradiance> irradiance_of_groups(std::span<const LightGroup> groups, std::span<const Irradiance> of_parts);
std::vector<RadianceRgb> radiance_of_groups(std::span<const LightGroup> groups, std::span<const RadianceRgb> of_parts);

}  // namespace gnomon
