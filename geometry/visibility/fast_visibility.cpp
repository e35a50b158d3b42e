#include "geometry/visibility/fast_visibility.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/kernel.h"
#include "geometry/rounding.h"
#include "geometry/spatial/orientation.h"
#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/boundary_walk.h"
#include "geometry/visibility/flat_area.h"
#include "geometry/visibility/outline_builder.h"

namespace gnomon {

using namespace sight;

/// The light, and the memory that questions share.
class FastVisibility::Work {
 public:
  Work(const AreaLight& light, BlockerSet blockers);

  std::optional<LightSeen> seen_from(const Point3& point);

 private:
  Gathered gather(const Point3& apex, bool reversed);
  LightPlane plane_from(const Point3& apex, bool reversed) const;
  void walk(const Point3& apex);
  void append_stretches_inside(BoundaryWalk& walk, const Outline& outline);
  void find_neighbours(const Outline& outline);
  void append_visible(BoundaryWalk& walk, const Piece& piece);
  LightSeen bounded(Region region, double fraction, double bound);
  LightSeen visible_part();
  LightSeen wholly_visible();

  BlockerSet blockers_;
  bool two_sided_;
  bool flat_;
  bool in_range_;
  std::vector<Point3> corners_;
  std::vector<std::uint32_t> names_;
  LightPlane base_;  ///< normal on the light's front; no height
  FlatArea light_area_;

