#pragma once

/// @file
/// Lights: a point, a direction, a segment or a polygon.
///
///     #include <gnomon/light.h>
///     int main() {
///       using namespace gnomon;
///       const Light sun = DirectionalLight{{1, 0, -3}};
///       const Light tube = LinearLight{{-1, 0, 4}, {1, 0, 4}};
///       const Light lamp = AreaLight{ConvexPolygon::from_points({{0, 0, 4}, {0, 1, 4}, {1, 0, 4}})};  // shines down
///       const Light spot = LinearLight{{-1, 0, 4}, {1, 0, 4}, {.exponent = 1, .flaps = 60}};  // a tube between flaps
///       return sun.index() == 1 && tube.index() == 2 && lamp.index() == 3 && spot.index() == 2 ? 0 : 1;
///     }

#include <optional>
#include <variant>

#include "gnomon/convex_polygon.h"
#include "gnomon/point.h"

namespace gnomon {

/// A light without size.
struct PointLight {
  Point3 position;
};

/// A light infinitely far away; its rays run along `direction`, which is not zero.
struct DirectionalLight {
  Point3 direction;
};

/// Half-planes about a linear light's axis, from one direction to another: right-handed about the way from the light's
/// start to its end, by less than a whole turn. Of a direction counts what lies across the axis.
struct Shade {
  Point3 from;
  Point3 to;
};

/// How a linear light shines beside its strength k: along a direction that makes the angle beta with the planes across
/// the light, k cos^m(beta). A thin tube that glows alike everywhere, a Lambertian cylinder, has m = 1.
struct Emission {
  int exponent = 0;                  ///< m, from 0 (alike in all directions) to 100
  std::optional<double> flaps = {};  ///< dark where |beta| is larger than this, in degrees between 0 and 90
  std::optional<Shade> shade = {};   ///< dark outside of these half-planes, which are lit themselves
};

/// A luminous segment between two different points; it emits in every direction, alike unless `emission` says
/// otherwise.
struct LinearLight {
  Point3 start;
  Point3 end;
  Emission emission = {};
};

/// True if a linear light shines alike in all directions.
inline bool is_isotropic(const Emission& emission) {
  return emission.exponent == 0 && !emission.flaps && !emission.shade;
}

/// A luminous convex polygon; it emits from its front, the side from which its vertices run counterclockwise,
/// or, if `two_sided`, from both sides.
struct AreaLight {
  ConvexPolygon polygon;
  bool two_sided = false;
};

/// Any light of space.
using Light = std::variant<PointLight, DirectionalLight, LinearLight, AreaLight>;

}  // namespace gnomon
