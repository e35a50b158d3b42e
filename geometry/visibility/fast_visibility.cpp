#include "geometry/visibility/fast_visibility.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/numbers/kernel.h"
#include "geometry/numbers/orientation.h"
#include "geometry/numbers/rounding.h"
#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/boundary_walk.h"
#include "geometry/visibility/flat_area.h"
#include "geometry/visibility/light_cut.h"
#include "geometry/visibility/receiver_candidates.h"
#include "geometry/visibility/silhouette_builder.h"
#include "geometry/visibility/silhouette_grid.h"
#include "geometry/visibility/turned_away.h"

namespace gnomon {

using namespace viewpoint;

/// The light, and the memory that questions share.
class FastVisibility::Work {
 public:
  Work(const AreaLight& light, BlockerSet blockers);

  /// `receiver` is null for a bare point.
  std::optional<VisibleAreaLight> visible_from(const Point3& point, const ReceiverPoint* receiver);

 private:
  int turn_to(const Point3& apex);
  Gathered gather(const Point3& apex, const ReceiverPoint* receiver);
  void walk(const Point3& apex);
  bool is_between_facets(std::uint32_t silhouette, std::uint32_t k) const;
  void append_stretches_inside(BoundaryWalk& walk, std::uint32_t silhouette);
  void append_visible(BoundaryWalk& walk, const Piece& piece);
  VisibleAreaLight bounded(Region region, double fraction, double bound, std::size_t pieces);
  FlatArea set_boundary();
  VisibleAreaLight measured(const FlatArea& area);
  VisibleAreaLight visible_part();
  VisibleAreaLight wholly_visible();
  std::array<std::int8_t, 2> sides_of_ends(std::size_t piece) const;
  std::optional<Region> region_before() const;
  FlatArea area_before() const;
  std::optional<VisibleAreaLight> part_before();
  std::optional<VisibleAreaLight> look(const Point3& point, const ReceiverPoint* receiver);

  BlockerSet blockers_;
  bool two_sided_;
  bool flat_;
  bool in_range_;
  LightSide front_;
  LightSide back_;
  TurnedAway turned_away_;
  FlatArea light_area_;

  LightSide* shown_ = &front_;  ///< to the apex of the question
  LightCut cut_;                ///< by the receiver's plane
  Silhouettes silhouettes_;
  std::vector<std::uint32_t> candidates_;
  std::vector<std::uint32_t> silhouette_of_;  ///< of each blocker, while edges are walked; 0 without one
  bool any_inside_ = false;                   ///< some edge of a blocker is inside the light
  std::vector<Piece> inside_;   ///< of the blockers' edges, inside the light, those that may bound something
  std::vector<Piece> visible_;  ///< what is not covered of those and of the light's edges
  SilhouetteGrid grid_;
  std::vector<std::uint32_t> neighbours_;  ///< silhouettes whose boxes meet that of the one whose edges are walked
  std::vector<std::int8_t> sides_;
  std::vector<Stretch> covers_;
  std::vector<std::array<FlatPoint, 2>> flats_;  ///< the ends of the visible pieces
  std::vector<BoundaryPiece> boundary_;          ///< never shorter than before: only its beginning counts
};

namespace {

/// The plane through three corners that are far apart, its normal on the front.
LightPlane plane_of(const ConvexPolygon& polygon) {
  const std::size_t third = polygon.corners().size() / 3;
  const auto corner = [&](std::size_t k) { return polygon.points()[polygon.corners()[k]]; };
  return light_plane(corner(0), corner(third), corner(2 * third));
}

/// The plane as its other side shows it: in the same two coordinates, so that areas are comparable.
LightPlane turned(LightPlane plane) {
  plane.normal = {-plane.normal.x, -plane.normal.y, -plane.normal.z};
  return plane;
}

/// A polygon's corners run counterclockwise as seen from its front.
LightSide light_side(const ConvexPolygon& polygon, bool front, const LightPlane& plane) {
  LightSide side;
  const auto count = static_cast<std::uint32_t>(polygon.corners().size());
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t corner = front ? count - 1 - k : k;
    side.corners.push_back(polygon.points()[polygon.corners()[corner]]);
    side.names.push_back(polygon.side_edge(front ? (corner == 0 ? count - 1 : corner - 1) : corner));
  }
  side.plane = plane;
  for (const Point3& corner : side.corners) {
    const Vector d = corner - side.corners[0];
    const double u = coordinate(d, side.plane.u);
    const double v = coordinate(d, side.plane.v);
    side.flats.push_back({u, v, unit * std::max(std::fabs(u), std::fabs(v))});
    side.box.include(side.flats.back().box());
  }
  return side;
}

/// A blocker's edge is walked with the blocker on its left; the visible part is on the other side.
void set_piece(BoundaryPiece& result, const Silhouettes& silhouettes, const Edge& edge, const VisibleDirection& from,
               const VisibleDirection& to) {
  const Plane& plane = silhouettes.planes[edge.plane];
  const Vector& n = plane.normal;
  result.edge = plane.name;
  if (edge.of_light()) {
    result.blocker.reset();
    result.start = from;
    result.end = to;
    result.normal = direction_of(n, plane.error);
  } else {
    result.blocker = silhouettes.list[edge.silhouette].element;
    result.start = to;
    result.end = from;
    result.normal = direction_of({-n.x, -n.y, -n.z}, plane.error);
  }
}

constexpr Stretch whole_edge{{Station::Kind::start}, {Station::Kind::end}};

}  // namespace

