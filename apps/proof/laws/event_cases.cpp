#include "apps/proof/laws/event_cases.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/exact.h"
#include "apps/proof/laws/pair_generator.h"
#include "apps/proof/laws/point_text.h"
#include "geometry/bodies/polygon_checks.h"
#include "gnomon/visibility.h"

namespace gnomon::laws {
namespace {

using Points = std::vector<Point3>;

bool are_parallel(const Point3& a, const Point3& b) {
  return is_zero(cross(exact(a), exact(b)));
}

bool are_dependent(const Point3& a, const Point3& b, const Point3& c) {
  return sign(dot(cross(exact(a), exact(b)), exact(c))) == 0;
}

/// A vector that is not parallel to another.
Point3 draw_beside(const Point3& other) {
  const Point3 v = draw_vector(2);
  if (!are_parallel(v, other)) return v;
  const Point3 x{1, 0, 0};
  return are_parallel(x, other) ? Point3{0, 1, 0} : x;
}

/// What is built around one point of the line of sight.
struct Part {
  OnLine what;
  Points points;  ///< the vertex, the edge's ends or the facet's corners first
  bool solid = false;
};

/// Draws the line of sight and parts around its points.
class Builder {
 public:
  Builder(Domain domain, const EventMix& mix) : bent_(domain == Domain::near_degenerate), mix_(mix) {
    start_ = draw_vector(2);
    along_ = draw_vector(2);
    if (along_ == Point3{}) along_ = {0, 0, 1};
    across_ = draw_beside(along_);
    little_ = bent_ && once_in(3) ? 0x1p-40 : 1;
  }

  /// The point of the line with that number; the space of two numbers around it is free.
  Point3 at(int number) const { return moved(start_, 3.0 * number, along_); }

  Part blocker(OnLine what, int number) { return part(what, at(number), once_in(4)); }
  Part light(int number) { return part(mix_.light, at(number), false); }

  const Point3& along() const { return along_; }
  const Point3& across() const { return across_; }

  Point3 draw_direction() {
    Point3 step = draw_beside(along_);
    if (bent_ && once_in(4)) step = moved(across_, 0x1p-30, step);
    return step;
  }

 private:
  Part part(OnLine what, const Point3& p, bool solid) {
    switch (what) {
      case OnLine::vertex:
        return {what, around_vertex(p, solid), solid};
      case OnLine::edge:
        return {what, around_edge(p, solid), solid};
      case OnLine::facet:
        return {what, around_facet(p, solid), solid};
      case OnLine::inside:
        break;
    }
    return {what, around_inside(p), false};
  }

  /// A direction of an edge on the line: in the plane of all, or anywhere.
  Point3 edge_direction() {
    if (!mix_.coplanar) return draw_beside(along_);
    const int turn = draw(-1, 1);
    return moved(once_in(2) ? Point3{-across_.x, -across_.y, -across_.z} : across_, turn, along_);
  }

  /// A vector to other vertices: anywhere, or near the plane of the line and `across`.
  Point3 draw_off() {
    const Point3 off = draw_vector(2);
    if (little_ == 1) return off;
    return moved(moved(moved({}, draw(-2, 2), across_), draw(-2, 2), along_), little_, off);
  }

  /// The vector, or another that is not a combination of the two.
  static Point3 independent(const Point3& v, const Point3& a, const Point3& b) {
    for (const Point3& step : {Point3{}, Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}}) {
      const Point3 candidate = moved(v, 1, step);
      if (!are_dependent(candidate, a, b)) return candidate;
    }
    return v;
  }

  Points around_vertex(const Point3& p, bool solid) {
    const Point3 a = draw_off();
    const Point3 u = are_parallel(a, along_) ? draw_beside(along_) : a;
    const Point3 v = independent(draw_off(), u, along_);
    if (solid) return {p, moved(p, 1, u), moved(p, 1, v), moved(p, 1, independent(draw_off(), u, v))};
    if (!once_in(3)) return {p, moved(p, 1, u), moved(p, 1, v)};
    return {p, moved(p, 1, u), moved(moved(p, 1, u), 1, v), moved(p, 1, v)};
  }

