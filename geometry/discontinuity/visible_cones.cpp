#include "geometry/discontinuity/visible_cones.h"

#include <algorithm>

namespace gnomon::event {
namespace {

/// Sign of the determinant of three vectors.
int determinant_sign(const std::array<Integer, 3>& u, const std::array<Integer, 3>& v,
                     const std::array<Integer, 3>& w) {
  const Integer x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
  const Integer sum = x * w[0] + y * w[1] + z * w[2];
  return sum.sign();
}

}  // namespace

NearVector VisibleCones::to(PointId point) const {
  const Point3& q = scene_.points[point].input;
  return NearVector{Interval(q.x), Interval(q.y), Interval(q.z)} - p_.near;
}

ExactVector VisibleCones::exact_way(PointId point) const {
  return exact(scene_.points[point].input) - p_.exact;
}

ExactVector VisibleCones::exact_normal(PlaneId plane) const {
  const PlaneThroughPoint& s = planes_[plane];
  return s.is_receivers ? receiver_.plane().normal : gnomon::cross(exact_way(s.a), exact_way(s.b));
}

ExactVector VisibleCones::exact_direction(const Corner& corner) const {
  return Rational(corner.sense) * gnomon::cross(exact_normal(corner.first), exact_normal(corner.second));
}

/// A positive multiple of a plane's normal.
const VisibleCones::WholeVector& VisibleCones::whole_normal(PlaneId plane) const {
  std::optional<WholeVector>& known = whole_normals_[plane];
  if (!known) {
    const ExactVector n = exact_normal(plane);
    const Integer all = lcm(lcm(denominator(n.x), denominator(n.y)), denominator(n.z));
    const auto whole = [&](const Rational& c) -> Integer { return numerator(Rational(c * all)); };
    known = WholeVector{whole(n.x), whole(n.y), whole(n.z)};
  }
  return *known;
}

VisibleCones::PlaneId VisibleCones::plane(PointId a, PointId b) {
  const auto ends = std::minmax(a, b);
  const auto [found, is_new] = plane_of_.try_emplace(ends, static_cast<PlaneId>(planes_.size()));
  if (is_new) planes_.push_back({ends.first, ends.second, false, cross(to(ends.first), to(ends.second))});
  return found->second;
}

/// On which side of a plane a point of the scene lies.
int VisibleCones::side(PlaneId plane, PointId point) const {
  const PlaneThroughPoint& s = planes_[plane];
  if (point == s.a || point == s.b) return 0;
  if (const auto known = certain_sign(dot(s.normal, to(point)))) return *known;
  return gnomon::dot(exact_normal(plane), exact_way(point)).sign();
}

std::optional<PointId> VisibleCones::common_point(PlaneId p, PlaneId q) const {
  const PlaneThroughPoint &s = planes_[p], &t = planes_[q];
  if (p == q || s.is_receivers || t.is_receivers) return std::nullopt;
  if (s.a == t.a || s.a == t.b) return s.a;
  if (s.b == t.a || s.b == t.b) return s.b;
  return std::nullopt;
}

/// True if names tell that the corner lies in the plane.
bool VisibleCones::holds(PlaneId plane, const Corner& corner) const {
  if (plane == corner.first || plane == corner.second || plane == corner.third) return true;
  const auto v = common_point(corner.first, corner.second);
  return v && (planes_[plane].a == *v || planes_[plane].b == *v) && !planes_[plane].is_receivers;
}

/// On which side of a plane a corner lies.
int VisibleCones::sign(PlaneId plane, Corner& corner) const {
  if (holds(plane, corner)) return 0;
  if (const auto known = certain_sign(dot(planes_[plane].normal, corner.direction))) return *known;
  whole_normals_.resize(planes_.size());
  const int exactly =
      corner.sense * determinant_sign(whole_normal(corner.first), whole_normal(corner.second), whole_normal(plane));
  if (exactly == 0) corner.third = plane;
  return exactly;
}

/// Where the side from a corner to the next passes through a plane, the next corner lying on that side of it.
///
/// Write h and k for what the plane's normal n gives for the corner d and for the next one e, of opposite signs. The
/// crossing is a positive multiple of |k| d + |h| e, so of +-(k d - h e) = +-(n x (d x e)), the sign being that of k;
/// and d x e is a positive multiple of the side's normal times the side `inside`, on which the piece lies.
VisibleCones::Corner VisibleCones::crossing(const Corner& from, int sign_at_next, PlaneId plane) const {
  Corner corner;
  corner.first = plane;
  corner.second = corner.third = from.side;
  corner.sense = sign_at_next * from.inside;
  corner.direction = cross(planes_[plane].normal, planes_[from.side].normal);
  if (corner.sense < 0) corner.direction = {-corner.direction[0], -corner.direction[1], -corner.direction[2]};
  return corner;
}

/// The light as one piece.
bool VisibleCones::add_light() {
  std::vector<PointId> corners;
  for (const LightVertex& v : scene_.light_vertices) corners.push_back(v.point);
  const int turn = side(plane(corners[0], corners[1]), corners[2]) * (corners[0] < corners[1] ? 1 : -1);
  if (turn == 0 || (turn > 0 && !scene_.is_two_sided)) return false;
  if (turn < 0) std::reverse(corners.begin(), corners.end());
  light_side_ = -turn;
  const std::size_t n = corners.size();
  Piece light(n);
  for (std::size_t k = 0; k < n; ++k) {
    const PointId a = corners[k], b = corners[(k + 1) % n];
    light[k].side = plane(a, b);
    light[k].inside = a < b ? 1 : -1;
    light[k].direction = to(a);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Corner& before = light[(k + n - 1) % n];
    light[k].first = before.side;
    light[k].second = light[k].third = light[k].side;
    light[k].sense = before.inside * light[k].inside;
  }
  pieces_.assign(1, std::move(light));
  return true;
}

/// Takes away what the receiver's plane hides.
bool VisibleCones::keep_before_receiver() {
  const ExactVector& n = receiver_.plane().normal;
  const auto id = static_cast<PlaneId>(planes_.size());
  planes_.push_back({0, 0, true, Place(n).near});
  return cut(pieces_.front(), {id, 1}, nullptr);
}

/// Keeps of a piece what lies inside of a bound, and tells what lies beyond. Returns: false if nothing with an inside
/// of its own is left; then the piece is as it was.
bool VisibleCones::cut(Piece& piece, const Bound& bound, Piece* beyond) {
  const std::size_t n = piece.size();
  std::vector<int> signs(n);
  bool any_inside = false, any_outside = false;
  for (std::size_t k = 0; k < n; ++k) {
    signs[k] = bound.inside * sign(bound.plane, piece[k]);
    any_inside = any_inside || signs[k] > 0;
    any_outside = any_outside || signs[k] < 0;
  }
  if (beyond) beyond->clear();
  if (!any_inside || !any_outside) return any_inside;
  Piece kept;
  const auto push = [&](Piece* to, Corner corner, bool along, int inside) {
    if (!to) return;
    if (along) {
      corner.side = bound.plane;
      corner.inside = inside;
    }
    to->push_back(std::move(corner));
  };
  for (std::size_t k = 0; k < n; ++k) {
    const int here = signs[k], next = signs[(k + 1) % n];
    if (here >= 0) push(&kept, piece[k], here == 0 && next < 0, bound.inside);
    if (here <= 0) push(beyond, piece[k], here == 0 && next > 0, -bound.inside);
    if (here * next >= 0) continue;
    Corner corner = crossing(piece[k], bound.inside * next, bound.plane);
    corner.side = piece[k].side;
    corner.inside = piece[k].inside;
    push(&kept, corner, next < 0, bound.inside);
    push(beyond, corner, next > 0, -bound.inside);
  }
  piece.swap(kept);
  return true;
}

/// The planes that bound a blocker as seen from p; none of one that is seen edge-on. Returns: false if this is not for
/// this level.
bool VisibleCones::append_bounds(const Shape& shape, std::vector<Bound>& bounds) {
  const Sides of_light = sides(shape.corners, [&](PointId q) { return scene_.light_side(q) * light_side_; });
  if (!of_light.positive) return true;
  if (!of_light.all_positive()) return false;
  for (const ShapeEdge& e : shape.edges) {
    const PlaneId id = plane(e.a, e.b);
    const Sides corners = sides(shape.corners, [&](PointId q) { return side(id, q); });
    if (corners.positive != corners.negative) bounds.push_back({id, corners.positive ? 1 : -1});
  }
  return !bounds.empty() || !shape.is_solid;
}

/// Appends what of a piece lies outside of a blocker.
void VisibleCones::append_outside(Piece& piece, std::span<const Bound> bounds, std::vector<Piece>& pieces) {
  const bool is_apart = std::any_of(bounds.begin(), bounds.end(), [&](const Bound& b) {
    return std::all_of(piece.begin(), piece.end(), [&](Corner& c) { return b.inside * sign(b.plane, c) <= 0; });
  });
  if (is_apart) return pieces.push_back(std::move(piece));
  Piece rest = piece, beyond;
  std::vector<Piece> found;
  for (const Bound& bound : bounds) {
    if (!cut(rest, bound, &beyond)) return pieces.push_back(std::move(piece));
    if (!beyond.empty()) found.push_back(std::move(beyond));
  }
  is_cut_ = true;
  std::move(found.begin(), found.end(), std::back_inserter(pieces));
}

bool VisibleCones::view(const ExactVector& p, std::span<const ShapeId> blockers) {
  if (scene_.kind != LightKind::area) return false;
  const CGAL::Protect_FPU_rounding<true> upward;
  p_ = Place(p);
  planes_.clear();
  whole_normals_.clear();
  plane_of_.clear();
  is_cut_ = false;
  if (!add_light() || !keep_before_receiver()) return false;
  std::vector<Bound> bounds;
  std::vector<Piece> left;
  for (const ShapeId s : blockers) {
    bounds.clear();
    if (!append_bounds(scene_.shapes[s], bounds)) return false;
    if (bounds.empty()) continue;
    left.clear();
    for (Piece& piece : pieces_) append_outside(piece, bounds, left);
    pieces_.swap(left);
  }
  return true;
}

Region VisibleCones::region() const {
  return pieces_.empty() ? Region::umbra : is_cut_ ? Region::penumbra : Region::lit;
}

/// A vertex of the light not behind the receiver's plane, or a blocker's before it and in front of the light: seen in a
/// direction that lies before it, so not in the opposite one.
bool VisibleCones::is_visible_vertex(PointId point) const {
  const Rational height = receiver_.plane().height(exact(scene_.points[point].input));
  if (height > 0 && scene_.light_side(point) == light_side_) return true;
  return height >= 0 && std::any_of(scene_.light_vertices.begin(), scene_.light_vertices.end(),
                                    [&](const LightVertex& v) { return v.point == point; });
}

bool VisibleCones::is_visible_vertex(const Corner& corner) const {
  if (const auto v = common_point(corner.first, corner.second)) return is_visible_vertex(*v);
  const PlaneThroughPoint &p = planes_[corner.first], &q = planes_[corner.second];
  if (p.is_receivers == q.is_receivers) return false;
  const PlaneThroughPoint& other = p.is_receivers ? q : p;
  return std::any_of(scene_.light_edges.begin(), scene_.light_edges.end(), [&](const LightEdge& e) {
    return (e.a == other.a && e.b == other.b) || (e.a == other.b && e.b == other.a);
  });
}

bool VisibleCones::shows_vertex() const {
  return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
    return std::any_of(piece.begin(), piece.end(), [&](const Corner& c) { return is_visible_vertex(c); });
  });
}

VisiblePart VisibleCones::part(const AreaLight& light) const {
  VisiblePart part;
  part.region = region();
  VisibleFacet seen{flat_facets(light.polygon).front(), {}};
  const ExactPlane plane = plane_through(seen.facet[0], seen.facet[1], seen.facet[2]);
  const Rational height = plane.height(p_.exact);
  for (const Piece& piece : pieces_) {
    ExactPolygon& polygon = seen.visible.emplace_back();
    for (const Corner& corner : piece) {
      const ExactVector way = exact_direction(corner);
      polygon.push_back(p_.exact + Rational(-height / plane.slope(way)) * way);
    }
    if (light_side_ > 0) std::reverse(polygon.begin(), polygon.end());
  }
  part.facets.push_back(std::move(seen));
  return part;
}

}  // namespace gnomon::event
