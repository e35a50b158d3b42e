#include "geometry/visibility/shadow_tree.h"

#include <algorithm>
#include <utility>

#include "geometry/visibility/shadow_tree_content.h"

namespace gnomon {
namespace {

using viewpoint::Fragment;
using viewpoint::SplitFragment;
using Tree = ShadowTree::Content;

/// What a point's path through the tree found.
struct Path {
  std::optional<Region> region;
  std::size_t tests = 0;
};

Path path_of(const Tree& tree, const Point3& p) {
  Path path;
  if (tree.is_open || !viewpoint::is_in_range(p) || tree.light == p) return path;
  Tree::Place place = tree.root;
  while (place >= 0) {
    const Tree::Node& node = tree.nodes[static_cast<std::size_t>(place)];
    const int side = node.plane.side(p);
    ++path.tests;
    if (side == 0) return path;
    place = side > 0 ? node.positive : node.negative;
  }
  bool touches = false;
  for (const std::uint32_t facet : tree.leaves[Tree::leaf_of(place)]) {
    const int side = tree.facets[facet].side(p);
    ++path.tests;
    if (side < 0) {
      path.region = Region::umbra;
      return path;
    }
    touches = touches || side == 0;
  }
  if (!touches) path.region = Region::lit;
  return path;
}

ExactPolygon polygon_of(const Fragment& fragment) {
  ExactPolygon polygon;
  for (const viewpoint::FragmentCorner& corner : fragment) polygon.push_back(corner.point);
  return polygon;
}

void append_pieces(const Tree& tree, Tree::Place place, Fragment fragment, ShadowPieces& pieces) {
  if (fragment.empty()) return;
  if (place >= 0) {
    const Tree::Node& node = tree.nodes[static_cast<std::size_t>(place)];
    SplitFragment parts = viewpoint::split(fragment, node.plane);
    append_pieces(tree, node.positive, std::move(parts.positive), pieces);
    append_pieces(tree, node.negative, std::move(parts.negative), pieces);
    return;
  }
  for (const std::uint32_t facet : tree.leaves[Tree::leaf_of(place)]) {
    SplitFragment parts = viewpoint::split(fragment, tree.facets[facet]);
    if (!parts.negative.empty()) pieces.shadow.push_back(polygon_of(parts.negative));
    // A part in the facet's own plane is not behind it.
    if (parts.positive.empty() && parts.negative.empty()) continue;
    fragment = std::move(parts.positive);
    if (fragment.empty()) return;
  }
  pieces.lit.push_back(polygon_of(fragment));
}

std::size_t height_below(const Tree& tree, Tree::Place place) {
  if (place < 0) return 1;
  const Tree::Node& node = tree.nodes[static_cast<std::size_t>(place)];
  return 1 + std::max(height_below(tree, node.positive), height_below(tree, node.negative));
}

}  // namespace

ShadowTree::ShadowTree(const SmallLight& light, std::span<const ConvexBlocker> blockers) {
  auto content = std::make_unique<Content>();
  add_shadows(light, blockers, *content);
  content_ = std::move(content);
}
ShadowTree::ShadowTree(ShadowTree&&) noexcept = default;
ShadowTree& ShadowTree::operator=(ShadowTree&&) noexcept = default;
ShadowTree::~ShadowTree() = default;

std::optional<Region> ShadowTree::region_from(const Point3& point) const {
  return path_of(*content_, point).region;
}

ShadowPieces ShadowTree::pieces(std::span<const Point3> polygon) const {
  ShadowPieces pieces;
  append_pieces(*content_, content_->root, viewpoint::fragment_of(polygon), pieces);
  return pieces;
}

std::size_t ShadowTree::node_count() const {
  return content_->nodes.size() + content_->leaves.size();
}

std::size_t ShadowTree::height() const {
  return height_below(*content_, content_->root);
}

std::size_t ShadowTree::tests(const Point3& point) const {
  return path_of(*content_, point).tests;
}

}  // namespace gnomon
