#include "viz/pictures/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "viz/vtk/vector.h"

namespace gnomon::viz {
namespace {

constexpr int most_rounds = 100;

/// How far two boxes reach into each other; not at all where a number is not positive.
struct Overlap {
  double x;
  double y;
};

Overlap overlap_of(const LabelBox& a, const LabelBox& b) {
  return {(a.width + b.width) / 2 - std::abs(a.x - b.x), (a.height + b.height) / 2 - std::abs(a.y - b.y)};
}

/// Returns: whether something has moved.
bool push(LabelBox& a, LabelBox& b) {
  if (!overlap(a, b)) return false;
  const Overlap both = overlap_of(a, b);
  double LabelBox::*const way = both.y <= both.x ? &LabelBox::y : &LabelBox::x;
  const double half = (std::min(both.x, both.y) + 0.1) / 2 * (a.*way <= b.*way ? -1 : 1);
  a.*way += half;
  b.*way -= half;
  return true;
}

void keep_inside(LabelBox& box, const DrawingSize& frame) {
  box.x = std::max(box.width / 2, std::min(frame.width - box.width / 2, box.x));
  box.y = std::max(box.height / 2, std::min(frame.height - box.height / 2, box.y));
}

using Triangle = std::array<Point3, 3>;

/// The opaque surfaces that are seen from the viewer's side.
std::vector<Triangle> opaque_triangles(std::span<const PictureItem> items, const Point3& viewer) {
  std::vector<Triangle> triangles;
  for (const PictureItem& item : items) {
    if (item.look.opacity < 1 || item.in_corner || item.data->GetNumberOfPolys() == 0) continue;
    if (item.front && item.front->distance(viewer) <= 0) continue;
    for (const Polygon& polygon : polygons_of(*item.data)) {
      for (std::size_t i = 2; i < polygon.size(); ++i) triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }
  }
  return triangles;
}

/// Whether the segment from the viewer meets the triangle before its end.
bool hides(const Triangle& triangle, const Point3& viewer, const Point3& way, double slack) {
  const Point3 first = triangle[1] - triangle[0];
  const Point3 second = triangle[2] - triangle[0];
  const Point3 normal = cross(first, second);
  const double slope = dot(normal, way);
  if (slope == 0) return false;
  const Point3 start = viewer - triangle[0];
  const double at = -dot(normal, start) / slope;
  if (!(at > 0 && at * length(way) < length(way) - slack)) return false;
  const Point3 q = start + at * way;
  const double u = dot(cross(q, second), normal) / dot(normal, normal);
  const double v = dot(cross(first, q), normal) / dot(normal, normal);
  return u >= 0 && v >= 0 && u + v <= 1;
}

/// A camera as a map from space to pixels.
class Screen {
 public:
  Screen(const PictureView& view, const DrawingSize& size)
      : view_(view),
        size_(size),
        toward_(unit(view.position - view.focus)),
        right_(unit(cross(view.up, toward_))),
        up_(cross(toward_, right_)),
        scale_(size.height / 2 / std::tan(view.angle / 2 * std::acos(-1.0) / 180)) {}

  /// Nothing where the point lies behind the viewer or outside of the picture.
  std::optional<LabelBox> place(const Point3& p) const {
    const Point3 d = p - view_.position;
    const double depth = -dot(d, toward_);
    if (!(depth > 0)) return std::nullopt;
    const LabelBox at{size_.width / 2 + scale_ * dot(d, right_) / depth,
                      size_.height / 2 - scale_ * dot(d, up_) / depth};
    const bool inside = at.x >= 0 && at.x <= size_.width && at.y >= 0 && at.y <= size_.height;
    return inside ? std::optional(at) : std::nullopt;
  }

 private:
  PictureView view_;
  DrawingSize size_;
  Point3 toward_, right_, up_;
  double scale_;
};

/// What a viewer sees of a picture.
struct ViewedPicture {
  std::vector<Triangle> opaque;
  Screen screen;
  Point3 viewer;
  double slack;  ///< so near to its end nothing hides a place: it lies on a surface

  bool is_seen(const Point3& place) const {
    const Point3 way = place - viewer;
    return screen.place(place) &&
           std::ranges::none_of(opaque, [&](const Triangle& triangle) { return hides(triangle, viewer, way, slack); });
  }

  /// Where the first place of the label that is seen lies in the picture; nothing if none is.
  std::optional<LabelBox> place_of(const PictureLabel& label) const {
    if (label.front && label.front->distance(viewer) <= 0) return std::nullopt;
    const auto seen = std::ranges::find_if(label.places, [&](const Point3& place) { return is_seen(place); });
    return seen == label.places.end() ? std::nullopt : screen.place(*seen);
  }
};

/// Words below the arrow in the corner, which is as far from the sides as it is high.
LabelBox corner_place(const DrawingSize& size) {
  return {size.width - 0.1 * size.height, 0.19 * size.height};
}

}  // namespace

LabelBox label_box(const std::string& text, double letter, double x, double y) {
  const auto letters =
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  // A letter of these typefaces is a little more than half as wide as it is high.
  return {x, y, 0.62 * letter * static_cast<double>(letters) + 4, 1.4 * letter};
}

bool overlap(const LabelBox& a, const LabelBox& b) {
  const Overlap both = overlap_of(a, b);
  return both.x > 0.01 && both.y > 0.01;
}

std::vector<std::size_t> pushed_apart(std::vector<LabelBox>& boxes, const DrawingSize& frame) {
  bool moved = true;
  for (int round = 0; moved && round < most_rounds; ++round) {
    moved = false;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = i + 1; k < boxes.size(); ++k) moved |= push(boxes[i], boxes[k]);
    }
    for (LabelBox& box : boxes) keep_inside(box, frame);
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto meets = [&](std::size_t k) { return overlap(boxes[i], boxes[k]); };
    if (std::ranges::none_of(kept, meets)) kept.push_back(i);
  }
  return kept;
}

std::vector<PlacedLabel> placed_labels(std::span<const PictureLabel> labels, std::span<const PictureItem> items,
                                       const PictureScene& scene, const PictureView& view, const DrawingSize& size,
                                       double letter) {
  std::vector<PlacedLabel> placed;
  std::vector<LabelBox> boxes;
  const ViewedPicture viewed{opaque_triangles(items, view.position), Screen(view, size), view.position,
                             2e-3 * scene.size};
  for (const PictureLabel& label : labels) {
    const std::optional<LabelBox> at = label.in_corner ? corner_place(size) : viewed.place_of(label);
    if (!at) continue;
    boxes.push_back(label_box(label.text, letter, at->x, at->y));
    placed.push_back({label.text, {}, at->x, at->y});
  }
  std::vector<PlacedLabel> kept;
  for (const std::size_t i : pushed_apart(boxes, size)) {
    placed[i].box = boxes[i];
    placed[i].is_led = std::abs(boxes[i].x - placed[i].from_x) >= boxes[i].width / 2 ||
                       std::abs(boxes[i].y - placed[i].from_y) >= boxes[i].height / 2;
    kept.push_back(placed[i]);
  }
  return kept;
}

}  // namespace gnomon::viz
