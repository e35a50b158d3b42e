#include "geometry/visibility/fast_linear_visibility.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/numbers/orientation.h"
#include "geometry/numbers/rounding.h"
#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/boundary_walk.h"
#include "geometry/visibility/linear_search/occluder_index.h"
#include "geometry/visibility/receiver_candidates.h"
#include "geometry/visibility/receiver_front.h"
#include "geometry/visibility/silhouette_builder.h"

namespace gnomon {

using namespace viewpoint;

/// The light, and the memory that questions share.
class FastLinearVisibility::Work {
 public:
  Work(const LinearLight& light, std::shared_ptr<const OccluderIndex> index)
      : index_(std::move(index)), ends_{light.start, light.end, light.start} {
    in_range_ = is_in_range(light.start) && is_in_range(light.end) && blockers().largest <= largest;
  }

  std::optional<std::span<const std::uint32_t>> occluders(const Point3& apex);
  const SearchCounts& counts() const { return counts_; }

  /// `receiver` is null for a bare point.
  std::optional<VisibleLinearLight> visible_from(const Point3& apex, const ReceiverPoint* receiver);

 private:
  const BlockerSet::Content& blockers() const { return index_->blockers().content(); }
  bool stand_up(const Point3& apex);
  void find_candidates(const Point3& apex);
  std::optional<VisibleLinearLight> look(const Point3& apex, const ReceiverPoint* receiver);
  std::optional<VisibleLinearLight> look_before(const ReceiverPoint& receiver);
  VisibleLinearLight walk(const Point3& apex);
  StretchEnd end_at(const Edge& edge, const Station& station) const;
  VisibleLinearLight penumbra(const Edge& edge);

