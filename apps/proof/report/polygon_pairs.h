#pragma once

#include <cstdint>

#include "gnomon/light.h"

namespace gnomon::report {

/// An area light and a flat blocker in standard position.
struct PolygonPair {
  Light light;
  ConvexPolygon blocker;

  const ConvexPolygon& light_polygon() const { return std::get<AreaLight>(light).polygon; }
};

/// A light of `corners` vertices above a blocker of as many, in two different tilted planes and turned against each
/// other, so that no light edge is coplanar with a blocker edge and all coordinates count.
PolygonPair generic_pair(std::uint32_t corners);

/// Two squares whose edges are parallel in pairs: every extremal plane touches a whole side of the light.
PolygonPair aligned_squares();

}  // namespace gnomon::report
