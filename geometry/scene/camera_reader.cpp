#include "geometry/scene/camera_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/numbers/exact_vector.h"

namespace gnomon {
namespace {

double camera_angle(const JsonNode& node) {
  constexpr const char* expected = "an angle in degrees, larger than 0 and less than 180";
  const double angle = node.number(expected);
  if (!(angle > 0 && angle < 180)) node.refuse_value(expected);
  return angle;
}

std::uint32_t pixel_count(const JsonNode& node) {
  constexpr const char* expected = "a whole number of pixels from 1 to 16384";
  const double count = node.number(expected);
  if (!(count >= 1 && count <= 16384) || count != std::floor(count)) node.refuse_value(expected);
  return static_cast<std::uint32_t>(count);
}

/// Refuses a camera that looks nowhere, or along its up.
void check_directions(const JsonNode& node, const SceneCamera& camera) {
  if (camera.eye == camera.look_at) {
    node.required("look_at", "").refuse("the eye itself", "another point than the eye");
  }
  const ExactVector ahead = exact(camera.look_at) - exact(camera.eye);
  if (!is_zero(cross(ahead, exact(camera.up)))) return;
  const JsonNode up = node.optional("up").value_or(node);
  up.refuse(camera.up == Point3{} ? "the zero vector" : "an up along the way the camera looks",
            "an \"up\" that is not along the way from \"eye\" to \"look_at\"");
}

constexpr std::array<std::pair<std::string_view, VertexNormals>, 5> normal_names{{{"flat", VertexNormals::flat},
                                                                                  {"file", VertexNormals::file},
                                                                                  {"angle", VertexNormals::angle},
                                                                                  {"area", VertexNormals::area},
                                                                                  {"equal", VertexNormals::equal}}};

VertexNormals vertex_normals(const JsonNode& node) {
  std::vector<std::string_view> names;
  for (const auto& [name, normals] : normal_names) names.push_back(name);
  const std::string expected = "vertex normals among " + listed(names);
  const std::string asked = node.string(expected);
  for (const auto& [name, normals] : normal_names) {
    if (asked == name) return normals;
  }
  node.refuse_value(expected);
}

}  // namespace

std::optional<SceneCamera> read_camera(const JsonNode& document, UpAxis up) {
  const auto node = document.optional("camera");
  if (!node) return std::nullopt;
  node->require_object("a camera: an object with \"eye\" and \"look_at\"");
  node->allow_keys({"eye", "look_at", "up", "fov", "width", "height"}, "a camera");
  SceneCamera camera;
  camera.eye = point3(node->required("eye", "a point of 3 coordinates"));
  camera.look_at = point3(node->required("look_at", "a point of 3 coordinates"));
  if (up == UpAxis::y) camera.up = {0, 1, 0};
  if (const auto key = node->optional("up")) camera.up = point3(*key);
  if (const auto key = node->optional("fov")) camera.fov = camera_angle(*key);
  if (const auto key = node->optional("width")) camera.width = pixel_count(*key);
  if (const auto key = node->optional("height")) camera.height = pixel_count(*key);
  check_directions(*node, camera);
  return camera;
}

Smoothness read_smoothness(const SceneElement& element) {
  Smoothness smoothness;
  if (const auto node = element.node.optional("normals")) smoothness.normals = vertex_normals(*node);
  if (const auto node = element.node.optional("crease")) {
    constexpr const char* expected = "an angle in degrees from 0 to 180";
    smoothness.crease = node->number(expected);
    if (!(smoothness.crease >= 0 && smoothness.crease <= 180)) node->refuse_value(expected);
  }
  return smoothness;
}

}  // namespace gnomon
