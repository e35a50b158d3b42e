#include "geometry/visibility/blocker_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/box_tree.h"

namespace gnomon {
namespace {

/// Below this many blockers looking at each of them is faster than a search.
constexpr std::size_t smallest_tree = 24;

std::span<const Point3> points_of(const ConvexBlocker& blocker) {
  return std::visit([](const auto& shape) { return shape.points(); }, blocker);
}

Box3 box_around(std::span<const Point3> points) {
  Box3 box{points.front(), points.front()};
  for (const Point3& p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  return box;
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