FastVisibility::Work::Work(const AreaLight& light, BlockerSet blockers)
    : blockers_(std::move(blockers)),
      two_sided_(light.two_sided),
      flat_(light.polygon.is_flat()),
      front_(light_side(light.polygon, true, turned(plane_of(light.polygon)))),
      back_(light_side(light.polygon, false, plane_of(light.polygon))),
      turned_away_(blockers_.content(), front_.corners),
      light_area_(flat_area(front_.corners, front_.plane.u, front_.plane.v)) {
  in_range_ =
      std::all_of(front_.corners.begin(), front_.corners.end(), is_in_range) && blockers_.content().largest <= largest;
}

/// Measures the height of the light's plane over the apex on the side that the light shows to it.
/// Returns: -1, 0, +1: behind the light, in its plane, in front of it.
int FastVisibility::Work::turn_to(const Point3& apex) {
  shown_ = &front_;
  set_height(front_.plane, front_.corners[0] - apex);
  const LightPlane& plane = front_.plane;
  if (plane.height > plane.height_error) return 1;
  const std::vector<Point3>& c = front_.corners;
  const int side = plane.height < -plane.height_error ? -1 : -exact_orientation(c[0], c[1], c[2], apex);
  if (side < 0) {
    shown_ = &back_;
    set_height(back_.plane, back_.corners[0] - apex);
  }
  return side;
}

/// Silhouettes the light and what may hide it. Without the facets under a receiver's point a surface is not closed.
Gathered FastVisibility::Work::gather(const Point3& apex, const ReceiverPoint* receiver) {
  SilhouetteBuilder builder(apex, *shown_, silhouettes_);
  blockers_.content().collect({apex, silhouettes_.pyramid(), shown_->plane}, candidates_);
  if (!receiver || receiver->under.empty()) turned_away_.remove_from(candidates_, apex);
  if (receiver && !keep_before(*receiver, blockers_.content(), candidates_)) return Gathered::undecided;
  return builder.append_blockers(blockers_.content(), candidates_);
}

/// True of an edge of a mesh with a facet on either side, as seen: neither bounds what is hidden.
bool FastVisibility::Work::is_between_facets(std::uint32_t silhouette, std::uint32_t k) const {
  const Silhouette& own = silhouettes_.list[silhouette];
  const BlockerSet::Content& blockers = blockers_.content();
  const BlockerSet::Content::Shape& shape = blockers.shapes[own.element];
  if (shape.solid >= 0) return false;
  const BlockerSet::Content::Mate& mate = blockers.mates[shape.first + own.original(k)];
  if (mate.shape == BlockerSet::Content::Mate::none || silhouette_of_[mate.shape] == 0) return false;
  // Silhouettes run counterclockwise: two that run along an edge in opposite ways lie on its two sides.
  const Silhouette& other = silhouettes_.list[silhouette_of_[mate.shape]];
  return mate.is_opposite == (own.reversed == other.reversed);
}

/// The parts of the silhouette's edges inside the light; they are what makes it hide something.
void FastVisibility::Work::append_stretches_inside(BoundaryWalk& walk, std::uint32_t silhouette) {
  const Silhouette& o = silhouettes_.list[silhouette];
  for (std::uint32_t k = 0; k < o.count; ++k) {
    Piece piece{edge_of(silhouettes_, silhouette, k), whole_edge};
    if (!o.inside && !walk.stretch_inside(piece.edge, 0, Alongside::nothing, piece.stretch)) continue;
    any_inside_ = true;
    if (!is_between_facets(silhouette, k)) inside_.push_back(piece);
  }
}

