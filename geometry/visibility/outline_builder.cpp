#include "geometry/visibility/outline_builder.h"

#include <algorithm>
#include <array>

#include "geometry/numbers/orientation.h"

namespace gnomon::sight {

OutlineBuilder::OutlineBuilder(const Point3& apex, const LightSide& light, Outlines& outlines)
    : apex_(apex),
      extent_(Extent::area),
      light_corners_(light.corners),
      depth_corners_(light.corners),
      plane_(light.plane),
      outlines_(outlines) {
  outlines_.clear();
  append_rays(light_corners_);
  append_planes(light.names, false);
  append_light(light.flats, light.box);
}

/// The outline has two rays and the plane through both, one way and the other. The pyramid's other sides stand upright
/// on it.
OutlineBuilder::OutlineBuilder(const Point3& apex, std::span<const Point3, 3> ends, const LightPlane& plane,
                               Outlines& outlines, Along along)
    : apex_(apex),
      extent_(Extent::length),
      along_(along),
      light_corners_(ends.first<2>()),
      depth_corners_(ends),
      plane_(plane),
      outlines_(outlines) {
  constexpr std::array<std::uint32_t, 2> names = {0, 0};
  outlines_.clear();
  append_rays(light_corners_);
  append_planes(names, false);
  const Ray beside(apex, ends[2]);
  outlines_.sides = {outlines_.planes[0], outlines_.planes[1], Plane(beside, outlines_.rays[0], 0),
                     Plane(outlines_.rays[1], beside, 0)};
  append_light({}, {});
}

Seen OutlineBuilder::look_at(const BlockerSet::Content& blockers, std::uint32_t blocker) {
  const BlockerSet::Content::Shape& shape = blockers.shapes[blocker];
  if (shape.solid >= 0) return append_solid(blockers.solids[static_cast<std::size_t>(shape.solid)], blocker);
  const std::span<const std::uint32_t> names{blockers.names.data() + shape.first, shape.count};
  return append_flat(blockers.corners(shape), names, blocker);
}

Gathered OutlineBuilder::append_blockers(const BlockerSet::Content& blockers,
                                         std::span<const std::uint32_t> candidates) {
  Gathered result = Gathered::outlined;
  for (const std::uint32_t candidate : candidates) {
    const Seen seen = look_at(blockers, candidate);
    if (seen == Seen::covers) return Gathered::covered;
    if (seen == Seen::undecided) result = Gathered::undecided;
  }
  return result;
}

void OutlineBuilder::append_rays(std::span<const Point3> corners) {
  first_ = static_cast<std::uint32_t>(outlines_.rays.size());
  for (const Point3& corner : corners) outlines_.rays.emplace_back(apex_, corner);
}

/// Reversed, ray k is corner count - 1 - k; the edge to ray k + 1 is the one that ends there in the order given.
void OutlineBuilder::append_planes(std::span<const std::uint32_t> names, bool reversed) {
  const std::size_t count = names.size();
  const Ray* rays = outlines_.rays.data() + first_;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = k + 1 == count ? 0 : k + 1;
    const std::size_t original = !reversed ? k : next == 0 ? count - 1 : count - 1 - next;
    outlines_.planes.emplace_back(rays[k], rays[next], names[original]);
  }
}

/// Turns the rays that were appended round, and what is known of them.
void OutlineBuilder::reverse_rays() {
  const auto count = static_cast<std::ptrdiff_t>(outlines_.rays.size() - first_);
  std::reverse(outlines_.rays.begin() + first_, outlines_.rays.end());
  const auto planes = static_cast<std::ptrdiff_t>(outlines_.pyramid().size());
  auto row = outlines_.at_pyramid.begin() + planes * first_;
  for (std::ptrdiff_t i = 0; i < planes; ++i, row += count) std::reverse(row, row + count);
}

/// Appends the planes of the rays that were appended, these turned round where they run clockwise; 0 if they are seen
/// edge-on.
int OutlineBuilder::append_counterclockwise(std::span<const std::uint32_t> names) {
  const Ray* rays = outlines_.rays.data() + first_;
  const int turn = side(apex_, Plane(rays[0], rays[1], 0), rays[2]);
  reversed_ = turn < 0;
  if (turn < 0) reverse_rays();
  if (turn != 0) append_planes(names, turn < 0);
  return turn;
}

