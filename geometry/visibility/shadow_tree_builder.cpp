#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/numbers/orientation.h"
#include "geometry/visibility/shadow_tree_content.h"

namespace gnomon {
namespace {

using viewpoint::Fragment;
using viewpoint::FragmentCorner;
using viewpoint::SignedPlane;
using Corners = std::vector<Point3>;
using Tree = ShadowTree::Content;

/// A light without size, as its planes need it.
struct Source {
  Point3 place;  ///< or the direction towards it
  bool is_near = true;

  explicit Source(const ShadowTree::SmallLight& light) {
    const auto* point = std::get_if<PointLight>(&light);
    is_near = point != nullptr;
    const Point3 d = point ? Point3{} : std::get<DirectionalLight>(light).direction;
    place = point ? point->position : Point3{-d.x, -d.y, -d.z};
  }

  /// +1 where a, b, c run counterclockwise seen from the light.
  int side_of(const Point3& a, const Point3& b, const Point3& c) const {
    return is_near ? exact_orientation(a, b, c, place) : exact_direction_side(a, b, c, place);
  }

  SignedPlane plane_through(const Point3& a, const Point3& b) const {
    return is_near ? SignedPlane::through(place, a, b) : SignedPlane::along(a, b, place);
  }

  /// Grows with the distance from the light.
  double depth(const Point3& p) const {
    if (is_near) return std::hypot(p.x - place.x, p.y - place.y, p.z - place.z);
    return -(p.x * place.x + p.y * place.y + p.z * place.z);
  }
};

/// A facet, counterclockwise seen from the light; or one that is seen edge-on.
struct LitFacet {
  Corners corners;
  bool is_edge_on = false;
  double depth = 0;
};

class Builder {
 public:
  Builder(const Source& source, Tree& tree) : source_(source), tree_(tree) {}

  void add(const ConvexBlocker& blocker) {
    if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
      Corners corners;
      for (const std::uint32_t i : polygon->corners()) corners.push_back(polygon->points()[i]);
      const int side = source_.side_of(corners[0], corners[1], corners[2]);
      if (side < 0) std::reverse(corners.begin(), corners.end());
      add_facet(std::move(corners), side == 0);
      return;
    }
    const auto& solid = std::get<ConvexSolid>(blocker);
    bool any_lit = false;
    for (const ConvexSolid::Facet& facet : solid.facets()) {
      Corners corners;
      for (const std::uint32_t i : facet.loop) corners.push_back(solid.points()[i]);
      const int side = source_.side_of(corners[0], corners[1], corners[2]);
      any_lit = any_lit || side > 0;
      if (side >= 0) add_facet(std::move(corners), side == 0);
    }
    tree_.is_open = tree_.is_open || !any_lit;
  }

  /// Front to back, so that what lies behind is seen to do so.
  void build() {
    std::stable_sort(facets_.begin(), facets_.end(),
                     [](const LitFacet& a, const LitFacet& b) { return a.depth < b.depth; });
    for (const LitFacet& facet : facets_) {
      const Corners& c = facet.corners;
      corners_ = &c;
      if (facet.is_edge_on) {
        divide(tree_.root, c);
        continue;
      }
      facet_ = static_cast<std::uint32_t>(tree_.facets.size());
      tree_.facets.push_back(SignedPlane::through(c[0], c[1], c[2]));
      insert(tree_.root, viewpoint::fragment_of(c));
    }
  }

 private:
  void add_facet(Corners corners, bool is_edge_on) {
    double depth = HUGE_VAL;
    for (const Point3& p : corners) {
      depth = std::min(depth, source_.depth(p));
      if (!viewpoint::is_in_range(p)) tree_.is_open = true;
    }
    facets_.push_back({std::move(corners), is_edge_on, depth});
  }

  /// The facet is on the plane's positive side: it runs counterclockwise seen from the light.
  SignedPlane plane_of_edge(std::int32_t edge) const {
    const Corners& c = *corners_;
    const auto k = static_cast<std::size_t>(edge);
    const SignedPlane plane = source_.plane_through(c[k], c[(k + 1) % c.size()]);
    return plane.side(c[(k + 2) % c.size()]) > 0 ? plane : plane.reversed();
  }

  int side_of_facet(std::uint32_t facet, const FragmentCorner& corner) const {
    return tree_.facets[facet].side(corner.near, corner.point);
  }

