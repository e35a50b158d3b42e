#include "geometry/visibility/blocker_set.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/bodies/boxes.h"
#include "geometry/visibility/blocker_content.h"

namespace gnomon {
namespace {

/// Below this many blockers looking at each of them is faster than a search.
constexpr std::size_t smallest_tree = 24;

std::span<const Point3> points_of(const ConvexBlocker& blocker) {
  return std::visit([](const auto& shape) { return shape.points(); }, blocker);
}

double largest_coordinate(const Box3& box) {
  double largest = 0;
  for (const Point3& p : {box.min, box.max}) {
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  return largest;
}

void append(BlockerSet::Content& content, const ConvexPolygon& polygon) {
  BlockerSet::Content::Shape shape;
  shape.first = static_cast<std::uint32_t>(content.points.size());
  shape.count = static_cast<std::uint32_t>(polygon.corners().size());
  for (std::uint32_t k = 0; k < shape.count; ++k) {
    content.points.push_back(polygon.points()[polygon.corners()[k]]);
    content.names.push_back(polygon.side_edge(k));
  }
  content.shapes.push_back(shape);
}

void append(BlockerSet::Content& content, const ConvexSolid& solid) {
  BlockerSet::Content::Shape shape;
  shape.solid = static_cast<std::int32_t>(content.solids.size());
  content.solids.push_back(solid);
  content.shapes.push_back(shape);
}

/// An edge of a flat blocker, its lower end first.
struct FlatEdge {
  Point3 low;
  Point3 high;
  std::uint32_t shape = 0;
  std::uint32_t place = 0;  ///< of its start in `points`
  bool falls = false;       ///< it starts at the higher end
};

auto ends(const FlatEdge& e) {
  return std::tie(e.low.x, e.low.y, e.low.z, e.high.x, e.high.y, e.high.z);
}

void find_mates(BlockerSet::Content& content) {
  using Content = BlockerSet::Content;
  std::vector<FlatEdge> edges;
  edges.reserve(content.points.size());
  for (std::uint32_t s = 0; s < content.shapes.size(); ++s) {
    const Content::Shape& shape = content.shapes[s];
    for (std::uint32_t k = 0; k < shape.count && shape.solid < 0; ++k) {
      const Point3 &a = content.points[shape.first + k], &b = content.points[shape.first + (k + 1) % shape.count];
      const bool falls = std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z);
      edges.push_back({falls ? b : a, falls ? a : b, s, shape.first + k, falls});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const FlatEdge& e, const FlatEdge& f) { return ends(e) < ends(f); });
  content.mates.assign(content.points.size(), {});
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    while (next < edges.size() && ends(edges[next]) == ends(edges[i])) ++next;
    if (next - i != 2) continue;
    const FlatEdge &e = edges[i], &f = edges[i + 1];
    content.mates[e.place] = {f.shape, e.falls != f.falls};
    content.mates[f.place] = {e.shape, e.falls != f.falls};
  }
}

/// Largest value of dot(normal, x - apex) over the box, and the size of its farthest corner.
struct Reach {
  double value;
  double size;
};

Reach reach(const Box3& box, const Point3& apex, const viewpoint::Vector& normal) {
  const viewpoint::Vector low{box.min.x - apex.x, box.min.y - apex.y, box.min.z - apex.z};
  const viewpoint::Vector high{box.max.x - apex.x, box.max.y - apex.y, box.max.z - apex.z};
  const viewpoint::Vector far{normal.x > 0 ? high.x : low.x, normal.y > 0 ? high.y : low.y,
                              normal.z > 0 ? high.z : low.z};
  return {dot(normal, far), std::max(viewpoint::size_of(low), viewpoint::size_of(high))};
}

/// A box is outside if a plane of the pyramid says so with more than the rounding of its normal, of the differences and
/// of the product: `side_bound` times the size, as for a single ray.
bool may_meet(const Box3& box, const LightPyramid& pyramid) {
  for (const viewpoint::Plane& plane : pyramid.sides) {
    const Reach out = reach(box, pyramid.apex, plane.normal);
    if (out.value < -(plane.side_bound * out.size + viewpoint::tiny)) return false;
  }
  const viewpoint::Vector& forward = pyramid.base.normal;
  const Reach deepest = reach(box, pyramid.apex, forward);
  const double bound = pyramid.base.depth_error(deepest.size, viewpoint::unit * deepest.size);
  if (deepest.value < -bound) return false;
  const Reach nearest = reach(box, pyramid.apex, {-forward.x, -forward.y, -forward.z});
  return -nearest.value <= pyramid.base.height + pyramid.base.height_error + bound;
}

/// A line of sight, as shares of the way along it.
struct Way {
  Point3 from;
  viewpoint::Vector step;
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
  first = std::max(first, enter - 8 * viewpoint::unit * std::fabs(enter) - viewpoint::tiny);
  last = std::min(last, leave + 8 * viewpoint::unit * std::fabs(leave) + viewpoint::tiny);
  return first <= last;
}

bool may_meet(const Box3& box, const Way& way) {
  double first = 0;
  double last = way.last;
  return cut_to_slab(box.min.x - way.from.x, box.max.x - way.from.x, way.step.x, first, last) &&
         cut_to_slab(box.min.y - way.from.y, box.max.y - way.from.y, way.step.y, first, last) &&
         cut_to_slab(box.min.z - way.from.z, box.max.z - way.from.z, way.step.z, first, last);
}

}  // namespace

