// Names the extremal planes of a triangular light above a square blocker. Nothing is constructed: a plane is an edge
// and a vertex of the input, and a contact.

#include <gnomon/pair.h>

#include <cstdio>

int main() {
  using namespace gnomon;
  const Light lamp = AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {0, 1, 4}, {1, -1, 4}})};
  const ConvexPolygon board = ConvexPolygon::from_points({{-2, -2, 2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, 2}});

  const ExtremalPlanes planes = extremal_planes(lamp, board);
  for (const BlockerPlane& plane : planes.separating_blocker) {
    std::printf("separating: board edge %u, lamp vertex %u\n", number(plane.edge), number(plane.vertex));
  }
  for (const LightPlane& plane : planes.separating_light) {
    std::printf("separating: lamp edge %u, board vertex %u\n", number(plane.edge), number(plane.vertex));
  }
  for (const BlockerPlane& plane : planes.supporting_blocker) {
    std::printf("supporting: board edge %u, lamp vertex %u\n", number(plane.edge), number(plane.vertex));
  }
}
