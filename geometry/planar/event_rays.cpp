#include "geometry/planar/event_rays.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/planar/light_line.h"
#include "geometry/planar/orientation.h"
#include "geometry/planar/viewpoint.h"

namespace gnomon::planar {
namespace {

/// An event point with the other ends of the blockers that begin in it, or pass through it on the light.
struct EventVertex {
  EventPoint name;
  Viewpoint point;
  int side = 0;  ///< of the light's line
  bool on_light = false;
  std::vector<Point2> neighbours;
};

/// What blockers at a vertex do to a line through it.
struct Touch {
  bool left = false;
  bool right = false;

  bool both() const { return left && right; }
};

class EventSearch {
 public:
  EventSearch(const Flatland& flatland, EventDetail detail) : flatland_(flatland), detail_(detail) {
    add_light_ends();
    add_blocker_ends();
    if (!flatland.has_point_light()) add_crossings();
  }

  std::vector<EventRay> rays() const {
    std::vector<EventRay> rays;
    for (const EventVertex& far : vertices_) {
      if (far.name.kind != EventPointKind::blocker_end) continue;
      if (!flatland_.has_point_light() && far.side == 0) continue;
      for (const EventVertex& near : vertices_) add_ray(near, far, rays);
    }
    return rays;
  }

 private:
  const Point2& light(std::size_t end) const { return flatland_.light()[end]; }

  int light_side(const Point2& p) const { return flatland_.has_point_light() ? 1 : orientation(light(0), light(1), p); }

  /// True if a point of the light's line lies on the light.
  bool is_on_light(const Point2& p) const {
    if (flatland_.has_point_light()) return p == light(0);
    const bool steep = light(0).x == light(1).x;
    const double at = steep ? p.y : p.x, start = steep ? light(0).y : light(0).x, end = steep ? light(1).y : light(1).x;
    return std::min(start, end) <= at && at <= std::max(start, end);
  }

  void add_light_ends() {
    for (std::uint32_t end = 0; end < flatland_.light().size(); ++end) {
      vertices_.push_back({{EventPointKind::light_end, 0, end}, Viewpoint(light(end)), 0, true, {}});
    }
  }

  void add_blocker_ends() {
    std::map<std::pair<double, double>, std::size_t> places;
    for (std::uint32_t i = 0; i < flatland_.blockers().size(); ++i) {
      for (const std::uint32_t end : {0U, 1U}) {
        const Point2& p = flatland_.blockers()[i][end];
        const auto [place, is_new] = places.try_emplace({p.x + 0.0, p.y + 0.0}, vertices_.size());
        if (is_new) {
          const int side = light_side(p);
          const bool on_light = (side == 0 || flatland_.has_point_light()) && is_on_light(p);
          vertices_.push_back({{EventPointKind::blocker_end, i, end}, Viewpoint(p), side, on_light, {}});
        }
        vertices_[place->second].neighbours.push_back(flatland_.blockers()[i][1 - end]);
      }
    }
  }

  void add_crossings() {
    for (std::uint32_t i = 0; i < flatland_.blockers().size(); ++i) {
      const BlockerSegment& blocker = flatland_.blockers()[i];
      if (light_side(blocker[0]) * light_side(blocker[1]) >= 0) continue;
      if (orientation(blocker[0], blocker[1], light(0)) * orientation(blocker[0], blocker[1], light(1)) > 0) continue;
      vertices_.push_back({{EventPointKind::crossing, i, 0},
                           Viewpoint(crossing_point(flatland_.light(), blocker)),
                           0,
                           true,
                           {blocker[0], blocker[1]}});
    }
  }

  /// True if `near` is the light's or lies between it and `far`, on a line through both that meets the light.
  bool reaches_light(const EventVertex& near, const EventVertex& far) const {
    if (near.on_light) return near.point.near() != far.point.near() || !near.point.is_input();
    if (flatland_.has_point_light() || near.side != far.side) return false;
    const Point2 &u = near.point.near(), &v = far.point.near();
    const int side = far.side;
    if (side * turn(light(0), light(1), u, v) <= 0) return false;
    return side * orientation(v, light(0), u) >= 0 && side * orientation(v, u, light(1)) >= 0;
  }

  /// The sides of the directed line from near to far on which blockers leave a vertex, toward the side of `far`.
  Touch touch(const EventVertex& vertex, const EventVertex& near, const EventVertex& far) const {
    Touch touch;
    for (const Point2& neighbour : vertex.neighbours) {
      if (!flatland_.has_point_light() && vertex.side == 0 && light_side(neighbour) != far.side) continue;
      const int side = orientation(near.point, far.point.near(), neighbour);
      touch.left = touch.left || side > 0;
      touch.right = touch.right || side < 0;
    }
    return touch;
  }

