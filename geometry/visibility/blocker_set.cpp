#include "geometry/visibility/blocker_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/bodies/boxes.h"
#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/box_tree.h"

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
  if (blockers.size() >= smallest_tree) content->tree = box_tree(boxes);
  content_ = std::move(content);
}

std::size_t BlockerSet::size() const {
  return content_->shapes.size();
}

void BlockerSet::Content::collect(const LightPyramid& pyramid, std::vector<std::uint32_t>& found) const {
  if (!tree) return collect_all(found);
  found.clear();
  append_boxes_in(*tree, pyramid, found);
  std::sort(found.begin(), found.end());
}

void BlockerSet::Content::collect_along(const SightLine& line, std::vector<std::uint32_t>& found) const {
  if (!tree) return collect_all(found);
  found.clear();
  append_boxes_along(*tree, line, found);
}

void BlockerSet::Content::collect_near(const Point3& p, std::vector<std::uint32_t>& found) const {
  if (!tree) return collect_all(found);
  found.clear();
  const double size = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const double off = 16 * sight::unit * size;
  append_boxes_near(*tree, {{p.x - off, p.y - off, p.z - off}, {p.x + off, p.y + off, p.z + off}}, found);
  std::sort(found.begin(), found.end());
}

void BlockerSet::Content::collect_all(std::vector<std::uint32_t>& found) const {
  found.resize(shapes.size());
  std::iota(found.begin(), found.end(), 0U);
}

}  // namespace gnomon
