#include "geometry/visibility/silhouette_builder.h"

#include <algorithm>
#include <array>

#include "geometry/numbers/orientation.h"
#include "geometry/visibility/common_part.h"

namespace gnomon::viewpoint {

SilhouetteBuilder::SilhouetteBuilder(const Point3& apex, const LightSide& light, Silhouettes& silhouettes)
    : apex_(apex),
      extent_(Extent::area),
      light_corners_(light.corners),
      depth_corners_(light.corners),
      plane_(light.plane),
      silhouettes_(silhouettes) {
  silhouettes_.clear();
  append_rays(light_corners_);
  append_planes(light.names, false);
  append_light(light.flats, light.box);
}

/// The silhouette has two rays and the plane through both, one way and the other. The pyramid's other sides stand
/// upright on it.
SilhouetteBuilder::SilhouetteBuilder(const Point3& apex, std::span<const Point3, 3> ends, const LightPlane& plane,
                                     Silhouettes& silhouettes, Along along)
    : apex_(apex),
      extent_(Extent::length),
      along_(along),
      light_corners_(ends.first<2>()),
      depth_corners_(ends),
      plane_(plane),
      silhouettes_(silhouettes) {
  constexpr std::array<std::uint32_t, 2> names = {0, 0};
  silhouettes_.clear();
  append_rays(light_corners_);
  append_planes(names, false);
  const Ray beside(apex, ends[2]);
  silhouettes_.sides = {silhouettes_.planes[0], silhouettes_.planes[1], Plane(beside, silhouettes_.rays[0], 0),
                        Plane(silhouettes_.rays[1], beside, 0)};
  append_light({}, {});
}

Outcome SilhouetteBuilder::look_at(const BlockerSet::Content& blockers, std::uint32_t blocker) {
  const BlockerSet::Content::Shape& shape = blockers.shapes[blocker];
  if (shape.solid >= 0) return append_solid(blockers.solids[static_cast<std::size_t>(shape.solid)], blocker);
  const std::span<const std::uint32_t> names{blockers.names.data() + shape.first, shape.count};
  return append_flat(blockers.corners(shape), names, blocker);
}

/// True if the blocker may have a point between the apex and the light.
bool SilhouetteBuilder::is_between(const BlockerSet::Content& blockers, std::uint32_t blocker) const {
  if (extent_ == Extent::area) return true;
  return have_common_point(blockers, blocker, std::array{apex_, light_corners_[0], light_corners_[1]});
}

Gathered SilhouetteBuilder::append_blockers(const BlockerSet::Content& blockers,
                                            std::span<const std::uint32_t> candidates) {
  Gathered result = Gathered::kept;
  for (const std::uint32_t candidate : candidates) {
    const std::size_t kept = silhouettes_.list.size();
    const Outcome outcome = look_at(blockers, candidate);
    if (outcome == Outcome::covers) return Gathered::covered;
    if (outcome != Outcome::undecided) continue;
    if (is_between(blockers, candidate)) result = Gathered::undecided;
    if (silhouettes_.list.size() == kept) continue;
    silhouettes_.list.pop_back();
    dropped();
  }
  return result;
}

void SilhouetteBuilder::append_rays(std::span<const Point3> corners) {
  first_ = static_cast<std::uint32_t>(silhouettes_.rays.size());
  for (const Point3& corner : corners) silhouettes_.rays.emplace_back(apex_, corner);
}

/// Reversed, ray k is corner count - 1 - k; the edge to ray k + 1 is the one that ends there in the order given.
void SilhouetteBuilder::append_planes(std::span<const std::uint32_t> names, bool reversed) {
  const std::size_t count = names.size();
  const Ray* rays = silhouettes_.rays.data() + first_;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = k + 1 == count ? 0 : k + 1;
    const std::size_t original = !reversed ? k : next == 0 ? count - 1 : count - 1 - next;
    silhouettes_.planes.emplace_back(rays[k], rays[next], names[original]);
  }
}

