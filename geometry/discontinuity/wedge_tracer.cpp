#include <algorithm>
#include <cmath>

#include "geometry/discontinuity/ray_ranges.h"
#include "geometry/discontinuity/shape_section.h"
#include "geometry/discontinuity/wedge.h"

// Notation. v: the wedge's apex, a vertex. a, b: the ends of its edge. The pencil: the lines through v in the plane
// (v, a, b) that meet the edge; each is a ray (node, cone), named by a node that it passes and by the half on which
// that lies. x, y, z: the coordinates of a point of the plane with respect to v, a, b; so x is positive on the apex's
// side of the edge, y and z of the lines that meet the edge are of one sign, and the cone "towards" holds the edge,
// "away" is the other half of each line. A range: the lines from a first to a last one, as the pencil orders them.
//
// The argument. A point of a receiver is on the trace if its line through the edge and the apex comes from the light,
// is not blocked on the way to the farther of the two, nor from there to the receiver. So three sets of lines are
// ranges of one order, and what is left of the first without the others is the trace:
//   allowed  lines that meet the light beyond the nearer element (find_allowed): the plane cuts a convex light in one
//            segment; of a coplanar pair those alone that meet the far edge (keep_far); without the lines that a shape
//            blocks between light and farther element (subtract_towards_light);
//   range    lines that meet the receiver from its front (receiver_range), for it is convex;
//   blocked  lines that an obstacle meets before the receiver's plane (append_blocked). An obstacle wholly before the
//            plane blocks all lines that it meets; one that crosses it, those that meet what of it lies before.
// A shape is convex, so the lines that meet its section are one range; one that the plane of the pencil does not cut in
// two has no inside there and stops none (shape_section). Searches in boxes may find too much and never too little:
// every shape found is judged exactly.

namespace gnomon::event {
namespace {

RoughVector direction(const EventPoint& from, const Point3& to) {
  if (from.kind == EventPoint::Kind::direction) return {from.input.x, from.input.y, from.input.z};
  return {to.x - from.input.x, to.y - from.input.y, to.z - from.input.z};
}

/// Receivers lie beyond a blocker's edge.
bool is_beyond_edge(WedgeKind kind) {
  return kind == WedgeKind::from_light_vertex || kind == WedgeKind::apex_first;
}

Cone opposite(Cone cone) {
  return cone == Cone::towards ? Cone::away : Cone::towards;
}

}  // namespace

void WedgeTracer::set_half_spaces(const Wedge& wedge) {
  const EventPoint& v = scene_.points[wedge.apex];
  const Point3 &a = scene_.points[wedge.a].input, &b = scene_.points[wedge.b].input;
  const auto to_a = direction(v, a), to_b = direction(v, b);
  const RoughVector along{b.x - a.x, b.y - a.y, b.z - a.z};
  half_spaces_[0] = rough_half_space(a, to_a, along);
  half_spaces_[1] = reversed(half_spaces_[0]);
  half_spaces_[2] = rough_side(half_spaces_[0], to_a, a, b);
  half_spaces_[3] = rough_side(half_spaces_[0], to_b, b, a);
  const bool finite = v.kind != EventPoint::Kind::direction;
  const Point3 side{a.x + to_a[0], a.y + to_a[1], a.z + to_a[2]};
  half_spaces_[4] = rough_side(half_spaces_[0], along, a, finite ? v.input : side);
  using enum EventPoint::Kind;
  const auto is_constructed = [&](PointId p) { return scene_.points[p].kind == constructed; };
  if (!is_constructed(wedge.apex) && !is_constructed(wedge.a) && !is_constructed(wedge.b)) return;
  // Constructed points are rounded here, by less than this.
  const auto size_of = [](const Point3& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); };
  const double shift = 0x1p-50 * std::max({finite ? size_of(v.input) : 0, size_of(a), size_of(b)});
  const double reach = sum_norm(to_a) + sum_norm(to_b) + sum_norm(along);
  for (std::size_t k = 0; k < half_spaces_.size(); ++k) {
    RoughHalfSpace& h = half_spaces_[k];
    h.error += 4 * shift * (k < 2 ? reach : reach * reach);
    h.offset += 4 * shift * sum_norm(h.normal);
  }
}

/// An edge between two faces, one on either side, is no part of an outline.
bool WedgeTracer::is_between_faces(const Pencil& pencil, const Wedge& wedge) const {
  if (wedge.kind == WedgeKind::from_light_edge) return false;
  return sides(scene_.edges[wedge.edge].faces, [&](const FaceAtEdge& f) { return pencil.side(f.third); }).cross();
}