  Points around_edge(const Point3& p, bool solid) {
    const Point3 u = edge_direction();
    const Point3 v = independent(draw_off(), u, along_);
    const Point3 a = moved(p, -draw(1, 2), u), b = moved(p, draw(1, 2), u);
    if (solid) return {a, b, moved(p, 1, v), moved(p, 1, independent(draw_off(), u, v))};
    if (!once_in(3)) return {a, b, moved(p, 1, v)};
    return {a, b, moved(b, 1, v), moved(a, 1, v)};
  }

  Points around_facet(const Point3& p, bool solid) {
    const Point3 low = moved(p, -draw(1, 2), across_), high = moved(p, draw(1, 2), across_);
    Points points{moved(low, -1, along_), moved(low, 1, along_)};
    if (once_in(2)) {
      points.push_back(high);
    } else {
      points.push_back(moved(high, 1, along_));
      points.push_back(moved(high, -1, along_));
    }
    if (solid) points.push_back(moved(p, 1, independent(draw_off(), along_, across_)));
    return points;
  }

  Points around_inside(const Point3& p) {
    const Point3 u = draw_beside(along_);
    const Point3 v = independent(draw_vector(2), u, along_);
    if (once_in(2)) return {moved(moved(p, -1, u), -1, v), moved(p, 1, u), moved(p, 1, v)};
    const Point3 low = moved(p, -1, v), high = moved(p, 1, v);
    return {moved(low, -1, u), moved(low, 1, u), moved(high, 1, u), moved(high, -1, u)};
  }

  bool bent_;
  EventMix mix_;
  Point3 start_;
  Point3 along_;
  Point3 across_;
  double little_ = 1;
};

/// The same map of all points, exact for all of them.
using Map = std::function<Point3(const Point3&)>;

Map draw_map(Domain domain) {
  if (domain == Domain::random) return [](const Point3& p) { return p; };
  const double scale = std::ldexp(1.0, draw(-2, 2) * 10);
  if (once_in(3)) return [=](const Point3& p) { return Point3{scale * p.x, p.y, p.z}; };
  if (once_in(3)) return [](const Point3& p) { return moved({1e8, -1e8, 1e8}, 0x1p-20, p); };
  return [](const Point3& p) { return p; };
}

/// Moves a vertex beside the event by one ulp; of a quadrilateral none, which could not stay flat.
void nudge_last(Part& part) {
  const std::size_t own = part.what == OnLine::vertex ? 1 : part.what == OnLine::edge ? 2 : 3;
  const bool free = part.points.size() == 3 || (part.solid && part.points.size() > own);
  if (part.what != OnLine::inside && free && part.points.size() > own) part.points.back() = nudged(part.points.back());
}

/// The light's vertices turned to the point, the event's element first.
Points facing(Points light, OnLine what, const Point3& p) {
  if (plane_of(exact(light)).side(exact(p)) >= 0) return light;
  std::ranges::reverse(light);
  const std::ptrdiff_t last = what == OnLine::edge ? 2 : 1;
  std::rotate(light.begin(), light.end() - last, light.end());
  return light;
}

Light light_of(const Part& part, EventLight kind, const Point3& p) {
  const Points& points = part.points;
  if (kind == EventLight::linear) return LinearLight{points[0], points[1]};
  const bool two_sided = once_in(3);
  for (const Points& some : {points, Points{points[0], points[1], points[2]}}) {
    const Points turned = facing(some, part.what, p);
    if (ConvexPolygon::defect(turned)) continue;
    const ConvexPolygon polygon = ConvexPolygon::from_points(turned);
    if (polygon.is_flat()) return AreaLight{polygon, two_sided};
  }
  return AreaLight{ConvexPolygon::from_points({{0, 0, 9}, {0, 1, 9}, {1, 0, 9}})};
}

std::uint32_t index_in(const ConvexSolid& solid, const Part& part) {
  if (part.what == OnLine::vertex) return 0;
  const auto edges = solid.edges();
  const auto facets = solid.facets();
  if (part.what == OnLine::edge) {
    const auto found = std::ranges::find_if(edges, [](const auto& e) { return e.from == 0 && e.to == 1; });
    return static_cast<std::uint32_t>(found - edges.begin());
  }
  const auto apex = static_cast<std::uint32_t>(part.points.size() - 1);
  const auto found = std::ranges::find_if(facets, [&](const auto& f) { return std::ranges::count(f.loop, apex) == 0; });
  return static_cast<std::uint32_t>(found - facets.begin());
}

/// How many of a part's points are the event's.
std::size_t own_points(const Part& part) {
  if (part.what == OnLine::vertex) return 1;
  if (part.what == OnLine::edge) return 2;
  return part.what == OnLine::facet ? part.points.size() - (part.solid ? 1 : 0) : 0;
}

void add_blocker(const Part& part, EventCase& drawn) {
  const int of = int(drawn.blockers.size());
  const Points own(part.points.begin(), part.points.begin() + std::ptrdiff_t(own_points(part)));
  LinedUp element{of, part.what, own, 0};
  if (part.solid && !are_coplanar(part.points)) {
    const ConvexSolid solid = ConvexSolid::hull_of(part.points);
    element.index = index_in(solid, part);
    drawn.blockers.emplace_back(solid);
  } else {
    Points points = part.points;
    if (part.solid) points.resize(3);
    if (ConvexPolygon::defect(points)) points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    ConvexPolygon polygon = ConvexPolygon::from_points(points);
    if (!polygon.is_flat()) polygon = ConvexPolygon::from_points({points[0], points[1], points[2]});
    drawn.blockers.emplace_back(polygon);
  }
  drawn.elements.push_back(element);
}

/// A linear light's element: its first end, or all of it.
Part linear(Part part) {
  if (part.what == OnLine::vertex) part.points.resize(2);
  return part;
}

void map_all(Part& part, const Map& map) {
  for (Point3& p : part.points) p = map(p);
}

EventCase draw_event(Domain domain, EventLight kind, const EventMix& mix) {
  Builder builder(domain, mix);
  const Map map = draw_map(domain);
  const auto vector = [&](const Point3& v) { return moved(map(v), -1, map({})); };
  const int last = int(mix.blockers.size()) + 1;
  Part light = linear(builder.light(last));
  map_all(light, map);
  const Point3 point = map(builder.at(0));
  EventCase drawn{light_of(light, kind, point),     {}, point, map(builder.at(last)), vector(builder.across()),
                  vector(builder.draw_direction()), {}, 0};
  const bool nudge = domain == Domain::near_degenerate && once_in(3);
  for (std::size_t i = 0; i < mix.blockers.size(); ++i) {
    Part part = builder.blocker(mix.blockers[i], int(i) + 1);
    map_all(part, map);
    if (nudge) nudge_last(part);
    add_blocker(part, drawn);
  }
  const auto own = std::ptrdiff_t(own_points(light));
  Points element(light.points.begin(), light.points.begin() + own);
  drawn.elements.push_back({-1, mix.light, element, 0});
  if (once_in(6)) {
    const Point3 p = draw_vector(4);
    const Points extra{p, moved(p, 1, draw_vector(2)), moved(p, 1, draw_vector(2))};
    if (!ConvexPolygon::defect(extra)) drawn.blockers.emplace_back(ConvexPolygon::from_points(extra));
  }
  drawn.choice = draw(0, 3);
  return drawn;
}

}  // namespace