  /// The side on which the light leaves its own end: right of a line that runs from its end 0 to its left side.
  Touch light_end_touch(const EventVertex& near, const EventVertex& far) const {
    const bool right = (near.name.end == 0) == (far.side > 0);
    return {!right, right};
  }

  /// True if the crossing of a blocker with the line from near to far lies on the light's line or behind it.
  bool is_behind_light(const EventVertex& near, const EventVertex& far, const BlockerSegment& blocker) const {
    if (flatland_.has_point_light()) {
      const int of_light = orientation(blocker[0], blocker[1], light(0));
      return of_light * orientation(blocker[0], blocker[1], far.point.near()) >= 0;
    }
    const int at_0 = far.side * light_side(blocker[0]), at_1 = far.side * light_side(blocker[1]);
    if (at_0 > 0 && at_1 > 0) return false;
    if (at_0 <= 0 && at_1 <= 0) return true;
    if (at_0 * at_1 == 0) return false;  // the line meets the blocker off its ends, so above the light's line
    const std::size_t above = at_0 > 0 ? 0 : 1;
    const Viewpoint crossing(crossing_point(flatland_.light(), blocker));
    const ExactPoint c = crossing.exact(), u = near.point.exact(), v = far.point.exact();
    const Rational at_crossing = (v.x - u.x) * (c.y - u.y) - (v.y - u.y) * (c.x - u.x);
    return CGAL::sign(at_crossing) * orientation(near.point, far.point.near(), blocker[above]) >= 0;
  }

  /// How far behind `far` a blocker crosses the line from near to far, in doubles.
  double distance(const EventVertex& near, const EventVertex& far, const BlockerSegment& blocker) const {
    const Point2 &u = near.point.near(), &v = far.point.near(), &a = blocker[0], &b = blocker[1];
    const double ex = b.x - a.x, ey = b.y - a.y;
    return ((a.x - v.x) * ey - (a.y - v.y) * ex) / ((v.x - u.x) * ey - (v.y - u.y) * ex);
  }

  /// True if the event is seen from no point behind `far`; else `stop` is a blocker that ends the ray, if any does.
  /// Which of several is chosen decides nothing: what lies behind any of them sees nothing of the event.
  bool is_hidden(const EventVertex& near, const EventVertex& far, std::optional<std::uint32_t>& stop) const {
    double nearest = HUGE_VAL;
    const Point2& v = far.point.near();
    for (std::uint32_t i = 0; i < flatland_.blockers().size(); ++i) {
      const BlockerSegment& blocker = flatland_.blockers()[i];
      const int at_0 = orientation(near.point, v, blocker[0]);
      if (at_0 == 0) continue;
      if (at_0 * orientation(near.point, v, blocker[1]) >= 0) continue;
      const int beyond = -at_0 * orientation(blocker[0], blocker[1], v);
      if (beyond == 0) return true;
      if (beyond > 0) {
        const double at = distance(near, far, blocker);
        if (!stop || at < nearest) stop = i, nearest = at;
      } else if (!is_behind_light(near, far, blocker)) {
        return true;
      }
    }
    return false;
  }

  bool share_blocker(const EventVertex& near, const EventVertex& far) const {
    return std::ranges::any_of(near.neighbours, [&](const Point2& p) {
      return p == far.point.near() || orientation(near.point, far.point.near(), p) == 0;
    });
  }

  void add_ray(const EventVertex& near, const EventVertex& far, std::vector<EventRay>& rays) const {
    if (&near == &far || !reaches_light(near, far)) return;
    const bool is_light_end = near.name.kind == EventPointKind::light_end;
    const Touch at_far = touch(far, near, far);
    const Touch at_near = is_light_end ? light_end_touch(near, far) : touch(near, near, far);
    if (at_far.both() || at_near.both()) return;
    const bool opposite = (at_far.left && at_near.right) || (at_far.right && at_near.left);
    const bool same = (at_far.left && at_near.left) || (at_far.right && at_near.right);
    // Two ends that hide the light on one side take turns in bounding what is seen; no region ends there.
    if (detail_ == EventDetail::regions && same && !is_light_end && !share_blocker(near, far)) return;
    std::optional<std::uint32_t> stop;
    if (is_hidden(near, far, stop)) return;
    const Contact contact = opposite ? Contact::separating : Contact::supporting;
    rays.push_back({near.name, far.name, near.point.exact(), far.point.near(), contact, stop});
  }

  const Flatland& flatland_;
  EventDetail detail_;
  std::vector<EventVertex> vertices_;
};

}  // namespace

std::vector<EventRay> event_rays(const Flatland& flatland, EventDetail detail) {
  return EventSearch(flatland, detail).rays();
}

}  // namespace gnomon::planar