WedgeTracer::Nodes WedgeTracer::light_section(Pencil& pencil) const {
  Nodes nodes;
  for (const LightEdge& edge : scene_.light_edges) {
    const int s = pencil.side(edge.a), t = pencil.side(edge.b);
    if (s == 0) nodes.push_back(pencil.add_point(edge.a));
    if (t == 0 && scene_.kind == LightKind::linear) nodes.push_back(pencil.add_point(edge.b));
    if (s * t < 0) nodes.push_back(s > 0 ? pencil.add_crossing(edge.a, edge.b) : pencil.add_crossing(edge.b, edge.a));
  }
  return nodes;
}

bool WedgeTracer::passes_through_apex(const Pencil& pencil, const Nodes& segment) const {
  if (segment.size() != 2) return false;
  const Ray p{segment[0], Cone::towards}, q{segment[1], Cone::towards};
  if (pencil.order(p, q) != 0) return false;
  const auto opposite_in = [&](FunctionId f) { return pencil.sign(f, p.node) * pencil.sign(f, q.node) < 0; };
  return opposite_in(Pencil::y) || opposite_in(Pencil::z);
}

FunctionId WedgeTracer::light_function(Pencil& pencil, const Wedge& wedge) {
  if (!light_function_ && scene_.kind == LightKind::linear) {
    // In the plane of a linear light any plane through it does that leaves this plane.
    const LightEdge& light = scene_.light_edges[0];
    PointId off = 0;
    while (pencil.side(off) == 0) ++off;
    const int side =
        orientation(scene_.points[light.a], scene_.points[light.b], scene_.points[off], scene_.points[wedge.apex]);
    light_function_ = pencil.add_plane({light.a, light.b, off}, side);
  }
  if (!light_function_) {
    const int side = is_from_light_at_apex(wedge.kind) ? 1 : scene_.light_side(wedge.apex);
    light_function_ = pencil.add_plane(scene_.light_plane, side);
  }
  return *light_function_;
}

/// Keeps of a section what lies on the apex's side of the light's plane. Returns: false if nothing does.
bool WedgeTracer::is_before_light(Pencil& pencil, const Wedge& wedge, const Shape& shape, Nodes& nodes) {
  const bool is_linear = scene_.kind == LightKind::linear;
  if (is_linear || (shape.is_in_front && shape.is_behind)) return pencil.clip(nodes, light_function(pencil, wedge), 1);
  if (!shape.is_in_front && !shape.is_behind) return false;
  return !scene_.is_two_sided ? shape.is_in_front : shape.is_in_front == (scene_.light_side(wedge.apex) > 0);
}

/// Takes away the lines that are blocked between the apex and the light. Returns: false if none is left.
bool WedgeTracer::subtract_towards_light(Pencil& pencil, const Wedge& wedge, Cone cone) {
  const bool to_edge = wedge.kind == WedgeKind::from_light_edge;
  std::array<RoughHalfSpace, 5> region = half_spaces_;
  if (cone == Cone::away) {
    region[2] = reversed(region[2]);
    region[3] = reversed(region[3]);
  }
  find_boxes(scene_.shape_boxes, std::span(region).first(to_edge ? 5 : 4), found_);
  blocked_.clear();
  Nodes nodes;
  for (const std::uint32_t s : found_) {
    const Shape& shape = scene_.shapes[s];
    if (!section(pencil, shape, nodes)) continue;
    if (!shape.is_solid && passes_through_apex(pencil, nodes)) return false;
    if (!pencil.clip_to(nodes, cone)) continue;
    if (to_edge && !pencil.clip(nodes, Pencil::x, 1)) continue;
    if (!to_edge && !is_before_light(pencil, wedge, shape, nodes)) continue;
    if (const auto range = pencil.range(nodes, cone)) blocked_.push_back(*range);
  }
  subtract(pencil, blocked_, allowed_);
  return !allowed_.empty();
}

