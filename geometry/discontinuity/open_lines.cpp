#include "geometry/discontinuity/open_lines.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace gnomon::event {
namespace {

/// Sign of the volume of p, a, b, c where intervals tell.
int side(const PointEnclosure& p, const PointEnclosure& a, const PointEnclosure& b, const PointEnclosure& c) {
  const Interval volume = dot(cross(a - p, b - p), c - p);
  return volume.inf() > 0 ? 1 : volume.sup() < 0 ? -1 : 0;
}

}  // namespace

/// An arc and the pencil that tells shares of its base, in intervals.
struct OpenLines::NearArc {
  conic::NearCurve curve;
  std::array<std::array<Interval, 3>, 2> share;  ///< the pencil's values of w, x and y at its start and its end
  bool has_share_as_parameter;

  explicit NearArc(const ArcOfLines& arc) : curve(arc.arc.curve), has_share_as_parameter(!arc.arc.curve.is_straight) {
    long most = 0;
    for (const auto* line : {&arc.share.start, &arc.share.end}) {
      for (const Integer& x : *line) most = std::max(most, exponent_of(x));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      share[0][k] = scaled(arc.share.start[k], most);
      share[1][k] = scaled(arc.share.end[k], most);
    }
  }

  std::optional<Interval> base_share(const Interval& t, const conic::NearPoint& p) const {
    if (has_share_as_parameter) return t;
    const auto at = [&](const std::array<Interval, 3>& c) { return c[0] + c[1] * p.x + c[2] * p.y; };
    const Interval start = at(share[0]), way = start - at(share[1]);
    if (way.inf() <= 0 && way.sup() >= 0) return std::nullopt;
    return start / way;
  }
};

OpenLines::OpenLines(const EventScene& scene, std::span<const ShapeId> shapes, const ReceiverPlane& plane,
                     std::vector<FlatEnclosure> boxes)
    : scene_(scene), shapes_(shapes.begin(), shapes.end()), plane_(plane), boxes_(std::move(boxes)) {
  for (const EventPoint& p : scene.points) {
    const auto [x, y, z, w] = coordinates<Interval>(p);
    points_.push_back(p.kind == EventPoint::Kind::direction ? PointEnclosure{x, y, z}
                                                            : PointEnclosure{x / w, y / w, z / w});
  }
}

std::vector<conic::Range> OpenLines::ranges(const ArcOfLines& arc) {
  std::vector<conic::Range> found;
  append(arc, NearArc(arc), {arc.arc.from, arc.arc.to}, 0, shapes_, found);
  return found;
}

void OpenLines::append(const ArcOfLines& arc, const NearArc& near, const conic::Range& range, int halvings,
                       std::vector<ShapeId> shapes, std::vector<conic::Range>& found) {
  constexpr int most_halvings = 6;
  if (lines(arc, near, range, shapes) == Known::closed) return;
  if (halvings == most_halvings) {
    if (!found.empty() && found.back().to == range.from) {
      found.back().to = range.to;
    } else {
      found.push_back(range);
    }
    return;
  }
  const Rational middle = short_number_between(range.from, range.to);
  append(arc, near, {range.from, middle}, halvings + 1, shapes, found);
  append(arc, near, {middle, range.to}, halvings + 1, std::move(shapes), found);
}

/// Leaves out shapes that none of the lines meets.
OpenLines::Known OpenLines::lines(const ArcOfLines& arc, const NearArc& near, const conic::Range& range,
                                  std::vector<ShapeId>& shapes) {
  const Interval t = conic::enclosure(range);
  const auto flat = near.curve.points(t);
  if (!flat) return Known::perhaps;
  const auto is_beside = [&](const FlatEnclosure& box) {
    return conic::are_apart(flat->x, box.x) || conic::are_apart(flat->y, box.y);
  };
  if (std::all_of(boxes_.begin(), boxes_.end(), is_beside)) return Known::closed;
  const auto share = near.base_share(t, *flat);
  if (!share) return Known::perhaps;
  const PointEnclosure p = plane_.spatial(FlatEnclosure{flat->x, flat->y});
  const Outline& base = *arc.edges[0];
  PointEnclosure q;
  for (std::size_t k = 0; k < 3; ++k) q[k] = base.a.near[k] + *share * (base.b.near[k] - base.a.near[k]);
  if (!base.is_of_light) {
    // Where the line meets the light's plane.
    const auto& [a, b, c] = scene_.light_plane;
    const PointEnclosure normal = cross(points_[b] - points_[a], points_[c] - points_[a]);
    const Interval at_p = dot(normal, p - points_[a]), at_q = dot(normal, q - points_[a]), way = at_p - at_q;
    if (way.inf() <= 0 && way.sup() >= 0) return Known::perhaps;
    const Interval place = at_p / way;
    for (std::size_t k = 0; k < 3; ++k) q[k] = p[k] + place * (q[k] - p[k]);
    if (miss_light(p, q)) return Known::closed;
  }
  for (const Outline* edge : arc.edges) {
    if (edge->is_of_light) continue;
    for (const Place& face : edge->hidden) {
      // The line meets the face's plane on the edge, so its ends must lie on both sides.
      const int at_p = side(edge->a.near, edge->b.near, face.near, p),
                at_q = side(edge->a.near, edge->b.near, face.near, q);
      if (at_p * at_q > 0) return Known::closed;
    }
  }
  return leave_open(arc, p, q) || are_stopped(p, q, shapes) ? Known::closed : Known::perhaps;
}