/// Closes the light's outline.
void OutlineBuilder::append_light(std::span<const FlatPoint> flats, const FlatBox& box) {
  outlines_.flats.assign(flats.begin(), flats.end());
  outlines_.list.push_back({0, static_cast<std::uint32_t>(outlines_.rays.size()), 0, false, box});
}

Seen OutlineBuilder::dropped() {
  outlines_.rays.resize(first_);
  outlines_.planes.resize(first_);
  return Seen::apart;
}

/// Notes on which side of the pyramid's planes the rays run, as far as doubles know and until one of the planes has all
/// rays outside: then true.
bool OutlineBuilder::certainly_outside() {
  const std::span<const Plane> pyramid = outlines_.pyramid();
  const std::size_t count = outlines_.rays.size() - first_;
  const Ray* rays = outlines_.rays.data() + first_;
  if (outlines_.at_pyramid.size() < pyramid.size() * outlines_.rays.size()) {
    outlines_.at_pyramid.resize(2 * pyramid.size() * outlines_.rays.size());
  }
  std::int8_t* row = outlines_.at_pyramid.data() + pyramid.size() * first_;
  sides_are_exact_ = true;
  inside_ = true;
  for (const Plane& plane : pyramid) {
    int least = uncertain;
    int most = -1;
    for (std::size_t k = 0; k < count; ++k) {
      row[k] = certain_side(plane, rays[k]);
      least = std::min<int>(least, row[k]);
      most = std::max<int>(most, row[k]);
    }
    if (most == -1) return true;
    sides_are_exact_ = sides_are_exact_ && most != uncertain;
    inside_ = inside_ && least == 1 && most == 1;
    row += count;
  }
  return false;
}

/// Settles what certainly_outside() left uncertain.
void OutlineBuilder::make_sides_exact(const Outline& outline) {
  const std::span<const Plane> pyramid = outlines_.pyramid();
  std::int8_t* row = outlines_.at_pyramid.data() + pyramid.size() * outline.first;
  for (const Plane& plane : pyramid) {
    for (const Ray& ray : outlines_.rays_of(outline)) {
      if (*row == uncertain) *row = static_cast<std::int8_t>(exact_side(apex_, plane, ray));
      ++row;
    }
  }
}

bool OutlineBuilder::certainly_behind_apex() const {
  return std::all_of(outlines_.rays.begin() + first_, outlines_.rays.end(), [&](const Ray& ray) {
    return plane_.depth(ray.direction) < -plane_.depth_error(ray.size, unit * ray.size);
  });
}

OutlineBuilder::Depth OutlineBuilder::depth_of(std::span<const Ray> rays) const {
  bool before = false;
  bool beyond = false;
  int apex_side = 0;
  for (const Ray& ray : rays) {
    const double error = plane_.height_error + plane_.depth_error(ray.size, unit * ray.size);
    const double left = plane_.height - plane_.depth(ray.direction);
    int sign = left > error ? 1 : left < -error ? -1 : 0;
    if (sign == 0) {
      const auto side_of = [&](const Point3& p) {
        return exact_orientation(depth_corners_[0], depth_corners_[1], depth_corners_[2], p);
      };
      if (apex_side == 0) apex_side = side_of(apex_);
      sign = apex_side * side_of(*ray.point);
    }
    before = before || sign > 0;
    beyond = beyond || sign < 0;
  }
  if (!before) return Depth::behind;
  return beyond ? Depth::crossing : Depth::in_front;
}

/// True if two corners lie on a linear light's line: rays then meet what is between them at the light itself, where it
/// hides nothing.
bool OutlineBuilder::runs_along_light(std::span<const Ray> rays) const {
  if (extent_ == Extent::area) return false;
  int on_line = 0;
  for (const Ray& ray : rays) {
    const double error = plane_.height_error + plane_.depth_error(ray.size, unit * ray.size);
    if (std::fabs(plane_.height - plane_.depth(ray.direction)) > error) continue;
    if (exact_orientation(depth_corners_[0], depth_corners_[1], depth_corners_[2], *ray.point) != 0) continue;
    on_line += side(apex_, outlines_.planes.front(), ray) == 0 ? 1 : 0;
  }
  return on_line >= 2;
}