/// Turns the rays that were appended round, and what is known of them.
void SilhouetteBuilder::reverse_rays() {
  const auto count = static_cast<std::ptrdiff_t>(silhouettes_.rays.size() - first_);
  std::reverse(silhouettes_.rays.begin() + first_, silhouettes_.rays.end());
  const auto planes = static_cast<std::ptrdiff_t>(silhouettes_.pyramid().size());
  auto row = silhouettes_.at_pyramid.begin() + planes * first_;
  for (std::ptrdiff_t i = 0; i < planes; ++i, row += count) std::reverse(row, row + count);
}

/// Appends the planes of the rays that were appended, these turned round where they run clockwise; 0 if they are seen
/// edge-on.
int SilhouetteBuilder::append_counterclockwise(std::span<const std::uint32_t> names) {
  const Ray* rays = silhouettes_.rays.data() + first_;
  const int turn = side(apex_, Plane(rays[0], rays[1], 0), rays[2]);
  reversed_ = turn < 0;
  if (turn < 0) reverse_rays();
  if (turn != 0) append_planes(names, turn < 0);
  return turn;
}

/// Closes the light's silhouette.
void SilhouetteBuilder::append_light(std::span<const FlatPoint> flats, const FlatBox& box) {
  silhouettes_.flats.assign(flats.begin(), flats.end());
  silhouettes_.list.push_back({0, static_cast<std::uint32_t>(silhouettes_.rays.size()), 0, false, box});
}

Outcome SilhouetteBuilder::dropped() {
  silhouettes_.rays.resize(first_);
  silhouettes_.planes.resize(first_);
  return Outcome::apart;
}