/// Whether one edge bounds nothing, as faces at it lie on both sides; or what the three leave open has a direction in
/// common, as one turns both ways from one open side to the next.
bool OpenLines::leave_open(const ArcOfLines& arc, const PointEnclosure& p, const PointEnclosure& q) {
  std::array<PointEnclosure, 3> normals;
  std::array<int, 3> hidden{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Outline& edge = *arc.edges[k];
    normals[k] = cross(edge.a.near - p, edge.b.near - p);
    bool is_positive = false, is_negative = false, is_known = !edge.hidden.empty();
    for (const Place& face : edge.hidden) {
      const int at = side(p, edge.a.near, edge.b.near, face.near);
      is_positive = is_positive || at > 0;
      is_negative = is_negative || at < 0;
      is_known = is_known && at != 0;
    }
    if (is_positive && is_negative) return true;
    hidden[k] = !is_known ? 0 : is_positive ? 1 : -1;
  }
  bool is_up = false, is_down = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Interval turn = dot(cross(normals[k], normals[next]), q - p);
    const int sign = (turn.inf() > 0 ? 1 : turn.sup() < 0 ? -1 : 0) * hidden[k] * hidden[next];
    is_up = is_up || sign > 0;
    is_down = is_down || sign < 0;
  }
  return is_up && is_down;
}

/// The light's corners run counterclockwise seen from its front.
bool OpenLines::miss_light(const PointEnclosure& p, const PointEnclosure& q) const {
  const auto& corners = scene_.light_vertices;
  bool is_left = false, is_right = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const int at = side(p, points_[corners[k].point], points_[corners[(k + 1) % corners.size()].point], q);
    if (at == 0) continue;
    (at > 0 ? is_left : is_right) = true;
  }
  return is_left && is_right;
}

bool OpenLines::are_stopped(const PointEnclosure& p, const PointEnclosure& q, std::vector<ShapeId>& shapes) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const Meeting found = meeting(shapes[k], p, q);
    if (found == Meeting::all) {
      const auto own = std::find(shapes_.begin(), shapes_.end(), shapes[k]);
      std::rotate(shapes_.begin(), own, own + 1);
      return true;
    }
    if (found == Meeting::perhaps) shapes[kept++] = shapes[k];
  }
  shapes.resize(kept);
  return false;
}

OpenLines::Meeting OpenLines::meeting(const std::vector<PointId>& loop, const PointEnclosure& p,
                                      const PointEnclosure& q) const {
  bool is_left = false, is_right = false, is_known = true;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const int at = side(p, points_[loop[k]], points_[loop[(k + 1) % loop.size()]], q);
    is_left = is_left || at > 0;
    is_right = is_right || at < 0;
    is_known = is_known && at != 0;
    if (is_left && is_right) return Meeting::none;
  }
  const PointEnclosure &a = points_[loop[0]], &b = points_[loop[1]], &c = points_[loop[2]];
  const int sides = side(a, b, c, p) * side(a, b, c, q);
  if (sides > 0) return Meeting::none;
  return is_known && sides < 0 ? Meeting::all : Meeting::perhaps;
}

OpenLines::Meeting OpenLines::meeting(ShapeId shape, const PointEnclosure& p, const PointEnclosure& q) const {
  const Shape& s = scene_.shapes[shape];
  if (!s.is_solid) return meeting(s.corners, p, q);
  Meeting most = Meeting::none;
  for (const auto& facet : s.facets) {
    most = std::max(most, meeting(facet, p, q));
    if (most == Meeting::all) break;
  }
  return most;
}

}  // namespace gnomon::event
