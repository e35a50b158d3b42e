#include "geometry/scene/emission_reader.h"

#include <cmath>
#include <string>

#include "geometry/numbers/exact_vector.h"

namespace gnomon {
namespace {

int emission_exponent(const JsonNode& node) {
  constexpr const char* profiles = "the profile \"isotropic\" or \"cosine\"";
  node.require_object("an object with a \"profile\": \"isotropic\" or \"cosine\"");
  node.allow_keys({"profile", "exponent"}, "an emission");
  const JsonNode profile_node = node.required("profile", profiles);
  const std::string profile = profile_node.string(profiles);
  if (profile != "isotropic" && profile != "cosine") profile_node.refuse_value(profiles);
  const auto exponent_node = node.optional("exponent");
  if (profile == "isotropic") {
    if (exponent_node) exponent_node->refuse_value("no exponent beside the profile \"isotropic\"");
    return 0;
  }
  if (!exponent_node) return 1;
  constexpr const char* expected = "a whole number from 0 to 100";
  const double m = exponent_node->number(expected);
  if (!(m >= 0 && m <= 100) || m != std::floor(m)) exponent_node->refuse_value(expected);
  return static_cast<int>(m);
}

double flaps_angle(const JsonNode& node) {
  constexpr const char* expected = "an angle in degrees, larger than 0 and less than 90";
  node.require_object("an object with an \"angle\" in degrees");
  node.allow_keys({"angle"}, "flaps");
  const JsonNode angle_node = node.required("angle", expected);
  const double angle = angle_node.number(expected);
  if (!(angle > 0 && angle < 90)) angle_node.refuse_value(expected);
  return angle;
}

/// A direction that is not along the light's axis.
Point3 shade_direction(const JsonNode& node, const ExactVector& axis) {
  constexpr const char* expected = "a direction that is not along the light";
  const Point3 direction = point3(node);
  if (direction == Point3{}) node.refuse("the zero vector", expected);
  if (is_zero(cross(axis, exact(direction)))) node.refuse("the light's own direction", expected);
  return direction;
}

Shade read_shade(const JsonNode& node, const ExactVector& axis) {
  node.require_object("an object with the directions \"from\" and \"to\"");
  node.allow_keys({"from", "to"}, "a shade");
  const JsonNode to_node = node.required("to", "a direction of 3 coordinates");
  const Point3 from = shade_direction(node.required("from", "a direction of 3 coordinates"), axis);
  const Point3 to = shade_direction(to_node, axis);
  const ExactVector a = cross(axis, exact(from)), b = cross(axis, exact(to));
  if (is_zero(cross(a, b)) && dot(a, b) > 0) {
    to_node.refuse("a direction in the half-plane of \"from\"", "another half-plane about the light");
  }
  return {from, to};
}

}  // namespace

Emission read_emission(const SceneElement& element, const Point3& start, const Point3& end) {
  Emission emission;
  if (const auto node = element.node.optional("emission")) emission.exponent = emission_exponent(*node);
  if (const auto node = element.node.optional("flaps")) emission.flaps = flaps_angle(*node);
  if (const auto node = element.node.optional("shade")) emission.shade = read_shade(*node, exact(end) - exact(start));
  return emission;
}

}  // namespace gnomon