/// Notes on which side of the pyramid's planes the rays run, as far as doubles know and until one of the planes has all
/// rays outside: then true.
bool SilhouetteBuilder::certainly_outside() {
  const std::span<const Plane> pyramid = silhouettes_.pyramid();
  const std::size_t count = silhouettes_.rays.size() - first_;
  const Ray* rays = silhouettes_.rays.data() + first_;
  if (silhouettes_.at_pyramid.size() < pyramid.size() * silhouettes_.rays.size()) {
    silhouettes_.at_pyramid.resize(2 * pyramid.size() * silhouettes_.rays.size());
  }
  std::int8_t* row = silhouettes_.at_pyramid.data() + pyramid.size() * first_;
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
void SilhouetteBuilder::make_sides_exact(const Silhouette& silhouette) {
  const std::span<const Plane> pyramid = silhouettes_.pyramid();
  std::int8_t* row = silhouettes_.at_pyramid.data() + pyramid.size() * silhouette.first;
  for (const Plane& plane : pyramid) {
    for (const Ray& ray : silhouettes_.rays_of(silhouette)) {
      if (*row == uncertain) *row = static_cast<std::int8_t>(exact_side(apex_, plane, ray));
      ++row;
    }
  }
}

bool SilhouetteBuilder::certainly_behind_apex() const {
  return std::all_of(silhouettes_.rays.begin() + first_, silhouettes_.rays.end(), [&](const Ray& ray) {
    return plane_.depth(ray.direction) < -plane_.depth_error(ray.size, unit * ray.size);
  });
}

SilhouetteBuilder::Depth SilhouetteBuilder::depth_of(std::span<const Ray> rays) const {
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
bool SilhouetteBuilder::runs_along_light(std::span<const Ray> rays) const {
  if (extent_ == Extent::area) return false;
  int on_line = 0;
  for (const Ray& ray : rays) {
    const double error = plane_.height_error + plane_.depth_error(ray.size, unit * ray.size);
    if (std::fabs(plane_.height - plane_.depth(ray.direction)) > error) continue;
    if (exact_orientation(depth_corners_[0], depth_corners_[1], depth_corners_[2], *ray.point) != 0) continue;
    on_line += side(apex_, silhouettes_.planes.front(), ray) == 0 ? 1 : 0;
  }
  return on_line >= 2;
}

/// Of a flat blocker whose plane holds the apex: true if it holds a linear light as well.
bool SilhouetteBuilder::hides_edge_on(std::span<const Point3> corners) const {
  return extent_ == Extent::length && std::all_of(light_corners_.begin(), light_corners_.end(), [&](const Point3& end) {
           return exact_orientation(corners[0], corners[1], corners[2], end) == 0;
         });
}

/// Where the light lies with respect to a plane that does not hold the apex. No open segment from the apex passes
/// through the plane to its own side; to the other side every one does.
SilhouetteBuilder::Beyond SilhouetteBuilder::light_beyond(const Point3& a, const Point3& b, const Point3& c) const {
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

/// Looks from the light's corners to the silhouette's planes.
Outcome SilhouetteBuilder::before_light(const Silhouette& silhouette) {
  const std::span<const Ray> light = silhouettes_.rays_of(silhouettes_.list.front());
  if (silhouettes_.of_light.size() < light.size() * silhouettes_.planes.size()) {
    silhouettes_.of_light.resize(2 * light.size() * silhouettes_.planes.size());
  }
  std::int8_t* row = silhouettes_.of_light.data() + light.size() * silhouette.first;
  bool covers = true;
  bool runs_along = false;
  for (const Plane& plane : silhouettes_.planes_of(silhouette)) {
    bool apart = true;
    bool along = extent_ == Extent::length;
    for (const Ray& ray : light) {
      const int sign = side(apex_, plane, ray);
      apart = apart && sign <= 0;
      along = along && sign == 0;
      covers = covers && sign >= 0;
      *row++ = static_cast<std::int8_t>(sign);
    }
    if (apart && !along) return Outcome::apart;
    runs_along = runs_along || along;
  }
  if (runs_along && along_ == Along::undecided) return Outcome::undecided;
  return covers ? Outcome::covers : Outcome::kept;
}

/// Closes the silhouette if it may hide something.
Outcome SilhouetteBuilder::finished(std::uint32_t element) {
  Silhouette silhouette;
  silhouette.first = first_;
  silhouette.count = static_cast<std::uint32_t>(silhouettes_.rays.size()) - first_;
  silhouette.element = element;
  silhouette.inside = inside_;
  silhouette.reversed = reversed_;
  const Outcome outcome = inside_ ? Outcome::kept : before_light(silhouette);
  if (outcome == Outcome::apart) return dropped();
  if (outcome != Outcome::kept) return outcome;
  if (!sides_are_exact_) make_sides_exact(silhouette);
  silhouettes_.flats.resize(first_);
  for (const Ray& ray : silhouettes_.rays_of(silhouette)) {
    silhouettes_.flats.push_back(meeting_point(plane_, ray.direction, ray.size, unit * ray.size));
    silhouette.box.include(silhouettes_.flats.back().box());
  }
  silhouette.box.cut(silhouettes_.list.front().box);
  silhouettes_.list.push_back(silhouette);
  return Outcome::kept;
}

Outcome SilhouetteBuilder::append_flat(std::span<const Point3> corners, std::span<const std::uint32_t> names,
                                       std::uint32_t element) {
  append_rays(corners);
  if (certainly_outside() || certainly_behind_apex()) return dropped();
  const Depth depth = depth_of(std::span(silhouettes_.rays).subspan(first_));
  if (depth == Depth::behind) return dropped();
  if (append_counterclockwise(names) == 0) {
    const bool open = hides_edge_on(corners);
    dropped();
    return open ? Outcome::undecided : Outcome::apart;
  }
  if (depth == Depth::in_front) {
    const Outcome outcome = finished(element);
    if (outcome == Outcome::apart) return outcome;
    return runs_along_light(std::span(silhouettes_.rays).subspan(first_)) ? Outcome::undecided : outcome;
  }
  const Beyond beyond = light_beyond(corners[0], corners[1], corners[2]);
  if (beyond == Beyond::none) return dropped();
  const Outcome outcome = finished(element);
  return beyond == Beyond::part && outcome != Outcome::apart ? Outcome::undecided : outcome;
}

}  // namespace gnomon::viewpoint
