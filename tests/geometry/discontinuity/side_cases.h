#pragma once

/// Scenes in which lights and blockers meet receivers' planes more often than not.

#include <string>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/convex_polygon.h"
#include "gnomon/light.h"
#include "tests/support/dice.h"

namespace gnomon::test_support {

struct SideCase {
  Light light;
  std::vector<ConvexBlocker> blockers;
  std::vector<ConvexPolygon> receivers;
};

/// A floor, level and upright things of small whole numbers on it, through it and above it: windows, tubes, lamps,
/// points and suns with vertices and edges in the floor's plane or on both sides of it; boxes, walls, boards and solids
/// on a corner, an edge or a facet. Receivers are the floor from above or below, walls in planes of the scene, facets
/// of blockers seen from outside or from inside.
SideCase room(Dice& dice);

/// The same in any direction: light, blockers and receivers on few points, so that a receiver's plane holds vertices,
/// edges and facets of the others, ends on them or passes through them.
SideCase tangle(Dice& dice);

/// Fins, baffles and screens that touch the light, at its vertices, on its edges or inside, each other and the floor,
/// or pass through the light.
SideCase luminaire(Dice& dice);

/// The case as a scene file.
std::string scene_text(const SideCase& drawn);

}  // namespace gnomon::test_support
