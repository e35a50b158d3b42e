#include "geometry/discontinuity/horizon_traces.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "geometry/discontinuity/shaft.h"

namespace gnomon::event {
namespace {

using FootId = std::uint32_t;

/// A place in which a vertex or an edge of light or blockers meets the receiver's plane.
struct FootPoint {
  FlatPoint point;
  FlatEnclosure near;
  EventElement edge;
  std::vector<ShapeId> shapes;  ///< none of the light
};

/// What a blocker has in the plane: a polygon by its sides in no order, a segment by its only side.
struct Foot {
  std::vector<FootId> corners;
  std::vector<std::array<FootId, 2>> sides;
};

Rational flat_turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Interval flat_turn(const FlatEnclosure& a, const FlatEnclosure& b, const FlatEnclosure& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

FlatEnclosure flat_enclosure(const FlatPoint& p) {
  const auto x = CGAL::to_interval(p.x), y = CGAL::to_interval(p.y);
  return {Interval(x.first, x.second), Interval(y.first, y.second)};
}

bool are_of_one_shape(const FootPoint& p, const FootPoint& q) {
  return p.shapes == q.shapes && p.shapes.size() == 1;
}

/// A line of sight in the plane, from a point of the light.
struct Sightline {
  FlatPoint start;
  FlatPoint far;  ///< the place in line that is farther from the light

  FlatPoint at(const Rational& share) const {
    return {start.x + share * (far.x - start.x), start.y + share * (far.y - start.y)};
  }
  /// The share of the way at which a point of the line, or one beside it, lies.
  Rational share(const FlatPoint& p) const {
    const Rational x = far.x - start.x, y = far.y - start.y;
    return ((p.x - start.x) * x + (p.y - start.y) * y) / (x * x + y * y);
  }
};

class HorizonTraces {
 public:
  HorizonTraces(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
                std::vector<NamedSegment>& segments)
      : scene_(scene), receiver_(scene.receivers[receiver]), plane_(plane), segments_(segments) {
    for (const PointId p : receiver_.corners) {
      corners_.push_back(plane_.flat(exact_place(scene_.points[p])));
      near_corners_.push_back(flat_enclosure(corners_.back()));
    }
  }

  void append(const LightBefore& light) {
    for (const LightBefore::Corner& c : light.corners) {
      if (c.height == 0) light_.push_back(foot_point(plane_.flat(c.point), c.edge));
    }
    if (light_.empty()) return;
    collect_feet();
    add_crossings_of_light();
    for (const FootPoint& u : light_) {
      for (const FootPoint& x : feet_) append_trace({u.point, x.point}, u.edge, x);
    }
    if (light_.size() < 2) return;
    for (FootId i = 0; i < feet_.size(); ++i) {
      for (FootId k = i + 1; k < feet_.size(); ++k) append_pair(feet_[i], feet_[k]);
    }
  }

 private:
  static FootPoint foot_point(FlatPoint p, const EventElement& edge) {
    const FlatEnclosure near = flat_enclosure(p);
    return {std::move(p), near, edge, {}};
  }

  int side(PointId p) const {
    const auto& c = receiver_.plane;
    if (p == c[0] || p == c[1] || p == c[2]) return 0;
    return orientation(scene_.points[c[0]], scene_.points[c[1]], scene_.points[c[2]], scene_.points[p]);
  }

  /// Blockers that may meet both the receiver's plane and a segment between receiver and light.
  std::vector<ShapeId> shapes_in_reach() const {
    std::vector<Point3> points;
    for (const PointId p : receiver_.corners) points.push_back(scene_.points[p].input);
    std::vector<RoughHalfSpace> region = shaft(scene_, points);
    const auto place = [&](std::size_t k) { return scene_.points[receiver_.plane[k]].input; };
    region.push_back(rough_half_space(place(0), step(place(0), place(1)), step(place(0), place(2))));
    region.push_back(reversed(region.back()));
    std::vector<ShapeId> found;
    find_boxes(scene_.shape_boxes, region, found);
    std::erase_if(found, [&](ShapeId s) { return EventScene::is_own(receiver_, s); });
    std::sort(found.begin(), found.end());
    return found;
  }

  void collect_feet() {
    for (const ShapeId s : shapes_in_reach()) {
      const Shape& shape = scene_.shapes[s];
      sides_.clear();
      for (const PointId p : shape.corners) sides_.emplace(p, side(p));
      const auto is = [&](int sign) {
        return std::any_of(sides_.begin(), sides_.end(), [&](const auto& known) { return known.second * sign > 0; });
      };
      const bool touches =
          std::any_of(sides_.begin(), sides_.end(), [](const auto& known) { return known.second == 0; });
      if (is(1) && (is(-1) || touches)) add_foot(s);
    }
  }

  void add_foot(ShapeId s) {
    const Shape& shape = scene_.shapes[s];
    Foot foot;
    if (!shape.is_solid) add_section(s, shape.corners, foot);
    for (const auto& loop : shape.facets) add_section(s, loop, foot);
    std::sort(foot.corners.begin(), foot.corners.end());
    foot.corners.erase(std::unique(foot.corners.begin(), foot.corners.end()), foot.corners.end());
    if (!foot.sides.empty()) bases_.push_back(std::move(foot));
  }

  /// What a loop of a blocker has in the plane: a side, a corner or, of a facet on which it stands, all of it.
  void add_section(ShapeId s, const std::vector<PointId>& loop, Foot& foot) {
    std::vector<FootId> ends;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const PointId p = loop[k], q = loop[(k + 1) % loop.size()];
      if (sides_.at(p) == 0) ends.push_back(foot_of(s, p, p));
      if (sides_.at(p) * sides_.at(q) < 0) ends.push_back(foot_of(s, p, q));
    }
    foot.corners.insert(foot.corners.end(), ends.begin(), ends.end());
    if (ends.size() == 2) foot.sides.push_back({ends[0], ends[1]});
    for (std::size_t k = 0; ends.size() > 2 && k < ends.size(); ++k) {
      foot.sides.push_back({ends[k], ends[(k + 1) % ends.size()]});
    }
  }

  /// The foot of an edge that passes through the plane, or of a vertex in it, named by an edge that rises there.
  FootId foot_of(ShapeId s, PointId p, PointId q) {
    const auto [found, is_new] = ids_.try_emplace(std::minmax(p, q), static_cast<FootId>(feet_.size()));
    if (is_new) feet_.push_back(foot_point(plane_.flat(place(p, q)), edge_at(s, p, q)));
    std::vector<ShapeId>& shapes = feet_[found->second].shapes;
    if (shapes.empty() || shapes.back() != s) shapes.push_back(s);
    return found->second;
  }

  ExactVector place(PointId p, PointId q) const {
    const ExactVector a = exact(scene_.points[p].input), b = exact(scene_.points[q].input);
    if (p == q) return a;
    const Rational at_a = plane_.plane().height(a), at_b = plane_.plane().height(b);
    return a + Rational(at_a / (at_a - at_b)) * (b - a);
  }

  EventElement edge_at(ShapeId s, PointId p, PointId q) const {
    const auto& edges = scene_.shapes[s].edges;
    const auto found = std::find_if(edges.begin(), edges.end(), [&](const ShapeEdge& e) {
      if (p != q) return std::minmax(e.a, e.b) == std::minmax(p, q);
      return (e.a == p && sides_.at(e.b) > 0) || (e.b == p && sides_.at(e.a) > 0);
    });
    return scene_.edges[found->edge].name;
  }

  /// Where blockers pass through the light, their feet end at its foot.
  void add_crossings_of_light() {
    if (light_.size() < 2) return;
    const FlatPoint a = light_[0].point, b = light_[1].point;
    for (const Foot& foot : bases_) {
      for (const auto& [i, k] : foot.sides) {
        const FlatPoint &p = feet_[i].point, &q = feet_[k].point;
        const Rational at_p = flat_turn(a, b, p), at_q = flat_turn(a, b, q), at_a = flat_turn(p, q, a),
                       at_b = flat_turn(p, q, b);
        if (at_p.sign() * at_q.sign() >= 0 || at_a.sign() * at_b.sign() >= 0) continue;
        const Sightline along{a, b};
        light_.push_back(foot_point(along.at(at_a / (at_a - at_b)), feet_[i].edge));
      }
    }
  }

  /// The line through two feet, as far as it comes from the light's foot.
  void append_pair(const FootPoint& x, const FootPoint& y) {
    if (are_of_one_shape(x, y) || misses(x.near, y.near, near_corners_)) return;
    const FootPoint &a = light_[0], &b = light_[1];
    if (misses(x.near, y.near, std::array{a.near, b.near})) return;
    const Rational at_a = flat_turn(x.point, y.point, a.point), at_b = flat_turn(x.point, y.point, b.point);
    if (at_a.sign() * at_b.sign() > 0 || at_a == at_b) return;
    const FlatPoint start = Sightline{a.point, b.point}.at(at_a / (at_a - at_b));
    if (start == x.point) return append_trace({start, y.point}, x.edge, y);
    const Sightline line{start, x.point};
    const Rational share = line.share(y.point);
    if (share < 0) return;
    if (share > 1) return append_trace({start, y.point}, x.edge, y);
    append_trace(line, y.edge, x);
  }

  /// True if the line certainly has all points on one side.
  template <class Points>
  static bool misses(const FlatEnclosure& p, const FlatEnclosure& q, const Points& points) {
    unsigned signs = 0;
    for (const FlatEnclosure& c : points) {
      const auto sign = certain_sign(flat_turn(p, q, c));
      signs |= !sign || *sign == 0 ? 3U : *sign > 0 ? 1U : 2U;
    }
    return signs != 3U;
  }

  void append_trace(const Sightline& line, const EventElement& first, const FootPoint& last) {
    if (line.start == line.far) return;
    if (misses(flat_enclosure(line.start), last.near, near_corners_) || !comes_from_light(line)) return;
    Rational end = 1;
    for (const FlatPoint& c : corners_) end = std::max(end, line.share(c));
    for (const Foot& foot : bases_) {
      if (end == 1) return;
      if (const auto stop = first_hidden(line, foot)) end = std::max(Rational(1), std::min(end, *stop));
    }
    if (end == 1) return;
    const int order = scene_.kind == LightKind::area ? 2 : 1;
    segments_.push_back({{line.far, line.at(end), 0},
                         {EventKind::horizon, first, last.edge, static_cast<std::uint8_t>(order), Extremal::none}});
  }

  /// False if the line runs in the plane of an area light, or behind it.
  bool comes_from_light(const Sightline& line) const {
    if (scene_.kind != LightKind::area) return true;
    const auto at = [&](std::size_t k) { return exact(scene_.points[scene_.light_plane[k]].input); };
    const Rational slope =
        plane_through(at(0), at(1), at(2)).slope(plane_.spatial(line.far) - plane_.spatial(line.start));
    return slope > 0 || (slope < 0 && scene_.is_two_sided);
  }

  /// The share of the way from which on a foot hides the light: where the line enters its inside, which for a wall's
  /// foot is where it crosses it.
  std::optional<Rational> first_hidden(const Sightline& line, const Foot& foot) const {
    std::map<FootId, int> turns;
    bool left = false, right = false;
    for (const FootId id : foot.corners) {
      const int t = flat_turn(line.start, line.far, feet_[id].point).sign();
      turns[id] = t;
      left = left || t > 0;
      right = right || t < 0;
    }
    if (!left || !right) return std::nullopt;
    std::optional<Rational> first, last;
    const auto meet = [&](const FlatPoint& p) {
      const Rational share = line.share(p);
      if (!first || share < *first) first = share;
      if (!last || share > *last) last = share;
    };
    for (const auto& [i, k] : foot.sides) {
      const FlatPoint &p = feet_[i].point, &q = feet_[k].point;
      if (turns[i] == 0) meet(p);
      if (turns[k] == 0) meet(q);
      if (turns[i] * turns[k] >= 0) continue;
      const Rational at_p = flat_turn(line.start, line.far, p), at_q = flat_turn(line.start, line.far, q);
      meet(Sightline{p, q}.at(at_p / (at_p - at_q)));
    }
    return *last > 0 ? first : std::nullopt;
  }

  const EventScene& scene_;
  const Shape& receiver_;
  const ReceiverPlane& plane_;
  std::vector<NamedSegment>& segments_;
  std::vector<FlatPoint> corners_;
  std::vector<FlatEnclosure> near_corners_;
  std::vector<FootPoint> light_;  ///< one or both ends of the light's foot, then where blockers' feet cross it
  std::vector<FootPoint> feet_;
  std::vector<Foot> bases_;
  std::map<std::pair<PointId, PointId>, FootId> ids_;
  std::map<PointId, int> sides_;  ///< of the corners of one shape
};

}  // namespace

void append_horizon_traces(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
                           const LightBefore& light, std::vector<NamedSegment>& segments) {
  HorizonTraces(scene, receiver, plane, segments).append(light);
}

}  // namespace gnomon::event