  LightPlane plane_;
  Outlines outlines_;
  std::vector<std::uint32_t> candidates_;
  std::vector<Piece> inside_;   ///< of the blockers' edges, inside the light
  std::vector<Piece> visible_;  ///< what is not covered of those and of the light's edges
  std::vector<const Outline*> neighbours_;
  std::vector<Stretch> covers_;
  std::vector<BoundaryPiece> boundary_;
};

namespace {

/// The plane of a light through three corners that are far apart.
LightPlane base_plane(std::span<const Point3> corners) {
  const std::size_t third = corners.size() / 3;
  return light_plane(corners[0], corners[third], corners[2 * third]);
}

SightDirection directed(const Plane& plane, bool reversed) {
  const Vector& n = plane.normal;
  const double error = root_of_three * plane.error;
  return reversed ? SightDirection{-n.x, -n.y, -n.z, error} : SightDirection{n.x, n.y, n.z, error};
}

/// A blocker's edge is walked with the blocker on its left; the visible part is on the other side.
void append_piece(std::vector<BoundaryPiece>& boundary, const Piece& piece) {
  BoundaryPiece& result = boundary.emplace_back();
  const SightDirection from = direction_of(piece.edge, piece.stretch.from);
  const SightDirection to = direction_of(piece.edge, piece.stretch.to);
  if (!piece.of_light) result.blocker = piece.outline->element;
  result.edge = piece.edge.plane->name;
  result.start = piece.of_light ? from : to;
  result.end = piece.of_light ? to : from;
  result.normal = directed(*piece.edge.plane, !piece.of_light);
}

Edge edge_of(const Outlines& outlines, const Outline& outline, std::uint32_t k) {
  const std::uint32_t next = k + 1 == outline.count ? 0 : k + 1;
  return {&outlines.planes[outline.first + k], &outlines.rays[outline.first + k], &outlines.rays[outline.first + next],
          outline.ahead};
}

}  // namespace

FastVisibility::Work::Work(const AreaLight& light, BlockerSet blockers)
    : blockers_(std::move(blockers)), two_sided_(light.two_sided), flat_(light.polygon.is_flat()) {
  const ConvexPolygon& polygon = light.polygon;
  for (std::uint32_t k = 0; k < polygon.corners().size(); ++k) {
    corners_.push_back(polygon.points()[polygon.corners()[k]]);
    names_.push_back(polygon.side_edge(k));
  }
  base_ = base_plane(corners_);
  light_area_ = flat_area(corners_, base_.u, base_.v);
  in_range_ = std::all_of(corners_.begin(), corners_.end(), is_in_range) && blockers_.content().largest <= largest;
}

/// Seen from the front the base's normal points towards the apex: depth grows against it.
LightPlane FastVisibility::Work::plane_from(const Point3& apex, bool reversed) const {
  LightPlane plane = base_;
  if (reversed) plane.normal = {-base_.normal.x, -base_.normal.y, -base_.normal.z};
  set_height(plane, corners_[0] - apex);
  return plane;
}

/// Outlines the light and what may hide it.
Gathered FastVisibility::Work::gather(const Point3& apex, bool reversed) {
  plane_ = plane_from(apex, reversed);
  OutlineBuilder builder(apex, corners_, names_, reversed, plane_, outlines_);
  blockers_.content().collect({apex, outlines_.pyramid(), plane_}, candidates_);
  return builder.append_blockers(blockers_.content(), candidates_);
}

/// The parts of the outline's edges inside the light; they are what makes it hide something.
void FastVisibility::Work::append_stretches_inside(BoundaryWalk& walk, const Outline& outline) {
  for (std::uint32_t k = 0; k < outline.count; ++k) {
    Piece& piece = inside_.emplace_back();
    piece.edge = edge_of(outlines_, outline, k);
    piece.outline = &outline;
    if (!walk.stretch_inside(piece.edge, outlines_.list.front(), Alongside::nothing, piece.stretch)) inside_.pop_back();
  }
}

/// Replaces the neighbours by the blockers' outlines whose boxes meet the outline's box.
void FastVisibility::Work::find_neighbours(const Outline& outline) {
  const std::size_t count = outlines_.list.size();
  neighbours_.resize(count);
  std::size_t found = 0;
  const FlatBox box = outline.box;
  for (std::size_t i = 1; i < count; ++i) {
    const Outline& other = outlines_.list[i];
    neighbours_[found] = &other;
    found += box.meets(other.box) ? 1 : 0;
  }
  neighbours_.resize(found);
}

/// Where edges of two blockers run along each other, with both blockers on one side, the first blocker's counts; with
/// the blockers on two sides neither does. A light's edge is covered by what lies on its inner side.
void FastVisibility::Work::append_visible(BoundaryWalk& walk, const Piece& piece) {
  covers_.clear();
  FlatBox box = outlines_.boxes[static_cast<std::size_t>(piece.edge.start - outlines_.rays.data())];
  box.include(outlines_.boxes[static_cast<std::size_t>(piece.edge.end - outlines_.rays.data())]);
  for (const Outline* other : neighbours_) {
    if (other == piece.outline || !box.meets(other->box)) continue;
    const bool first = other < piece.outline;
    const Alongside alongside = piece.of_light ? Alongside::same_side
                                : first        ? Alongside::either_side
                                               : Alongside::other_side;
    Stretch cover;
    if (!walk.stretch_inside(piece.edge, *other, alongside, cover)) continue;
    if (walk.order(piece.edge, cover.from, piece.stretch.from) <= 0 &&
        walk.order(piece.edge, cover.to, piece.stretch.to) >= 0) {
      return;
    }
    covers_.push_back(cover);
  }
  walk.append_uncovered(piece, covers_, visible_);
}

void FastVisibility::Work::walk(const Point3& apex) {
  inside_.clear();
  visible_.clear();
  BoundaryWalk walk(apex, outlines_);
  const Outline& light = outlines_.list.front();
  for (const Outline* outline = &light + 1; outline != &light + outlines_.list.size(); ++outline) {
    append_stretches_inside(walk, *outline);
  }
  find_neighbours(light);
  for (std::uint32_t k = 0; k < light.count; ++k) {
    const Piece whole{edge_of(outlines_, light, k), {{Station::Kind::start}, {Station::Kind::end}}, &light, true};
    append_visible(walk, whole);
  }
  const Outline* last = &light;
  for (const Piece& piece : inside_) {
    if (piece.outline != last) find_neighbours(*piece.outline);
    last = piece.outline;
    append_visible(walk, piece);
  }
}

LightSeen FastVisibility::Work::bounded(Region region, double fraction, double bound) {
  const Vector& n = plane_.normal;
  return {region, fraction, bound, boundary_, {n.x, n.y, n.z, root_of_three * plane_.error}};
}

/// The boundary is the light's own.
LightSeen FastVisibility::Work::wholly_visible() {
  const Outline& light = outlines_.list.front();
  boundary_.resize(light.count);
  for (std::uint32_t k = 0; k < light.count; ++k) {
    const Edge edge = edge_of(outlines_, light, k);
    BoundaryPiece& piece = boundary_[k];
    piece.blocker.reset();
    piece.edge = edge.plane->name;
    piece.start = direction_of(*edge.start);
    piece.end = direction_of(*edge.end);
    piece.normal = directed(*edge.plane, false);
  }
  return bounded(Region::lit, 1, 0);
}

LightSeen FastVisibility::Work::visible_part() {
  AreaSum sum(plane_, outlines_.rays.front());
  for (std::size_t i = 0; i < visible_.size(); ++i) sum.add(visible_[i], boundary_[i]);
  const FlatArea area = sum.total();
  const double whole = light_area_.doubled;
  const double fraction = std::fabs(area.doubled) / whole;
  const double bound = 1.01 * (area.error + light_area_.error) / whole + 4 * unit;
  return bounded(Region::penumbra, fraction >= 0 ? std::min(fraction, 1.0) : 0.5,
                 bound >= 0 ? std::min(bound, 1.0) : 1);
}

std::optional<LightSeen> FastVisibility::Work::seen_from(const Point3& point) {
  if (!flat_ || !in_range_ || !is_in_range(point)) return std::nullopt;
  boundary_.clear();
  const int front = exact_orientation(corners_[0], corners_[1], corners_[2], point);
  if (front == 0 || (front < 0 && !two_sided_)) return LightSeen{Region::unlit, 0, 0, {}, {}};
  const Gathered gathered = gather(point, front > 0);
  if (gathered == Gathered::undecided) return std::nullopt;
  if (gathered == Gathered::covered) return LightSeen{Region::umbra, 0, 0, {}, {}};
  if (outlines_.list.size() == 1) return wholly_visible();
  walk(point);
  for (const Piece& piece : visible_) append_piece(boundary_, piece);
  if (inside_.empty()) return bounded(Region::lit, 1, 0);
  if (visible_.empty()) return LightSeen{Region::umbra, 0, 0, {}, {}};
  return visible_part();
}

FastVisibility::FastVisibility(const AreaLight& light, BlockerSet blockers)
    : work_(std::make_unique<Work>(light, std::move(blockers))) {}
FastVisibility::FastVisibility(FastVisibility&&) noexcept = default;
FastVisibility& FastVisibility::operator=(FastVisibility&&) noexcept = default;
FastVisibility::~FastVisibility() = default;

std::optional<LightSeen> FastVisibility::seen_from(const Point3& point) {
  return work_->seen_from(point);
}

}  // namespace gnomon
