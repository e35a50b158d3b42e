#pragma once

/// Small meshes under lamps as wide as they are.

#include "tests/geometry/discontinuity/side_cases.h"

namespace gnomon::test_support {

/// Triangles on few points above a floor, most of which share edges and vertices: a sheet with or without holes, a
/// closed double pyramid, or leaves between any of the points. Coordinates are small multiples of a half, so that edges
/// and triangles lie in common planes, or these shaken a little. The floor and a level plane through vertices receive.
SideCase mesh_under_lamp(Dice& dice);

}  // namespace gnomon::test_support