/// Of a flat blocker whose plane holds the apex: true if it holds a linear light as well.
bool OutlineBuilder::hides_edge_on(std::span<const Point3> corners) const {
  return extent_ == Extent::length && std::all_of(light_corners_.begin(), light_corners_.end(), [&](const Point3& end) {
           return exact_orientation(corners[0], corners[1], corners[2], end) == 0;
         });
}

/// Where the light lies with respect to a plane that does not hold the apex. No open segment from the apex passes
/// through the plane to its own side; to the other side every one does.
OutlineBuilder::Beyond OutlineBuilder::light_beyond(const Point3& a, const Point3& b, const Point3& c) const {
  const int apex_side = exact_orientation(a, b, c, apex_);
  bool here = false;
  bool beyond = false;
  for (const Point3& corner : light_corners_) {
    const int side = apex_side * exact_orientation(a, b, c, corner);
    here = here || side > 0;
    beyond = beyond || side < 0;
  }
  return !beyond ? Beyond::none : here ? Beyond::part : Beyond::all;
}

/// Looks from the light's corners to the outline's planes.
Seen OutlineBuilder::seen_by_light(const Outline& outline) {
  const std::span<const Ray> light = outlines_.rays_of(outlines_.list.front());
  if (outlines_.of_light.size() < light.size() * outlines_.planes.size()) {
    outlines_.of_light.resize(2 * light.size() * outlines_.planes.size());
  }
  std::int8_t* row = outlines_.of_light.data() + light.size() * outline.first;
  bool covers = true;
  bool runs_along = false;
  for (const Plane& plane : outlines_.planes_of(outline)) {
    bool apart = true;
    bool along = extent_ == Extent::length;
    for (const Ray& ray : light) {
      const int sign = side(apex_, plane, ray);
      apart = apart && sign <= 0;
      along = along && sign == 0;
      covers = covers && sign >= 0;
      *row++ = static_cast<std::int8_t>(sign);
    }
    if (apart && !along) return Seen::apart;
    runs_along = runs_along || along;
  }
  if (runs_along && along_ == Along::undecided) return Seen::undecided;
  return covers ? Seen::covers : Seen::outlined;
}

/// Closes the outline if it may hide something.
Seen OutlineBuilder::finished(std::uint32_t element) {
  Outline outline;
  outline.first = first_;
  outline.count = static_cast<std::uint32_t>(outlines_.rays.size()) - first_;
  outline.element = element;
  outline.inside = inside_;
  outline.reversed = reversed_;
  const Seen seen = inside_ ? Seen::outlined : seen_by_light(outline);
  if (seen == Seen::apart) return dropped();
  if (seen != Seen::outlined) return seen;
  if (!sides_are_exact_) make_sides_exact(outline);
  outlines_.flats.resize(first_);
  for (const Ray& ray : outlines_.rays_of(outline)) {
    outlines_.flats.push_back(meeting_point(plane_, ray.direction, ray.size, unit * ray.size));
    outline.box.include(outlines_.flats.back().box());
  }
  outline.box.cut(outlines_.list.front().box);
  outlines_.list.push_back(outline);
  return Seen::outlined;
}

Seen OutlineBuilder::append_flat(std::span<const Point3> corners, std::span<const std::uint32_t> names,
                                 std::uint32_t element) {
  append_rays(corners);
  if (certainly_outside() || certainly_behind_apex()) return dropped();
  const Depth depth = depth_of(std::span(outlines_.rays).subspan(first_));
  if (depth == Depth::behind) return dropped();
  if (append_counterclockwise(names) == 0) {
    const bool open = hides_edge_on(corners);
    dropped();
    return open ? Seen::undecided : Seen::apart;
  }
  if (depth == Depth::in_front) {
    const Seen seen = finished(element);
    if (seen == Seen::apart) return seen;
    return runs_along_light(std::span(outlines_.rays).subspan(first_)) ? Seen::undecided : seen;
  }
  const Beyond beyond = light_beyond(corners[0], corners[1], corners[2]);
  if (beyond == Beyond::none) return dropped();
  const Seen seen = finished(element);
  return beyond == Beyond::part && seen != Seen::apart ? Seen::undecided : seen;
}

}  // namespace gnomon::sight