/// Where edges of two blockers run along each other, with both blockers on one side, the first blocker's counts; with
/// the blockers on two sides neither does. A light's edge is covered by what lies on its inner side.
void FastVisibility::Work::append_visible(BoundaryWalk& walk, const Piece& piece) {
  covers_.clear();
  const Edge& edge = piece.edge;
  FlatBox box = silhouettes_.flats[edge.start].box();
  box.include(silhouettes_.flats[edge.end].box());
  for (const std::uint32_t other : neighbours_) {
    if (other == edge.silhouette || !box.meets(silhouettes_.list[other].box)) continue;
    const Alongside alongside = edge.of_light()           ? Alongside::same_side
                                : other < edge.silhouette ? Alongside::either_side
                                                          : Alongside::other_side;
    Stretch cover;
    if (!walk.stretch_inside(edge, other, alongside, cover)) continue;
    if (walk.order(edge, cover.from, piece.stretch.from) <= 0 && walk.order(edge, cover.to, piece.stretch.to) >= 0) {
      return;
    }
    covers_.push_back(cover);
  }
  walk.append_uncovered(piece, covers_, visible_);
}

void FastVisibility::Work::walk(const Point3& apex) {
  any_inside_ = false;
  inside_.clear();
  visible_.clear();
  BoundaryWalk walk(apex, silhouettes_, sides_);
  const auto count = static_cast<std::uint32_t>(silhouettes_.list.size());
  silhouette_of_.resize(blockers_.content().shapes.size());
  for (std::uint32_t i = 1; i < count; ++i) silhouette_of_[silhouettes_.list[i].element] = i;
  for (std::uint32_t i = 1; i < count; ++i) append_stretches_inside(walk, i);
  for (std::uint32_t i = 1; i < count; ++i) silhouette_of_[silhouettes_.list[i].element] = 0;
  grid_.build(silhouettes_.list);
  grid_.find(silhouettes_.list.front().box, neighbours_);
  const std::uint32_t light_edges = silhouettes_.list.front().count;
  for (std::uint32_t k = 0; k < light_edges; ++k) append_visible(walk, {edge_of(silhouettes_, 0, k), whole_edge});
  std::uint32_t last = 0;
  for (const Piece& piece : inside_) {
    if (piece.edge.silhouette != last) grid_.find(silhouettes_.list[piece.edge.silhouette].box, neighbours_);
    last = piece.edge.silhouette;
    append_visible(walk, piece);
  }
}

/// With a boundary of the first `pieces`.
VisibleAreaLight FastVisibility::Work::bounded(Region region, double fraction, double bound, std::size_t pieces) {
  const LightPlane& plane = shown_->plane;
  const std::span<const BoundaryPiece> boundary{boundary_.data(), pieces};
  return {region, fraction, bound, boundary, direction_of(plane.normal, plane.error)};
}

/// The boundary is the light's own.
VisibleAreaLight FastVisibility::Work::wholly_visible() {
  const std::uint32_t count = silhouettes_.list.front().count;
  if (boundary_.size() < count) boundary_.resize(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    const Edge edge = edge_of(silhouettes_, 0, k);
    set_piece(boundary_[k], silhouettes_, edge, direction_of(silhouettes_.rays[edge.start]),
              direction_of(silhouettes_.rays[edge.end]));
  }
  return bounded(Region::lit, 1, 0, count);
}

/// Works out what the visible pieces look like. Returns: the area that they bound.
FlatArea FastVisibility::Work::set_boundary() {
  if (boundary_.size() < visible_.size()) boundary_.resize(visible_.size());
  flats_.clear();
  AreaSum sum;
  for (std::size_t i = 0; i < visible_.size(); ++i) {
    const auto& [edge, stretch] = visible_[i];
    const VisiblePlace from = visible_place(silhouettes_, shown_->plane, edge, stretch.from);
    const VisiblePlace to = visible_place(silhouettes_, shown_->plane, edge, stretch.to);
    set_piece(boundary_[i], silhouettes_, edge, from.direction, to.direction);
    edge.of_light() ? sum.add(from.flat, to.flat) : sum.add(to.flat, from.flat);
    if (cut_.extent == Extent::part) flats_.push_back({from.flat, to.flat});
  }
  return sum.total();
}

VisibleAreaLight FastVisibility::Work::visible_part() {
  return measured(set_boundary());
}

VisibleAreaLight FastVisibility::Work::measured(const FlatArea& area) {
  const double whole = light_area_.doubled;
  const double fraction = std::fabs(area.doubled) / whole;
  const double bound = 1.01 * (area.error + light_area_.error) / whole + 4 * unit;
  return bounded(Region::penumbra, fraction >= 0 ? std::min(fraction, 1.0) : 0.5, bound >= 0 ? std::min(bound, 1.0) : 1,
                 visible_.size());
}

