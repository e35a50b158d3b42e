#pragma once

/// Surfaces as an eye sees them: the options that name eye and material, and what points reflect.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "apps/gnomon/light_groups.h"
#include "gnomon/reflection.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// The eye as an option has it: "x,y,z", or "camera" for that of the scene's camera.
///
/// Throws: UsageError.
std::array<double, 3> eye_named(const std::string& text, const SpaceScene& scene);

/// The material of that name; without a name that of the receiver, which may be empty; else the scene's only one; or,
/// in a scene without materials, a diffuse grey of 0.5.
///
/// Throws: UsageError.
const SceneMaterial& chosen_material(const std::string& asked, const std::string& receiver, const SpaceScene& scene);

/// True if red, green and blue may differ.
bool is_coloured(const SpaceScene& scene, const Material& material, const std::vector<const SceneLight*>& lights);

/// What a point reflects to an eye of each light, and of what comes from everywhere.
struct ReflectedLights {
  std::vector<RadianceRgb> lights;  ///< of each group
  RadianceRgb ambient;

  RadianceRgb total() const;
};

/// How many workers look, and how they find what may hide a linear light.
struct SurfaceViewers {
  unsigned count = 1;
  LinearSearch search = {};
};

/// Points of one material, seen behind all blockers of a scene.
class ViewedSurface {
 public:
  /// The lookers are the workers of for_all with that many threads. The scene, whose lights these are, outlives the
  /// surface.
  ViewedSurface(const SpaceScene& scene, std::vector<LightGroup> groups, const Material& material,
                const PreparedObstacles& obstacles, const SurfaceViewers& viewers);

  /// Exactness: for the direction to the eye as the difference of the two points rounded to doubles. From the surface's
  ///            own plane nothing is seen, from the point itself too.
  ReflectedLights at(std::size_t worker, const ReceiverPoint& receiver, const Point3& normal,
                     const std::array<double, 3>& eye);

 private:
  std::vector<LightGroup> groups_;
  std::vector<const SceneLight*> lights_;  ///< all parts
  Material material_;
  LengthUnit unit_;
  RadianceRgb ambient_;
  std::vector<std::vector<LightReflection>> reflections_;  ///< of every worker, for every light
};

}  // namespace gnomon
