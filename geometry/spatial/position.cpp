#include "geometry/spatial/position.h"

#include "geometry/spatial/pair_sides.h"

namespace gnomon {

std::string_view name(Position position) {
  constexpr std::string_view names[] = {
      "standard",    "light_crosses_blocker_plane", "blocker_crosses_light_plane", "both_cross", "touching", "coplanar",
      "behind_light"};
  return names[static_cast<int>(position)];
}

Position pair_position(const Light& light, const ConvexPolygon& blocker) {
  return pair_position(light, pair_sides(light, blocker));
}

}  // namespace gnomon