  std::shared_ptr<const OccluderIndex> index_;
  SearchCounts counts_;
  bool in_range_ = false;
  std::array<Point3, 3> ends_;  ///< start, end, and a point beside the plane through them and the apex
  LightPlane plane_;
  Silhouettes silhouettes_;
  std::vector<std::uint32_t> candidates_;
  std::vector<std::int8_t> sides_;
  std::vector<Stretch> covers_;
  std::vector<Piece> visible_;
  std::vector<VisibleStretch> stretches_;
};

/// Depth is measured by a plane through the light that stands about upright on the plane of light and apex. Any will
/// do, whatever was rounded, if the apex lies off it. False: there is none.
bool FastLinearVisibility::Work::stand_up(const Point3& apex) {
  const Vector to_start = ends_[0] - apex;
  const Vector along = ends_[1] - ends_[0];
  const Vector upright = cross(to_start, along);
  const double scale = size_of(along) / size_of(upright);
  const Vector step{scale * upright.x, scale * upright.y, scale * upright.z};
  ends_[2] = {ends_[0].x + step.x, ends_[0].y + step.y, ends_[0].z + step.z};
  if (!is_in_range(ends_[2])) return false;
  plane_ = light_plane(ends_[0], ends_[1], ends_[2]);
  set_height(plane_, to_start);
  return exact_orientation(ends_[0], ends_[1], ends_[2], apex) < 0;
}

/// Bound. With a and b the products of the plane's normal with the ends, off by e and f, the share is a / (a - b), off
/// by (|a| f + |b| e) / (D (D - e - f)) with D = |a - b|, and two roundings.
StretchEnd FastLinearVisibility::Work::end_at(const Edge& edge, const Station& station) const {
  if (station.kind != Station::Kind::inner) return {std::nullopt, 0, station.kind == Station::Kind::end ? 1.0 : 0.0, 0};
  const Plane& plane = silhouettes_.planes[station.plane];
  const Ray& start = silhouettes_.rays[edge.start];
  const Ray& end = silhouettes_.rays[edge.end];
  const double a = dot(plane.normal, start.direction);
  const double b = dot(plane.normal, end.direction);
  const double a_error = plane.side_bound * start.size + tiny;
  const double b_error = plane.side_bound * end.size + tiny;
  const double whole = std::fabs(a - b);
  const double sure = whole - 1.01 * (a_error + b_error);
  const double share = std::clamp(a / (a - b), 0.0, 1.0);
  const double error = 1.01 * (std::fabs(a) * b_error + std::fabs(b) * a_error) / (whole * sure) + 4 * unit;
  const auto after =
      std::upper_bound(silhouettes_.list.begin(), silhouettes_.list.end(), station.plane,
                       [](std::uint32_t i, const Silhouette& silhouette) { return i < silhouette.first; });
  const bool known = sure > 0 && error <= 1;
  return {std::prev(after)->element, plane.name, known ? share : 0.5, known ? error : HUGE_VAL};
}

VisibleLinearLight FastLinearVisibility::Work::penumbra(const Edge& edge) {
  double fraction = 0;
  double error = 0;
  for (const Piece& piece : visible_) {
    stretches_.push_back({end_at(edge, piece.stretch.from), end_at(edge, piece.stretch.to)});
    const auto& [from, to] = stretches_.back();
    fraction += to.share - from.share;
    error += from.error + to.error + 4 * unit;
  }
  return {Region::penumbra, std::clamp(fraction, 0.0, 1.0), std::min(1.01 * error, 1.0), stretches_};
}

/// The light is one edge, and every silhouette that touches its plane along a length covers a part of it.
VisibleLinearLight FastLinearVisibility::Work::walk(const Point3& apex) {
  BoundaryWalk walk(apex, silhouettes_, sides_);
  const Edge edge = edge_of(silhouettes_, 0, 0);
  const Piece whole{edge, {{Station::Kind::start}, {Station::Kind::end}}};
  covers_.clear();
  for (std::uint32_t i = 1; i < silhouettes_.list.size(); ++i) {
    Stretch cover;
    if (walk.stretch_inside(edge, i, Alongside::either_side, cover)) covers_.push_back(cover);
  }
  visible_.clear();
  if (!covers_.empty() && !walk.append_uncovered(whole, covers_, visible_)) return {Region::umbra, 0, 0, {}};
  if (!covers_.empty()) return penumbra(edge);
  stretches_.push_back({{std::nullopt, 0, 0, 0}, {std::nullopt, 0, 1, 0}});
  return {Region::lit, 1, 0, stretches_};
}

void FastLinearVisibility::Work::find_candidates(const Point3& apex) {
  index_->find({{apex, ends_[0], ends_[1]}, {apex, silhouettes_.pyramid(), plane_}}, candidates_, counts_);
}

std::optional<std::span<const std::uint32_t>> FastLinearVisibility::Work::occluders(const Point3& apex) {
  if (!in_range_ || !is_in_range(apex) || !stand_up(apex)) return std::nullopt;
  SilhouetteBuilder(apex, ends_, plane_, silhouettes_);
  find_candidates(apex);
  return candidates_;
}

std::optional<VisibleLinearLight> FastLinearVisibility::Work::look(const Point3& apex, const ReceiverPoint* receiver) {
  if (!stand_up(apex)) return std::nullopt;
  SilhouetteBuilder builder(apex, ends_, plane_, silhouettes_, receiver ? Along::undecided : Along::hides);
  find_candidates(apex);
  if (receiver && !keep_before(*receiver, blockers(), candidates_)) return std::nullopt;
  const Gathered gathered = builder.append_blockers(blockers(), candidates_);
  if (gathered == Gathered::undecided) return std::nullopt;
  if (gathered == Gathered::covered) return VisibleLinearLight{Region::umbra, 0, 0, {}};
  return walk(apex);
}

namespace {

/// The part of a light before a receiver's plane, in shares; one of them is rounded, the other 0 or 1.
struct SharesBefore {
  double low = 0;
  double high = 1;
  double share = 1;  ///< of the whole; correctly rounded
};

SharesBefore shares_before(const Point3& start, const Point3& end, const ExactPlane& plane) {
  const Rational at_start = plane.height(exact(start));
  const Rational crossing = at_start / (at_start - plane.height(exact(end)));
  const double near = nearest_double(crossing);
  if (at_start > 0) return {0, near, near};
  return {near, 1, nearest_double(Rational(1 - crossing))};
}

/// Adds up the lengths of stretches before the plane.
class LengthBefore {
 public:
  explicit LengthBefore(const SharesBefore& shares) : shares_(shares) {}