std::string description(const EventCase& drawn) {
  std::ostringstream out;
  out << std::setprecision(17);
  const auto* area = std::get_if<AreaLight>(&drawn.light);
  write(out, area && area->two_sided ? "two-sided light" : "light", light_points(drawn.light));
  for (const ConvexBlocker& blocker : drawn.blockers) {
    const bool solid = std::holds_alternative<ConvexSolid>(blocker);
    std::visit([&](const auto& shape) { write(out, solid ? "solid" : "polygon", shape.points()); }, blocker);
  }
  write(out, "point", std::span(&drawn.point, 1));
  write(out, "looks to", std::span(&drawn.on_light, 1));
  write(out, "moves along", std::span(&drawn.direction, 1));
  for (const LinedUp& element : drawn.elements) write(out, element.of < 0 ? "of light" : "in line", element.points);
  return out.str();
}

Example example(const EventCase& drawn) {
  return spatial_example(drawn.light, drawn.blockers, {drawn.point});
}

void count_regions(const EventCase& drawn, Census& census) {
  census.add_point(exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point).region);
}

rc::Gen<EventCase> event_cases(Domain domain, EventLight light, const std::vector<EventMix>& kinds) {
  return rc::gen::exec([=] { return draw_event(domain, light, kinds[std::size_t(draw(0, int(kinds.size()) - 1))]); });
}

}  // namespace gnomon::laws
