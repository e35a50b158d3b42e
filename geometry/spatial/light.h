#pragma once

#include <variant>

#include "geometry/point.h"
#include "geometry/spatial/convex_polygon.h"

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