  void add(const StretchEnd& from, const StretchEnd& to) {
    const double length = std::min(to.share, shares_.high) - std::max(from.share, shares_.low);
    const double error = from.error + to.error + 4 * unit;
    if (length > error) any_ = true;
    if (length > -error && length <= error) doubt_ = true;
    if (length <= -error) return;
    sum_ += std::max(length, 0.0);
    error_ += 1.01 * error;
  }
  /// Nothing if it is not known whether there is any.
  std::optional<bool> any() const { return any_ || !doubt_ ? std::optional(any_) : std::nullopt; }
  double sum() const { return sum_; }
  double error() const { return error_; }

 private:
  SharesBefore shares_;
  bool any_ = false;
  bool doubt_ = false;
  double sum_ = 0;
  double error_ = 0;
};

}  // namespace

/// Of a light that the receiver's plane cuts: what of the visible stretches, and of the gaps between them, lies before.
std::optional<VisibleLinearLight> FastLinearVisibility::Work::look_before(const ReceiverPoint& receiver) {
  const SharesBefore shares = shares_before(ends_[0], ends_[1], exact_front(receiver));
  std::optional<VisibleLinearLight> seen = look(receiver.point, &receiver);
  if (!seen) return seen;
  seen->before_receiver = shares.share;
  LengthBefore visible(shares);
  LengthBefore hidden(shares);
  StretchEnd last{std::nullopt, 0, 0, 0};
  for (const VisibleStretch& stretch : seen->visible) {
    visible.add(stretch.from, stretch.to);
    if (stretch.from.blocker) hidden.add(last, stretch.from);
    last = stretch.to;
  }
  if (last.blocker || seen->visible.empty()) hidden.add(last, {std::nullopt, 0, 1, 0});
  if (!visible.any() || !hidden.any()) return std::nullopt;
  seen->region = !*visible.any() ? Region::umbra : *hidden.any() ? Region::penumbra : Region::lit;
  seen->fraction = seen->region == Region::lit ? shares.share : seen->region == Region::umbra ? 0 : visible.sum();
  seen->error_bound = seen->region == Region::lit     ? unit * shares.share
                      : seen->region == Region::umbra ? 0
                                                      : visible.error();
  if (seen->region == Region::umbra) seen->visible = {};
  return seen;
}

std::optional<VisibleLinearLight> FastLinearVisibility::Work::visible_from(const Point3& apex,
                                                                           const ReceiverPoint* receiver) {
  stretches_.clear();
  if (!in_range_ || !is_in_range(apex)) return std::nullopt;
  if (!receiver) return look(apex, nullptr);
  const int start = side_of_front(*receiver, ends_[0]);
  const int end = side_of_front(*receiver, ends_[1]);
  if (start <= 0 && end <= 0) return VisibleLinearLight{Region::unlit, 0, 0, {}, 0};
  return start < 0 || end < 0 ? look_before(*receiver) : look(apex, receiver);
}

FastLinearVisibility::FastLinearVisibility(const LinearLight& light, BlockerSet blockers, const LinearSearch& search)
    : FastLinearVisibility(light, std::make_shared<const OccluderIndex>(light, std::move(blockers), search)) {}
FastLinearVisibility::FastLinearVisibility(const LinearLight& light, std::shared_ptr<const OccluderIndex> index)
    : work_(std::make_unique<Work>(light, std::move(index))) {}
FastLinearVisibility::FastLinearVisibility(FastLinearVisibility&&) noexcept = default;
FastLinearVisibility& FastLinearVisibility::operator=(FastLinearVisibility&&) noexcept = default;
FastLinearVisibility::~FastLinearVisibility() = default;

std::optional<VisibleLinearLight> FastLinearVisibility::visible_from(const Point3& point) {
  return work_->visible_from(point, nullptr);
}

std::optional<VisibleLinearLight> FastLinearVisibility::visible_by(const ReceiverPoint& receiver) {
  return work_->visible_from(receiver.point, &receiver);
}

std::optional<std::span<const std::uint32_t>> FastLinearVisibility::occluders(const Point3& point) {
  return work_->occluders(point);
}

const SearchCounts& FastLinearVisibility::search_counts() const {
  return work_->counts();
}

}  // namespace gnomon