/// Keeps the lines that meet the far edge of a coplanar pair before the light. Returns: false if there are none.
bool WedgeTracer::keep_far(Pencil& pencil, const Wedge& wedge) {
  if (!wedge.far || (wedge.far->a == wedge.a && wedge.far->b == wedge.b)) return true;
  const Nodes segment{pencil.add_point(wedge.far->a), pencil.add_point(wedge.far->b)};
  if (pencil.is_apex(segment[0]) || pencil.is_apex(segment[1]) || passes_through_apex(pencil, segment)) return true;
  std::vector<RayRange> kept;
  for (const Cone cone : {Cone::towards, Cone::away}) {
    if (cone == Cone::away && wedge.kind != WedgeKind::apex_first) continue;
    Nodes nodes = segment;
    if (!pencil.clip_to(nodes, cone)) continue;
    const bool beyond_edge = wedge.kind == WedgeKind::edge_first;
    if (cone == Cone::towards && !pencil.clip(nodes, Pencil::x, beyond_edge ? -1 : 1)) continue;
    const bool may_pass_light = !wedge.far->is_on_light && (beyond_edge || cone == Cone::away);
    if (may_pass_light && !pencil.clip(nodes, light_function(pencil, wedge), 1)) continue;
    const auto range = pencil.range(nodes, cone);
    RayRange common = allowed_[0];
    if (range && intersect(pencil, common, *range)) kept.push_back(common);
  }
  if (kept.size() == 2 && pencil.order(kept[0].first, kept[1].first) < 0) std::swap(kept[0], kept[1]);
  allowed_.swap(kept);
  return !allowed_.empty();
}

/// The lines from the light that reach the far side of the apex. Returns: false if there are none.
bool WedgeTracer::find_allowed(Pencil& pencil, const Wedge& wedge) {
  const Cone cone = receivers_cone(wedge.kind);
  allowed_.assign(1, {{Pencil::end_a, Cone::towards}, {Pencil::end_b, Cone::towards}});
  const bool from_apex = is_from_light_at_apex(wedge.kind);
  if (!from_apex && wedge.kind != WedgeKind::from_light_edge) {
    Nodes light = light_section(pencil);
    if (light.size() < 2 || !pencil.clip_to(light, opposite(cone))) return false;
    if (wedge.kind == WedgeKind::edge_first && !pencil.clip(light, Pencil::x, -1)) return false;
    const auto range = pencil.range(light, opposite(cone));
    if (!range || !intersect(pencil, allowed_[0], *range)) return false;
  }
  if (!keep_far(pencil, wedge)) return false;
  return from_apex || subtract_towards_light(pencil, wedge, opposite(cone));
}

/// Returns: false if a blocker on the apex stops every line.
bool WedgeTracer::collect_obstacles(Pencil& pencil, const Wedge& wedge, Cone cone) {
  std::array<RoughHalfSpace, 5> region = half_spaces_;
  if (cone == Cone::away) {
    region[2] = reversed(region[2]);
    region[3] = reversed(region[3]);
  }
  find_boxes(scene_.shape_boxes, std::span(region).first(4), found_);
  obstacles_.clear();
  Nodes nodes;
  for (const std::uint32_t s : found_) {
    const Shape& shape = scene_.shapes[s];
    if (!section(pencil, shape, nodes)) continue;
    const bool on_apex = !shape.is_solid && !is_from_light_at_apex(wedge.kind);
    if (on_apex && passes_through_apex(pencil, nodes)) return false;
    if (!pencil.clip_to(nodes, cone)) continue;
    if (const auto range = pencil.range(nodes, cone)) obstacles_.push_back({s, nodes, *range});
  }
  return true;
}

bool WedgeTracer::receiver_range(Pencil& pencil, const Wedge& wedge, Cone cone, const Shape& receiver,
                                 RayRange& range) {
  Nodes nodes;
  if (!section(pencil, receiver, nodes) || !pencil.clip_to(nodes, cone)) return false;
  if (is_beyond_edge(wedge.kind) && !pencil.clip(nodes, Pencil::x, -1)) return false;
  if (is_from_light_at_apex(wedge.kind) && scene_.kind == LightKind::area && !scene_.is_two_sided &&
      !pencil.clip(nodes, light_function(pencil, wedge), 1)) {
    return false;
  }
  const auto found = pencil.range(nodes, cone);
  if (found) range = *found;
  return found.has_value();
}

/// The lines that are blocked before they come to the receiver.
void WedgeTracer::append_blocked(Pencil& pencil, const Shape& receiver, FunctionId plane, const RayRange& range,
                                 Cone cone) {
  for (const Obstacle& obstacle : obstacles_) {
    if (EventScene::is_own(receiver, obstacle.shape)) continue;
    RayRange common = range;
    if (!intersect(pencil, common, obstacle.range)) continue;
    bool before = false, behind = false;
    for (const NodeId node : obstacle.polygon) {
      const int side = pencil.sign(plane, node);
      before = before || side > 0;
      behind = behind || side < 0;
    }
    if (!before) continue;
    if (!behind) {
      blocked_.push_back(obstacle.range);
      continue;
    }
    Nodes nodes = obstacle.polygon;
    if (!pencil.clip(nodes, plane, 1)) continue;
    if (const auto part = pencil.range(nodes, cone)) blocked_.push_back(*part);
  }
}

