#pragma once

/// What a ShadowTree consists of. Private to this folder.

#include <vector>

#include "geometry/visibility/shadow_fragment.h"
#include "geometry/visibility/shadow_tree.h"

namespace gnomon {

class ShadowTree::Content {
 public:
  /// A child or the root: a node by its number, or a leaf by its number from -1 down.
  using Place = std::int32_t;

  struct Node {
    viewpoint::SignedPlane plane;
    Place positive;
    Place negative;
  };

  std::vector<Node> nodes;
  std::vector<std::vector<std::uint32_t>> leaves;  ///< facets that hide all of the cell
  std::vector<viewpoint::SignedPlane> facets;      ///< their planes, the light on the positive side
  Place root = -1;
  std::optional<Point3> light;  ///< of a point light; nothing is decided there
  bool is_open = false;         ///< nothing is decided: the light touches a solid, or coordinates are too large

  static std::size_t leaf_of(Place place) { return static_cast<std::size_t>(-1 - place); }
  Place add_leaf(std::vector<std::uint32_t> list) {
    leaves.push_back(std::move(list));
    return -static_cast<Place>(leaves.size());
  }
};

/// Puts the shadows of blockers into a tree.
void add_shadows(const ShadowTree::SmallLight& light, std::span<const ConvexBlocker> blockers,
                 ShadowTree::Content& tree);

}  // namespace gnomon
