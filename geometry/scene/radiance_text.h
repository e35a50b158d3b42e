#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene/material_file.h"
#include "geometry/scene/mesh_formats.h"

namespace gnomon {

/// The polygons of a Radiance scene, and their materials.
struct RadianceScene {
  PolygonSoup soup;                                    ///< its doubts tell what was passed over, a kind each
  std::vector<std::string> names;                      ///< of each facet, the polygon's identifier
  std::vector<std::optional<FileMaterial>> materials;  ///< of each of the soup's materials; none of a type not known
};

/// Reads the text of a Radiance scene: polygons, the materials light, illum, glow, plastic and metal, and aliases.
///
/// A polygon has the material that its modifier is, or the nearest material along the modifier's own modifiers: that
/// of the last definition before it. Where that is void nothing is seen of the polygon, which is left out. A glow with
/// a negative radius lights nothing, as in Radiance. Plastic of the colour c and the specular share s reflects c (1 -
/// s) diffusely and s specularly, metal c s; the lobe exp(-tan^2 / r^2) of the roughness r has at its peak the width of
/// a cosine to the power 2 / r^2, which is the exponent; a roughness of 0, a mirror, leaves the specular share out.
/// Patterns, textures, other materials and other surfaces are passed over; polygons of other materials have none.
///
/// Throws: SceneError, with the line; UnsupportedSceneError for a command ("!xform ..."), which is never run.
RadianceScene radiance_scene(std::string_view text, const MeshSource& source);

}  // namespace gnomon
