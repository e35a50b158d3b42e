#include "gnomon/flatland_pair.h"

#include "geometry/planar/orientation.h"
#include "gnomon/errors.h"

namespace gnomon::planar {
namespace {

/// The light's side of the blocker's line.
int light_side(const Pair& pair) {
  const auto& [b0, b1] = pair.blocker();
  const int side = orientation(b0, b1, pair.light().front());
  const bool standard = side != 0 && (pair.has_point_light() || orientation(b0, b1, pair.light().back()) == side);
  if (!standard) throw PreconditionError("extremal lines need a pair in standard position");
  return side;
}

}  // namespace

std::array<ExtremalLine, 4> extremal_lines(const Pair& pair) {
  const int side = light_side(pair);
  std::array<ExtremalLine, 4> lines{};
  for (const std::uint32_t i : {0U, 1U}) {
    const auto end = BlockerVertex{i};
    // Seen along the line from the blocker's end i to light end 0, the blocker's other end lies on the side
    // `blocker_at`, light end 1 on the side `light_at`. Seen along the line to light end 1, both signs are the opposite
    // for the light and the same for the blocker; so one line separates and the other supports.
    const int blocker_at = i == 0 ? -side : side;
    const int light_at =
        pair.has_point_light() ? 0 : orientation(pair.blocker_end(end), pair.light().front(), pair.light().back());
    const auto separating = LightVertex{light_at == blocker_at ? 1U : 0U};
    const auto supporting = LightVertex{light_at == -blocker_at ? 1U : 0U};
    lines[i] = {Contact::separating, end, separating};
    lines[i + 2] = {Contact::supporting, end, supporting};
  }
  return lines;
}

}  // namespace gnomon::planar
