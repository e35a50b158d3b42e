#include "apps/gnomon/viewed_surface.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "shading/image/scene_radiance.h"

namespace gnomon {
namespace {

/// Empty if the receiver has no material, or there is none that is called so.
std::string material_on(const std::string& receiver, const SpaceScene& scene) {
  for (const SceneReceiver& facet : scene.receivers) {
    if (facet.is_called(receiver)) return facet.material;
  }
  return {};
}

bool is_grey(const Rgb& colour) {
  return colour[0] == colour[1] && colour[1] == colour[2];
}

/// Half of the way from a point to another, which does not overflow.
Point3 halfway(const Point3& from, const std::array<double, 3>& to) {
  return {to[0] / 2 - from.x / 2, to[1] / 2 - from.y / 2, to[2] / 2 - from.z / 2};
}

}  // namespace

std::array<double, 3> eye_named(const std::string& text, const SpaceScene& scene) {
  if (text == "camera") {
    if (!scene.camera) throw UsageError("--eye camera: the scene has no camera; expected x,y,z");
    return {scene.camera->eye.x, scene.camera->eye.y, scene.camera->eye.z};
  }
  const std::vector<std::string_view> parts = comma_separated(text);
  if (parts.size() != 3) throw UsageError("--eye: found '" + text + "', expected x,y,z, or camera");
  std::array<double, 3> eye{};
  for (std::size_t k = 0; k < 3; ++k) eye[k] = finite_value("--eye", std::string(parts[k]), "x,y,z, or camera");
  return eye;
}

const SceneMaterial& chosen_material(const std::string& asked, const std::string& receiver, const SpaceScene& scene) {
  static const SceneMaterial grey{"", {}};
  const std::string wanted = asked.empty() ? material_on(receiver, scene) : asked;
  if (wanted.empty()) {
    if (scene.materials.size() > 1) throw UsageError("the scene has several materials: name one with --material NAME");
    return scene.materials.empty() ? grey : scene.materials.front();
  }
  const auto found = std::ranges::find(scene.materials, wanted, &SceneMaterial::name);
  if (found != scene.materials.end()) return *found;
  std::string known;
  for (const SceneMaterial& material : scene.materials) known += (known.empty() ? "" : ", ") + material.name;
  throw UsageError("--material: found '" + asked + "', expected a material of the scene" +
                   (known.empty() ? ", which has none" : ": " + known));
}

bool is_coloured(const SpaceScene& scene, const Material& material, const std::vector<const SceneLight*>& lights) {
  const bool grey = is_grey(material.diffuse) && is_grey(material.specular) && is_grey(material.ambient) &&
                    is_grey(scene.ambient_radiance);
  return !grey || !std::ranges::all_of(lights, [](const SceneLight* light) { return is_grey(light->color); });
}

RadianceRgb ReflectedLights::total() const {
  std::vector<RadianceRgb> parts = lights;
  parts.push_back(ambient);
  return total_radiance(parts);
}

ViewedSurface::ViewedSurface(const SpaceScene& scene, std::vector<LightGroup> groups, const Material& material,
                             const PreparedObstacles& obstacles, const SurfaceViewers& viewers)
    : groups_(std::move(groups)),
      lights_(parts_of(groups_)),
      material_(material),
      unit_(*length_unit_named(scene.length_unit)),
      ambient_(ambient_radiance(material, scene.ambient_radiance)),
      reflections_(viewers.count) {
  for (std::vector<LightReflection>& own : reflections_) {
    for (const SceneLight* light : lights_) own.emplace_back(light->shape, obstacles, viewers.search);
  }
}

ReflectedLights ViewedSurface::at(std::size_t worker, const ReceiverPoint& receiver, const Point3& normal,
                                  const std::array<double, 3>& eye) {
  ReflectedLights seen;
  const Point3& p = receiver.point;
  if (eye == std::array{p.x, p.y, p.z}) {
    seen.lights.resize(groups_.size());
    return seen;
  }
  const View view{p, normal, halfway(p, eye)};
  std::vector<RadianceRgb> of_parts;
  for (std::size_t l = 0; l < lights_.size(); ++l) {
    const Reflection r = reflections_[worker][l].received(receiver, view, material_.model, material_.exponent);
    of_parts.push_back(reflected_radiance(*lights_[l], r, material_, unit_));
  }
  seen.lights = radiance_of_groups(groups_, of_parts);
  if (eye_is_above(view)) seen.ambient = ambient_;
  return seen;
}

}  // namespace gnomon