namespace {

/// Where a line of the pencil meets a plane given by its values at apex, a and b.
Quadruple<ExactReal> point_on_plane(std::span<const EventPoint> points, const Pencil& pencil, const Ray& ray,
                                    const std::array<ExactReal, 3>& plane) {
  const auto& e = pencil.exact(ray.node);
  const ExactReal share = -(plane[1] * e[1] + plane[2] * e[2]);
  const ExactReal y = plane[0] * e[1], z = plane[0] * e[2];
  const auto v = coordinates<ExactReal>(points[pencil.apex()]), a = coordinates<ExactReal>(points[pencil.a()]),
             b = coordinates<ExactReal>(points[pencil.b()]);
  Quadruple<ExactReal> result;
  for (std::size_t k = 0; k < 4; ++k) result[k] = share * v[k] + y * a[k] + z * b[k];
  if (CGAL::sign(result[3]) == CGAL::NEGATIVE) {
    for (ExactReal& c : result) c = -c;
  }
  return result;
}

}  // namespace

void WedgeTracer::trace_on(Pencil& pencil, const Wedge& wedge, Cone cone, std::uint32_t r, std::vector<Trace>& traces) {
  const Shape& receiver = scene_.receivers[r];
  RayRange range;
  if (!receiver_range(pencil, wedge, cone, receiver, range)) return;
  const auto place = [&](std::size_t k) -> const EventPoint& { return scene_.points[receiver.plane[k]]; };
  const int side = orientation(place(0), place(1), place(2), scene_.points[wedge.apex]);
  // A receiver receives with its front. Lines through an apex in its plane run along it: see horizon_traces.h.
  if (side <= 0) return;
  std::vector<RayRange> left;
  for (RayRange part : allowed_) {
    if (intersect(pencil, part, range)) left.push_back(part);
  }
  if (left.empty()) return;
  const FunctionId plane = pencil.add_plane(receiver.plane, side);
  blocked_.clear();
  append_blocked(pencil, receiver, plane, range, cone);
  subtract(pencil, blocked_, left);
  if (left.empty()) return;
  const auto& values = pencil.exact_function(plane);
  for (const RayRange& part : left) {
    traces.push_back({r,
                      0,
                      {point_on_plane(scene_.points, pencil, part.first, values),
                       point_on_plane(scene_.points, pencil, part.last, values)}});
  }
}

bool WedgeTracer::begin(Pencil& pencil, const Wedge& wedge) {
  if (!pencil.is_plane() || is_between_faces(pencil, wedge)) return false;
  light_function_.reset();
  set_half_spaces(wedge);
  if (!find_allowed(pencil, wedge)) return false;
  const Cone cone = receivers_cone(wedge.kind);
  std::array<RoughHalfSpace, 5> region = half_spaces_;
  region[4] = reversed(region[4]);
  if (cone == Cone::away) {
    region[2] = reversed(region[2]);
    region[3] = reversed(region[3]);
  }
  find_boxes(scene_.receiver_boxes, std::span(region).first(is_beyond_edge(wedge.kind) ? 5 : 4), found_receivers_);
  return true;
}

void WedgeTracer::append_traces(const Wedge& wedge, std::vector<Trace>& traces) {
  Pencil pencil(scene_.points, wedge.apex, wedge.a, wedge.b);
  if (!begin(pencil, wedge) || found_receivers_.empty()) return;
  const Cone cone = receivers_cone(wedge.kind);
  if (!collect_obstacles(pencil, wedge, cone)) return;
  for (const std::uint32_t r : found_receivers_) trace_on(pencil, wedge, cone, r, traces);
}

bool WedgeTracer::look_along(Pencil& pencil, const Wedge& wedge) {
  const Cone cone = receivers_cone(wedge.kind);
  if (!begin(pencil, wedge) || !collect_obstacles(pencil, wedge, cone)) return false;
  Nodes nodes;
  for (const std::uint32_t r : found_receivers_) {
    if (!section(pencil, scene_.receivers[r], nodes) || !pencil.clip_to(nodes, cone)) continue;
    if (is_beyond_edge(wedge.kind) && !pencil.clip(nodes, Pencil::x, -1)) continue;
    if (const auto range = pencil.range(nodes, cone)) obstacles_.push_back({0, nodes, *range});
  }
  return true;
}

}  // namespace gnomon::event