BlockerSet::BlockerSet(std::span<const ConvexBlocker> blockers) {
  auto content = std::make_shared<Content>();
  content->shapes.reserve(blockers.size());
  std::vector<Box3> boxes;
  boxes.reserve(blockers.size());
  for (const ConvexBlocker& blocker : blockers) {
    boxes.push_back(box_around(points_of(blocker)));
    content->largest = std::max(content->largest, largest_coordinate(boxes.back()));
    std::visit([&](const auto& shape) { append(*content, shape); }, blocker);
  }
  find_mates(*content);
  if (blockers.size() >= smallest_tree) {
    content->boxes = BoxHierarchy(boxes);
  } else {
    content->few_boxes = std::move(boxes);
  }
  content_ = std::move(content);
}

std::size_t BlockerSet::size() const {
  return content_->shapes.size();
}

std::size_t BlockerSet::Content::collect(const LightPyramid& pyramid, std::vector<std::uint32_t>& found) const {
  const auto meets = [&](const Box3& box) { return may_meet(box, pyramid); };
  if (boxes.empty()) {
    collect_few(meets, found);
    return shapes.size();
  }
  const std::size_t visited = boxes.search(meets, found);
  std::sort(found.begin(), found.end());
  return visited;
}

void BlockerSet::Content::collect_along(const LineBetween& line, std::vector<std::uint32_t>& found) const {
  const Point3 origin = line.ends ? line.from : Point3{0, 0, 0};
  const Way way{line.from, viewpoint::operator-(line.to, origin), line.ends ? 1 : HUGE_VAL};
  const auto meets = [&](const Box3& box) { return may_meet(box, way); };
  if (boxes.empty()) return collect_few(meets, found);
  boxes.search(meets, found);
}

void BlockerSet::Content::collect_near(const Point3& p, std::vector<std::uint32_t>& found) const {
  const double size = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const double off = 16 * viewpoint::unit * size;
  const Box3 near{{p.x - off, p.y - off, p.z - off}, {p.x + off, p.y + off, p.z + off}};
  const auto meets = [&](const Box3& box) { return overlap(box, near); };
  if (boxes.empty()) return collect_few(meets, found);
  boxes.search(meets, found);
  std::sort(found.begin(), found.end());
}

}  // namespace gnomon
