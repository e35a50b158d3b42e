#include "apps/gnomon/light_groups.h"

#include "apps/gnomon/element_choice.h"

namespace gnomon {
namespace {

template <class Value, class Total>
std::vector<Value> totals_of_groups(std::span<const LightGroup> groups, std::span<const Value> of_parts,
                                    const Total& total) {
  std::vector<Value> result;
  for (const LightGroup& group : groups) {
    const std::span<const Value> own = of_parts.first(group.parts.size());
    result.push_back(own.size() == 1 ? own.front() : total(own));
    of_parts = of_parts.subspan(own.size());
  }
  return result;
}

}  // namespace

std::vector<LightGroup> chosen_groups(const SpaceScene& scene, const std::string& name) {
  std::vector<LightGroup> groups;
  std::string element;
  for (const SceneLight* light : chosen_lights(scene.lights, name)) {
    const bool goes_on = !groups.empty() && light->is_part() && light->element == element;
    if (!goes_on) groups.push_back({light->name == name ? name : light->element, {}});
    groups.back().parts.push_back(light);
    element = light->element;
  }
  return groups;
}

std::vector<Light> shapes_of(const LightGroup& group) {
  std::vector<Light> shapes;
  for (const SceneLight* part : group.parts) shapes.push_back(part->shape);
  return shapes;
}

std::vector<std::string> names_of(std::span<const LightGroup> groups) {
  std::vector<std::string> names;
  for (const LightGroup& group : groups) names.push_back(group.name);
  return names;
}

std::vector<const SceneLight*> parts_of(std::span<const LightGroup> groups) {
  std::vector<const SceneLight*> parts;
  for (const LightGroup& group : groups) parts.insert(parts.end(), group.parts.begin(), group.parts.end());
  return parts;
}

std::vector<Irradiance> irradiance_of_groups(std::span<const LightGroup> groups, std::span<const Irradiance> of_parts) {
  return totals_of_groups(groups, of_parts, [](std::span<const Irradiance> own) { return total_irradiance(own); });
}

std::vector<RadianceRgb> radiance_of_groups(std::span<const LightGroup> groups, std::span<const RadianceRgb> of_parts) {
  return totals_of_groups(groups, of_parts, [](std::span<const RadianceRgb> own) { return total_radiance(own); });
}

}  // namespace gnomon
