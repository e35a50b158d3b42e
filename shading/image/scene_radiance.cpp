#include "shading/image/scene_radiance.h"

#include <algorithm>
#include <cmath>

namespace gnomon {

RadianceRgb reflected_radiance(const SceneLight& light, Reflection reflection, const Material& material,
                               const LengthUnit& unit) {
  reflection.received = per_square_metre(reflection.received, light.shape, unit);
  reflection.lobe = per_square_metre(reflection.lobe, light.shape, unit);
  Rgb strength = light.color;
  for (double& s : strength) s *= light.strength;
  RadianceRgb result = reflected_radiance(reflection, material, strength);
  // What the product of strength and colour rounds.
  if (light.color != Rgb{1, 1, 1}) {
    for (Radiance& r : result) r.error_bound += 0x1p-52 * r.value;
  }
  return result;
}

RadianceRgb ambient_radiance(const Material& material, const Rgb& ambient) {
  RadianceRgb result;
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = material.ambient[k] * ambient[k];
    result[k] = {value, value == 0 ? 0 : std::fmax(value * 0x1p-52, 0x1p-1074)};
  }
  return result;
}

const Material& material_named(const SpaceScene& scene, const std::string& name) {
  static const Material grey;
  const auto found = std::ranges::find(scene.materials, name, &SceneMaterial::name);
  return found == scene.materials.end() ? grey : found->material;
}

}  // namespace gnomon
