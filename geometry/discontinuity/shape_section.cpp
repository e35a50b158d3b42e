#include "geometry/discontinuity/shape_section.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gnomon::event {
namespace {

/// The sides of a pencil's plane on which a shape's corners lie: -1, 0, +1. Most shapes are small, and many are asked.
class CornerSides {
 public:
  CornerSides(const Pencil& pencil, const Shape& shape) : corners_(shape.corners) {
    if (corners_.size() > few_.size()) many_.resize(corners_.size());
    int* sides = corners_.size() > few_.size() ? many_.data() : few_.data();
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      sides[k] = pencil.side(corners_[k]);
      all_.add(sides[k]);
    }
  }

  bool are_both() const { return all_.cross(); }
  int of_corner(std::size_t k) const { return many_.empty() ? few_[k] : many_[k]; }
  int of_point(PointId p) const {
    return of_corner(static_cast<std::size_t>(std::find(corners_.begin(), corners_.end(), p) - corners_.begin()));
  }

 private:
  const std::vector<PointId>& corners_;
  std::array<int, 16> few_{};
  std::vector<int> many_;
  Sides all_;
};

/// A flat convex shape is cut in a segment: its ends are the corners in the plane and the edges that cross it, two in
/// all, for its boundary passes from one side to the other and back once.
void cut_flat(Pencil& pencil, const Shape& shape, const CornerSides& sides, std::vector<NodeId>& nodes) {
  const std::size_t n = shape.corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    const int here = sides.of_corner(k), there = sides.of_corner(next);
    if (here == 0) nodes.push_back(pencil.add_point(shape.corners[k]));
    if (here * there < 0) {
      nodes.push_back(here > 0 ? pencil.add_crossing(shape.corners[k], shape.corners[next])
                               : pencil.add_crossing(shape.corners[next], shape.corners[k]));
    }
  }
}

/// The section of a solid: each facet that is cut in two, or along an edge, joins two nodes; these links make one
/// cycle, the section's boundary.
class SolidCut {
 public:
  SolidCut(Pencil& pencil, const CornerSides& sides) : pencil_(pencil), sides_(sides) {}

  /// A facet is cut in a segment between two nodes, or is missed, or touched at a corner. None lies in the plane: the
  /// solid would be on one side of it. An edge in the plane is a link of both its facets, and counts once.
  void add_facet(const std::vector<PointId>& loop) {
    NodeId ends[2] = {0, 0};
    std::size_t count = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const PointId p = loop[k], q = loop[(k + 1) % loop.size()];
      const int s = sides_.of_point(p), t = sides_.of_point(q);
      if (s != 0 && s * t >= 0) continue;
      if (count < 2) ends[count] = node_on(p, s == 0 ? p : q);
      ++count;
    }
    if (count != 2) return;
    const std::pair<NodeId, NodeId> link = std::minmax(ends[0], ends[1]);
    if (std::find(links_.begin(), links_.end(), link) == links_.end()) links_.push_back(link);
  }

  /// Walks along the links, from the first.
  void append_cycle(std::vector<NodeId>& nodes) {
    NodeId at = links_.front().second;
    nodes.push_back(links_.front().first);
    links_.erase(links_.begin());
    while (!links_.empty()) {
      nodes.push_back(at);
      const auto next =
          std::find_if(links_.begin(), links_.end(), [&](const auto& l) { return l.first == at || l.second == at; });
      if (next == links_.end()) break;
      at = next->first == at ? next->second : next->first;
      links_.erase(next);
    }
  }

 private:
  struct Made {
    PointId p, q;
    NodeId node;
  };

  /// The node at a corner (p == q), or where an edge crosses the plane; both facets at an edge get the same one.
  NodeId node_on(PointId p, PointId q) {
    const auto [low, high] = std::minmax(p, q);
    for (const Made& m : made_) {
      if (m.p == low && m.q == high) return m.node;
    }
    const NodeId node = p == q                   ? pencil_.add_point(p)
                        : sides_.of_point(p) > 0 ? pencil_.add_crossing(p, q)
                                                 : pencil_.add_crossing(q, p);
    made_.push_back({low, high, node});
    return node;
  }

  Pencil& pencil_;
  const CornerSides& sides_;
  std::vector<Made> made_;
  std::vector<std::pair<NodeId, NodeId>> links_;
};

}  // namespace

bool section(Pencil& pencil, const Shape& shape, std::vector<NodeId>& nodes) {
  nodes.clear();
  const CornerSides sides(pencil, shape);
  if (!sides.are_both()) return false;
  if (!shape.is_solid) {
    cut_flat(pencil, shape, sides, nodes);
    return true;
  }
  SolidCut cut(pencil, sides);
  for (const auto& loop : shape.facets) cut.add_facet(loop);
  cut.append_cycle(nodes);
  return true;
}

}  // namespace gnomon::event