/// On which side of the receiver's plane the ends of a visible piece lie.
std::array<std::int8_t, 2> FastVisibility::Work::sides_of_ends(std::size_t piece) const {
  const auto& [edge, stretch] = visible_[piece];
  const auto side = [&](const Station& station, const FlatPoint& flat) {
    const std::uint32_t ray = ray_at(edge, station);
    return ray < cut_.sides.size() ? cut_.sides[ray] : height_of(flat, cut_).side();
  };
  return {side(stretch.from, flats_[piece][0]), side(stretch.to, flats_[piece][1])};
}

/// Some of the light's part before the plane is visible exactly if a corner of what is visible lies before it. Some is
/// hidden exactly if a blocker's edge comes there: without one, the part is visible as a whole or not at all.
std::optional<Region> FastVisibility::Work::region_before() const {
  bool visible = false, hidden = false, may_be_visible = false, may_be_hidden = false;
  for (std::size_t i = 0; i < visible_.size(); ++i) {
    const bool of_light = visible_[i].edge.of_light();
    for (const std::int8_t side : sides_of_ends(i)) {
      visible = visible || side == 1;
      may_be_visible = may_be_visible || side == uncertain;
      hidden = hidden || (side == 1 && !of_light);
      may_be_hidden = may_be_hidden || (side == uncertain && !of_light);
    }
  }
  if ((!visible && may_be_visible) || (!hidden && may_be_hidden)) return std::nullopt;
  return !visible ? Region::umbra : hidden ? Region::penumbra : Region::lit;
}

FlatArea FastVisibility::Work::area_before() const {
  AreaBefore area(cut_);
  for (std::size_t i = 0; i < visible_.size(); ++i) {
    const auto& [from, to] = flats_[i];
    visible_[i].edge.of_light() ? area.add(from, to) : area.add(to, from);
  }
  return area.total();
}

std::optional<VisibleAreaLight> FastVisibility::Work::part_before() {
  set_boundary();
  const std::optional<Region> region = region_before();
  if (!region) return std::nullopt;
  if (*region == Region::umbra) return VisibleAreaLight{Region::umbra, 0, 0, {}, {}};
  if (*region == Region::penumbra) return measured(area_before());
  return bounded(Region::lit, 1, 0, visible_.size());
}

std::optional<VisibleAreaLight> FastVisibility::Work::look(const Point3& point, const ReceiverPoint* receiver) {
  const Gathered gathered = gather(point, receiver);
  if (gathered == Gathered::undecided) return std::nullopt;
  if (gathered == Gathered::covered) return VisibleAreaLight{Region::umbra, 0, 0, {}, {}};
  if (silhouettes_.list.size() == 1) return wholly_visible();
  walk(point);
  if (!any_inside_) return wholly_visible();
  if (visible_.empty()) return VisibleAreaLight{Region::umbra, 0, 0, {}, {}};
  return cut_.extent == Extent::part ? part_before() : visible_part();
}

std::optional<VisibleAreaLight> FastVisibility::Work::visible_from(const Point3& point, const ReceiverPoint* receiver) {
  if (!flat_ || !in_range_ || !is_in_range(point)) return std::nullopt;
  const int front = turn_to(point);
  cut_.extent = Extent::all;
  if (receiver) cut_light(*shown_, *receiver, cut_);
  const bool is_unlit = front == 0 || (front < 0 && !two_sided_) || cut_.extent == Extent::none;
  std::optional<VisibleAreaLight> seen =
      is_unlit ? VisibleAreaLight{Region::unlit, 0, 0, {}, {}} : look(point, receiver);
  if (!seen || !receiver) return seen;
  seen->before_receiver = cut_.share;
  if (seen->region == Region::lit && cut_.extent == Extent::part) {
    seen->fraction = cut_.share;
    seen->error_bound = unit * cut_.share;
  }
  return seen;
}

FastVisibility::FastVisibility(const AreaLight& light, BlockerSet blockers)
    : work_(std::make_unique<Work>(light, std::move(blockers))) {}
FastVisibility::FastVisibility(FastVisibility&&) noexcept = default;
FastVisibility& FastVisibility::operator=(FastVisibility&&) noexcept = default;
FastVisibility::~FastVisibility() = default;

std::optional<VisibleAreaLight> FastVisibility::visible_from(const Point3& point) {
  return work_->visible_from(point, nullptr);
}

std::optional<VisibleAreaLight> FastVisibility::visible_by(const ReceiverPoint& receiver) {
  return work_->visible_from(receiver.point, &receiver);
}

}  // namespace gnomon
