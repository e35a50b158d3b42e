#include "gnomon/flatland_receiver.h"

#include <algorithm>
#include <utility>

#include "geometry/numbers/rounding.h"
#include "geometry/planar/event_rays.h"
#include "geometry/planar/light_line.h"
#include "geometry/planar/visibility_query.h"
#include "gnomon/errors.h"

namespace gnomon::planar {
namespace {

struct Candidate {
  Rational place;
  BoundaryName name;
};

Rational cross(const ExactPoint& a, const ExactPoint& b) {
  return a.x * b.y - a.y * b.x;
}

ExactPoint difference(const ExactPoint& a, const ExactPoint& b) {
  return {a.x - b.x, a.y - b.y};
}

class ReceiverSearch {
 public:
  ReceiverSearch(const LightVisibility& visibility, const std::array<Point2, 2>& receiver)
      : visibility_(visibility), start_(exact(receiver[0])), way_(difference(exact(receiver[1]), start_)) {}

  std::vector<ReceiverEvent> events() const {
    const std::vector<Candidate> candidates = sorted_candidates();
    std::vector<ReceiverEvent> events;
    Rational last = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Candidate& candidate = candidates[i];
      const Rational next = i + 1 < candidates.size() ? candidates[i + 1].place : Rational(1);
      const VisibleLight before = visible_at((last + candidate.place) / 2),
                         after = visible_at((candidate.place + next) / 2);
      last = candidate.place;
      if (same_names(before, after)) continue;
      const bool jumps = may_jump(candidate) && limits_differ(candidate.place, before, after);
      events.push_back(
          {nearest_double(candidate.place), jumps ? Discontinuity::d0 : Discontinuity::d1, candidate.name});
    }
    return events;
  }

 private:
  ExactPoint point_at(const Rational& place) const { return {start_.x + place * way_.x, start_.y + place * way_.y}; }

  VisibleLight visible_at(const Rational& place) const {
    const Viewpoint from(point_at(place));
    return VisibilityQuery(visibility_, from).visible_light();
  }

  static bool same_names(const VisibleLight& a, const VisibleLight& b) {
    return std::ranges::equal(a.intervals, b.intervals, [](const VisibleInterval& one, const VisibleInterval& other) {
      return one.from.name == other.from.name && one.to.name == other.to.name;
    });
  }

  /// f is continuous off the blockers and the light's line.
  static bool may_jump(const Candidate& candidate) {
    return candidate.name.kind == BoundaryKind::blocker || candidate.name.kind == BoundaryKind::light_line;
  }

  /// Adds the place where the receiver crosses a line, if it crosses it.
  void add(const ExactPoint& a, const ExactPoint& b, const BoundaryName& name, std::vector<Candidate>& list) const {
    const ExactPoint along = difference(b, a);
    const Rational parallel = cross(way_, along);
    if (parallel == 0) return;
    const Rational place = cross(difference(a, start_), along) / parallel;
    if (CGAL::sign(place) > 0 && place < 1) list.push_back({place, name});
  }

  /// Adds the end of a blocker, if it lies on the receiver.
  void add_end(const Point2& end, const BoundaryName& name, std::vector<Candidate>& list) const {
    const ExactPoint to_end = difference(exact(end), start_);
    if (cross(way_, to_end) != 0) return;
    const Rational place = (to_end.x * way_.x + to_end.y * way_.y) / (way_.x * way_.x + way_.y * way_.y);
    if (CGAL::sign(place) > 0 && place < 1) list.push_back({place, name});
  }

  std::vector<Candidate> sorted_candidates() const {
    const Flatland& flatland = visibility_.flatland();
    std::vector<Candidate> list;
    for (std::uint32_t i = 0; i < flatland.blockers().size(); ++i) {
      const auto& [a, b] = flatland.blockers()[i];
      const BoundaryName name{BoundaryKind::blocker, i, {}, {}, {}};
      std::vector<Candidate> crossing;
      add(exact(a), exact(b), name, crossing);
      if (!crossing.empty() && is_between(a, b, crossing.front().place)) list.push_back(crossing.front());
      add_end(a, name, list);
      add_end(b, name, list);
    }
    const auto light = flatland.light();
    add(exact(light[0]), exact(light[1]), {BoundaryKind::light_line, 0, {}, {}, {}}, list);
    for (const EventRay& ray : event_rays(flatland, EventDetail::structure)) {
      add(ray.near_point, exact(ray.far_point), {BoundaryKind::event, 0, ray.near, ray.far, ray.contact}, list);
    }
    std::ranges::stable_sort(list, [](const Candidate& a, const Candidate& b) { return a.place < b.place; });
    const auto same_place = [](const Candidate& a, const Candidate& b) { return a.place == b.place; };
    list.erase(std::unique(list.begin(), list.end(), same_place), list.end());
    return list;
  }

  /// True if the receiver's point lies on the blocker, whose line it is on.
  bool is_between(const Point2& a, const Point2& b, const Rational& place) const {
    const ExactPoint p = point_at(place), to_a = difference(exact(a), p), to_b = difference(exact(b), p);
    return to_a.x * to_b.x + to_a.y * to_b.y <= 0;
  }

  /// Where the receiver's line meets the light's line; of the receiver along it, the foot of q.
  Rational place_ahead(const ExactPoint& q) const {
    const auto light = visibility_.flatland().light();
    const ExactPoint end = exact(light[0]), along = difference(exact(light[1]), end);
    const Rational parallel = cross(way_, along);
    if (parallel == 0) return place_along(light, q);
    return place_along(light, point_at(cross(difference(end, start_), along) / parallel));
  }

  /// Where an end that is visible near p comes to lie as the viewpoint comes to p; an end in p itself stays ahead.
  Rational limit_place(const EventPoint& name, const ExactPoint& p) const {
    const auto light = visibility_.flatland().light();
    if (name.kind != EventPointKind::blocker_end) {
      const Viewpoint from(p);
      return VisibilityQuery(visibility_, from).place(name);
    }
    const ExactPoint q = exact(visibility_.flatland().blockers()[name.element][name.end]);
    if (p == q) return place_ahead(q);
    const Rational height_p = height_over(light, p), height_q = height_over(light, q);
    if (height_p == height_q) return place_along(light, q);
    const ExactPoint origin = exact(light[0]);
    return cross(difference(q, origin), difference(p, origin)) / (height_p - height_q);
  }

  Rational limit_fraction(const VisibleLight& seen, const ExactPoint& p) const {
    Rational sum = 0;
    for (const VisibleInterval& interval : seen.intervals) {
      sum += limit_place(interval.to.name, p) - limit_place(interval.from.name, p);
    }
    return sum;
  }

  bool limits_differ(const Rational& place, const VisibleLight& before, const VisibleLight& after) const {
    const ExactPoint p = point_at(place);
    return limit_fraction(before, p) != limit_fraction(after, p);
  }

  const LightVisibility& visibility_;
  ExactPoint start_;
  ExactPoint way_;
};

}  // namespace

std::vector<ReceiverEvent> receiver_events(const LightVisibility& visibility, const std::array<Point2, 2>& receiver) {
  if (visibility.flatland().has_point_light()) throw PreconditionError("receiver events need a linear light");
  if (receiver[0] == receiver[1]) throw PreconditionError("a receiver is two different points");
  return ReceiverSearch(visibility, receiver).events();
}

}  // namespace gnomon::planar
