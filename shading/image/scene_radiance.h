#pragma once

/// Radiance that the lights of a scene give, in its unit of length.

#include "gnomon/reflection.h"
#include "gnomon/scene.h"

namespace gnomon {

/// What a material reflects of a scene's light, from integrals in the scene's unit of length.
RadianceRgb reflected_radiance(const SceneLight& light, Reflection reflection, const Material& material,
                               const LengthUnit& unit);

/// What it reflects of the radiance that comes from everywhere.
RadianceRgb ambient_radiance(const Material& material, const Rgb& ambient);

/// The material of that name; a diffuse grey of 0.5 without one.
const Material& material_named(const SpaceScene& scene, const std::string& name);

}  // namespace gnomon
