#include "geometry/visibility/box_tree.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

namespace gnomon {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;

struct NamedBox {
  using Id = std::uint32_t;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Iso_cuboid_3;

  Id name = 0;
  Datum box;

  Id id() const { return name; }
  const Datum& datum() const { return box; }
  Point reference_point() const { return box.min(); }
};

using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, NamedBox>>;

/// Largest value of dot(normal, x - apex) over the box, and the size of its farthest corner.
struct Reach {
  double value;
  double size;
};

Reach reach(const CGAL::Bbox_3& box, const Point3& apex, const sight::Vector& normal) {
  const sight::Vector low{box.xmin() - apex.x, box.ymin() - apex.y, box.zmin() - apex.z};
  const sight::Vector high{box.xmax() - apex.x, box.ymax() - apex.y, box.zmax() - apex.z};
  const sight::Vector far{normal.x > 0 ? high.x : low.x, normal.y > 0 ? high.y : low.y, normal.z > 0 ? high.z : low.z};
  return {dot(normal, far), std::max(sight::size_of(low), sight::size_of(high))};
}

/// A box is outside if a plane of the pyramid says so with more than the rounding of its normal, of the differences and
/// of the product: `side_bound` times the size, as for a single ray.
bool may_meet(const CGAL::Bbox_3& box, const LightPyramid& pyramid) {
  for (const sight::Plane& plane : pyramid.sides) {
    const Reach out = reach(box, pyramid.apex, plane.normal);
    if (out.value < -(plane.side_bound * out.size + sight::tiny)) return false;
  }
  const sight::Vector& forward = pyramid.base.normal;
  const Reach deepest = reach(box, pyramid.apex, forward);
  const double bound = pyramid.base.depth_error(deepest.size, sight::unit * deepest.size);
  if (deepest.value < -bound) return false;
  const Reach nearest = reach(box, pyramid.apex, {-forward.x, -forward.y, -forward.z});
  return -nearest.value <= pyramid.base.height + pyramid.base.height_error + bound;
}

/// A line of sight, as shares of the way along it.
struct Way {
  Point3 from;
  sight::Vector step;
  double last = 1;  ///< share at which it ends
};

/// Cuts the shares to those in a slab. Bound. Differences and quotient are rounded: 3 u of a share, and what
/// underflows. False if none is left.
bool cut_to_slab(double low, double high, double step, double& first, double& last) {
  if (step == 0) return low <= 0 && high >= 0;
  const double a = low / step;
  const double b = high / step;
  const double enter = std::min(a, b);
  const double leave = std::max(a, b);
  first = std::max(first, enter - 8 * sight::unit * std::fabs(enter) - sight::tiny);
  last = std::min(last, leave + 8 * sight::unit * std::fabs(leave) + sight::tiny);
  return first <= last;
}

bool may_meet(const CGAL::Bbox_3& box, const Way& way) {
  double first = 0;
  double last = way.last;
  return cut_to_slab(box.xmin() - way.from.x, box.xmax() - way.from.x, way.step.x, first, last) &&
         cut_to_slab(box.ymin() - way.from.y, box.ymax() - way.from.y, way.step.y, first, last) &&
         cut_to_slab(box.zmin() - way.from.z, box.zmax() - way.from.z, way.step.z, first, last);
}

bool may_meet(const CGAL::Bbox_3& box, const Box3& other) {
  return box.xmin() <= other.max.x && other.min.x <= box.xmax() && box.ymin() <= other.max.y &&
         other.min.y <= box.ymax() && box.zmin() <= other.max.z && other.min.z <= box.zmax();
}

/// CGAL's way of asking: which nodes to enter, and what to do with the primitives below.
template <class Query>
struct Search {
  std::vector<std::uint32_t>& found;

  bool go_further() const { return true; }
  void intersection(const Query& query, const NamedBox& box) {
    if (may_meet(box.datum().bbox(), query)) found.push_back(box.id());
  }
  template <class Node>
  bool do_intersect(const Query& query, const Node& node) const {
    return may_meet(node.bbox(), query);
  }
};

}  // namespace

class BoxTree {
 public:
  explicit BoxTree(const std::vector<NamedBox>& boxes) {
    for (const NamedBox& box : boxes) tree_.insert(box);
    tree_.build();
  }

  template <class Query>
  void search(const Query& query, std::vector<std::uint32_t>& found) const {
    Search<Query> search{found};
    tree_.traversal(query, search);
  }

 private:
  Tree tree_;
};

std::shared_ptr<const BoxTree> box_tree(std::span<const Box3> boxes) {
  std::vector<NamedBox> named;
  named.reserve(boxes.size());
  for (const Box3& box : boxes) {
    const Kernel::Point_3 low(box.min.x, box.min.y, box.min.z);
    const Kernel::Point_3 high(box.max.x, box.max.y, box.max.z);
    named.push_back({static_cast<std::uint32_t>(named.size()), Kernel::Iso_cuboid_3(low, high)});
  }
  return std::make_shared<const BoxTree>(named);
}

void append_boxes_in(const BoxTree& tree, const LightPyramid& pyramid, std::vector<std::uint32_t>& found) {
  tree.search(pyramid, found);
}

void append_boxes_near(const BoxTree& tree, const Box3& box, std::vector<std::uint32_t>& found) {
  tree.search(box, found);
}

void append_boxes_along(const BoxTree& tree, const SightLine& line, std::vector<std::uint32_t>& found) {
  const Point3 origin = line.ends ? line.from : Point3{0, 0, 0};
  tree.search(Way{line.from, sight::operator-(line.to, origin), line.ends ? 1 : HUGE_VAL}, found);
}

}  // namespace gnomon
