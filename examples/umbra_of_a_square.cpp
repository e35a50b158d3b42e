// The umbra of a square under a larger square lamp: a pyramid, whose volume is known exactly.

#include <cstdio>

#include <gnomon/shadow_mesh.h>

int main() {
  using namespace gnomon;
  const Light lamp = AreaLight{ConvexPolygon::from_points({{-2, -2, 4}, {-2, 2, 4}, {2, 2, 4}, {2, -2, 4}})};
  const ConvexPolygon board = ConvexPolygon::from_points({{-1, -1, 3}, {1, -1, 3}, {1, 1, 3}, {-1, 1, 3}});

  const ShadowVolumes shadow = shadow_volumes(lamp, board);
  std::printf("bounded: %s\n", shadow.umbra_facts.bounded ? "yes" : "no");
  std::printf("the apex (0, 0, 2) is on its boundary: %s\n",
              shadow.umbra.oriented_side({0, 0, 2}) == Side::boundary ? "yes" : "no");

  const ShadowMeshes meshes = shadow_meshes(lamp, board, Box3{{-9, -9, 0}, {9, 9, 9}});
  std::printf("volume: %s = %.17g\n", meshes.umbra.volume.exact.c_str(), meshes.umbra.volume.nearest);
  std::printf("mesh: %zu vertices, %zu triangles\n", meshes.umbra.vertices.size(), meshes.umbra.triangles.size());
}