  /// True if no corner lies before the facet.
  bool is_behind(const Fragment& fragment, std::uint32_t facet) const {
    return std::all_of(fragment.begin(), fragment.end(),
                       [&](const FragmentCorner& corner) { return side_of_facet(facet, corner) <= 0; });
  }

  bool is_before(const Fragment& fragment, std::uint32_t facet) const {
    return std::all_of(fragment.begin(), fragment.end(),
                       [&](const FragmentCorner& corner) { return side_of_facet(facet, corner) >= 0; });
  }

  void insert(Tree::Place& place, const Fragment& fragment) {
    if (fragment.empty()) return;
    if (place < 0) return put_into_leaf(place, fragment);
    const auto node = static_cast<std::size_t>(place);
    const viewpoint::SplitFragment parts = viewpoint::split(fragment, tree_.nodes[node].plane);
    // Nodes move in memory while others are added.
    for (const auto& [part, child] :
         {std::pair{&parts.positive, &Tree::Node::positive}, std::pair{&parts.negative, &Tree::Node::negative}}) {
      Tree::Place next = tree_.nodes[node].*child;
      insert(next, *part);
      tree_.nodes[node].*child = next;
    }
  }

  /// Cuts the cell along the facet's own edges, and notes the facet where it hides all.
  void put_into_leaf(Tree::Place& place, Fragment fragment) {
    std::vector<std::uint32_t> list = tree_.leaves[Tree::leaf_of(place)];
    if (std::any_of(list.begin(), list.end(), [&](std::uint32_t a) { return is_behind(fragment, a); })) return;
    Tree::Place* inside = &place;
    Tree::Place outer = place;
    std::vector<std::size_t> made;
    for (FragmentCorner& corner : fragment) {
      if (corner.edge < 0) continue;
      made.push_back(tree_.nodes.size());
      const Tree::Place outside = tree_.add_leaf(list);
      tree_.nodes.push_back({plane_of_edge(corner.edge), outer, outside});
      corner.edge = -1;
    }
    std::erase_if(list, [&](std::uint32_t a) { return is_before(fragment, a); });
    list.push_back(facet_);
    tree_.leaves[Tree::leaf_of(outer)] = std::move(list);
    // Each new node is the inside of the one before.
    for (std::size_t k = 0; k + 1 < made.size(); ++k) {
      tree_.nodes[made[k]].positive = static_cast<Tree::Place>(made[k + 1]);
    }
    if (!made.empty()) *inside = static_cast<Tree::Place>(made.front());
  }

  /// Puts the plane of a facet seen edge-on into every cell that may hold some of it: points in that plane are found.
  void divide(Tree::Place& place, const Corners& corners) {
    if (place < 0) {
      const std::vector<std::uint32_t> list = tree_.leaves[Tree::leaf_of(place)];
      const Tree::Place other = tree_.add_leaf(list);
      tree_.nodes.push_back({SignedPlane::through(corners[0], corners[1], corners[2]), place, other});
      place = static_cast<Tree::Place>(tree_.nodes.size() - 1);
      return;
    }
    const auto node = static_cast<std::size_t>(place);
    bool positive = false, negative = false;
    for (const Point3& p : corners) {
      const int side = tree_.nodes[node].plane.side(p);
      positive = positive || side > 0;
      negative = negative || side < 0;
    }
    for (const auto& [is_there, child] :
         {std::pair{positive, &Tree::Node::positive}, std::pair{negative, &Tree::Node::negative}}) {
      if (!is_there) continue;
      Tree::Place next = tree_.nodes[node].*child;
      divide(next, corners);
      tree_.nodes[node].*child = next;
    }
  }

  Source source_;
  Tree& tree_;
  std::vector<LitFacet> facets_;
  const Corners* corners_ = nullptr;  ///< of the facet that is being put in
  std::uint32_t facet_ = 0;
};

}  // namespace

void add_shadows(const ShadowTree::SmallLight& light, std::span<const ConvexBlocker> blockers,
                 ShadowTree::Content& tree) {
  const Source source(light);
  tree.root = tree.add_leaf({});
  if (source.is_near) tree.light = source.place;
  tree.is_open = !viewpoint::is_in_range(source.place);
  Builder builder(source, tree);
  for (const ConvexBlocker& blocker : blockers) builder.add(blocker);
  if (!tree.is_open) builder.build();
}

}  // namespace gnomon
