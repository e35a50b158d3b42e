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
///       return sun.index() == 1 && tube.index() == 2 && lamp.index() == 3 ? 0 : 1;
///     }

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

/// A luminous segment between two different points; it emits in every direction.
struct LinearLight {
  Point3 start;
  Point3 end;
};

/// A luminous convex polygon; it emits from its front, the side from which its vertices run counterclockwise,
/// or, if `two_sided`, from both sides.
struct AreaLight {
  ConvexPolygon polygon;
  bool two_sided = false;
};

/// Any light of space.
using Light = std::variant<PointLight, DirectionalLight, LinearLight, AreaLight>;

}  // namespace gnomon
