#include "geometry/discontinuity/plane_traces.h"

#include <algorithm>
#include <optional>

namespace gnomon::event {
namespace {

/// Finds and appends the segments of one receiver.
class PlaneTraces {
 public:
  PlaneTraces(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
              std::vector<NamedSegment>& segments)
      : scene_(scene), receiver_(scene.receivers[receiver]), plane_(plane), segments_(segments) {
    for (const LightVertex& v : scene_.light_vertices) {
      const int s = side(scene_.points[v.point]);
      light_behind_ = light_behind_ || s < 0;
    }
  }

  void append_contacts() {
    for (const ShapeId s : shapes_near_plane()) {
      if (scene_.shapes[s].is_solid) {
        append_solid_contact(s);
      } else {
        append_flat_contact(s);
      }
    }
  }

  void append_light_plane() {
    if (scene_.kind != LightKind::area) return;
    std::vector<FlatPoint> ends;
    const auto& c = receiver_.corners;
    for (std::size_t k = 0; k < c.size(); ++k) {
      const PointId p = c[k], q = c[(k + 1) % c.size()];
      const int s = scene_.light_side(p), t = scene_.light_side(q);
      if (s == 0) ends.push_back(plane_.flat(exact(scene_.points[p].input)));
      if (s * t < 0) ends.push_back(plane_.flat(crossing(light_plane(), p, q)));
    }
    if (ends.size() != 2) return;
    add(ends[0], ends[1], {EventKind::light_plane, {EventOf::light, 0, 0}, {EventOf::light, 0, 0}, 0, Extremal::none});
  }

  void append_facet_planes() {
    if (scene_.kind != LightKind::area && scene_.kind != LightKind::linear) return;
    for (ShapeId s = 0; s < scene_.shapes.size(); ++s) {
      const Shape& shape = scene_.shapes[s];
      if (!shape.is_solid) append_facet_plane(shape.corners, {EventOf::blocker, s, 0});
      for (std::uint32_t f = 0; f < shape.facets.size(); ++f) {
        append_facet_plane(shape.facets[f], {EventOf::blocker, s, f});
      }
    }
  }

 private:
  int side(const EventPoint& p) const {
    const auto& c = receiver_.corners;
    return orientation(scene_.points[c[0]], scene_.points[c[1]], scene_.points[c[2]], p);
  }

  std::vector<ShapeId> shapes_near_plane() const {
    const auto& c = receiver_.corners;
    const Point3 &p = scene_.points[c[0]].input, &q = scene_.points[c[1]].input, &r = scene_.points[c[2]].input;
    std::vector<RoughHalfSpace> region{
        rough_half_space(p, {q.x - p.x, q.y - p.y, q.z - p.z}, {r.x - p.x, r.y - p.y, r.z - p.z})};
    region.push_back(reversed(region[0]));
    for (std::size_t k = 0; k < c.size(); ++k) {
      const Point3 &a = scene_.points[c[k]].input, &b = scene_.points[c[(k + 1) % c.size()]].input;
      region.push_back(
          rough_side(region[0], {b.x - a.x, b.y - a.y, b.z - a.z}, a, scene_.points[c[(k + 2) % c.size()]].input));
    }
    std::vector<ShapeId> found;
    scene_.shape_boxes.search(region, found);
    std::sort(found.begin(), found.end());
    return found;
  }

  ExactPlane light_plane() const {
    const auto& l = scene_.light_plane;
    return plane_through(exact(scene_.points[l[0]].input), exact(scene_.points[l[1]].input),
                         exact(scene_.points[l[2]].input));
  }

  ExactVector crossing(const ExactPlane& plane, PointId p, PointId q) const {
    const ExactVector a = exact(scene_.points[p].input), b = exact(scene_.points[q].input);
    const Rational at_a = plane.height(a), at_b = plane.height(b);
    return a + Rational(at_a / (at_a - at_b)) * (b - a);
  }

  void add(const FlatPoint& p, const FlatPoint& q, const EventName& name) {
    if (!(p == q)) segments_.push_back({{p, q, 0}, name});
  }

  EventName contact(ShapeId shape, std::uint32_t index) const {
    const EventElement element{EventOf::blocker, shape, index};
    return {EventKind::contact, element, element, 0, Extremal::none};
  }

  FlatPoint flat_corner(PointId p) const { return plane_.flat(exact(scene_.points[p].input)); }

  /// A loop that touches the receiver's plane with all its vertices.
  void add_outline(const std::vector<PointId>& loop, const EventName& name) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      add(flat_corner(loop[k]), flat_corner(loop[(k + 1) % loop.size()]), name);
    }
  }

  /// Adds where a loop passes through the receiver's plane, or stands on it with an edge.
  void add_section(const std::vector<PointId>& loop, const EventName& name) {
    std::vector<FlatPoint> ends;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const PointId p = loop[k], q = loop[(k + 1) % loop.size()];
      const int s = side(scene_.points[p]), t = side(scene_.points[q]);
      if (s == 0) ends.push_back(flat_corner(p));
      if (s * t < 0) ends.push_back(plane_.flat(crossing(plane_.plane(), p, q)));
    }
    if (ends.size() == 2) add(ends[0], ends[1], name);
  }

  std::array<bool, 2> sides_of(const std::vector<PointId>& corners) const {
    std::array<bool, 2> sides{};
    for (const PointId p : corners) {
      const int s = side(scene_.points[p]);
      if (s != 0) sides[s > 0 ? 0 : 1] = true;
    }
    return sides;
  }

  void append_flat_contact(ShapeId s) {
    const Shape& shape = scene_.shapes[s];
    const auto [in_front, behind] = sides_of(shape.corners);
    if (in_front || behind) return add_section(shape.corners, contact(s, 0));
    if (light_behind_) add_outline(shape.corners, contact(s, 0));
  }

  void append_solid_contact(ShapeId s) {
    const Shape& shape = scene_.shapes[s];
    const auto [in_front, behind] = sides_of(shape.corners);
    if (in_front && behind) {
      for (std::uint32_t f = 0; f < shape.facets.size(); ++f) add_section(shape.facets[f], contact(s, f));
      return;
    }
    if (behind && !light_behind_) return;
    for (std::uint32_t f = 0; f < shape.facets.size(); ++f) {
      const auto [above, below] = sides_of(shape.facets[f]);
      if (!above && !below) add_outline(shape.facets[f], contact(s, f));
    }
  }

  void append_facet_plane(const std::vector<PointId>& loop, const EventElement& element) {
    const auto facet_side = [&](PointId p) {
      return orientation(scene_.points[loop[0]], scene_.points[loop[1]], scene_.points[loop[2]], scene_.points[p]);
    };
    const auto is_cut = [&](const auto& ids) {
      bool above = false, below = false;
      for (const PointId p : ids) {
        const int s = facet_side(p);
        above = above || s > 0;
        below = below || s < 0;
      }
      return above && below;
    };
    std::vector<PointId> light;
    for (const LightVertex& v : scene_.light_vertices) light.push_back(v.point);
    if (!is_cut(light) || !is_cut(receiver_.corners)) return;
    trace_facet_plane(loop, light, element);
  }

  std::vector<ExactVector> cut_points(const ExactPlane& plane, const std::vector<PointId>& loop) const {
    std::vector<ExactVector> points;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const PointId p = loop[k], q = loop[(k + 1) % loop.size()];
      const Rational at_p = plane.height(exact(scene_.points[p].input)),
                     at_q = plane.height(exact(scene_.points[q].input));
      if (at_p == 0) points.push_back(exact(scene_.points[p].input));
      if (at_p.sign() * at_q.sign() < 0) points.push_back(crossing(plane, p, q));
    }
    return points;
  }

  void trace_facet_plane(const std::vector<PointId>& loop, const std::vector<PointId>& light,
                         const EventElement& element);

  const EventScene& scene_;
  const Shape& receiver_;
  const ReceiverPlane& plane_;
  std::vector<NamedSegment>& segments_;
  bool light_behind_ = false;
};

/// A vector of the plane spanned by a line and the origin of homogeneous coordinates: a place on the line times a
/// weight.
struct PlaceOnLine {
  Rational place;
  Rational weight;
};

Rational cross(const PlaceOnLine& a, const PlaceOnLine& b) {
  return a.place * b.weight - a.weight * b.place;
}

/// True if the place is a sum of non-negative multiples of the generators.
bool is_in_cone(const PlaceOnLine& p, const std::vector<PlaceOnLine>& generators) {
  const auto along = [&](const PlaceOnLine& g) { return Rational(p.place * g.place + p.weight * g.weight) > 0; };
  for (const PlaceOnLine& g : generators) {
    const Rational turn = cross(p, g);
    if (turn == 0 && along(g)) return true;
    // Two generators, one to the left and one to the right, hold the place between them if they turn by less than half.
    for (const PlaceOnLine& h : generators) {
      if (turn > 0 && cross(p, h) < 0 && cross(h, g) > 0) return true;
    }
  }
  return false;
}

/// In the plane of a facet, points from which the light's section is hidden by the facet, seen from its side, are the
/// places of weight 1 in the cone of (k, 1) and (-l, -1), k in the facet and l in the light (theory S6).
void PlaneTraces::trace_facet_plane(const std::vector<PointId>& loop, const std::vector<PointId>& light,
                                    const EventElement& element) {
  const ReceiverPlane facet(scene_.points[loop[0]].input, scene_.points[loop[1]].input, scene_.points[loop[2]].input);
  const auto line = cut_points(facet.plane(), receiver_.corners);
  const auto source = cut_points(facet.plane(), light);
  if (line.size() != 2 || source.empty()) return;
  const FlatPoint p = facet.flat(line[0]), q = facet.flat(line[1]);
  const FlatPoint way{q.x - p.x, q.y - p.y};
  const Rational square = way.x * way.x + way.y * way.y;
  struct Generator {
    Rational off;
    PlaceOnLine place;
  };
  std::vector<Generator> generators;
  const auto add_generator = [&](const FlatPoint& g, int weight) {
    const Rational x = g.x - p.x, y = g.y - p.y;
    generators.push_back({Rational(weight * (way.x * y - way.y * x)),
                          {Rational(weight * (way.x * x + way.y * y) / square), Rational(weight)}});
  };
  for (const PointId k : loop) add_generator(facet.flat(exact(scene_.points[k].input)), 1);
  for (const ExactVector& l : source) add_generator(facet.flat(l), -1);
  std::vector<PlaceOnLine> on_line;
  for (const Generator& g : generators) {
    if (g.off == 0) on_line.push_back(g.place);
    for (const Generator& h : generators) {
      if (!(g.off > 0 && h.off < 0)) continue;
      const Rational s = -h.off;
      on_line.push_back(
          {Rational(s * g.place.place + g.off * h.place.place), Rational(s * g.place.weight + g.off * h.place.weight)});
    }
  }
  std::optional<Rational> first, last;
  const auto keep = [&](const Rational& place) {
    if (!first || place < *first) first = place;
    if (!last || place > *last) last = place;
  };
  for (const int end : {0, 1}) {
    if (is_in_cone({Rational(end), Rational(1)}, on_line)) keep(Rational(end));
  }
  for (const PlaceOnLine& g : on_line) {
    if (g.weight <= 0) continue;
    const Rational place = g.place / g.weight;
    if (place >= 0 && place <= 1) keep(place);
  }
  if (!first || *first == *last) return;
  const ExactVector step = line[1] - line[0];
  add(plane_.flat(line[0] + *first * step), plane_.flat(line[0] + *last * step),
      {EventKind::coplanar_plane, element, element, 1, Extremal::none});
}

}  // namespace

void append_plane_traces(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
                         std::vector<NamedSegment>& segments) {
  PlaneTraces traces(scene, receiver, plane, segments);
  traces.append_contacts();
  traces.append_light_plane();
  traces.append_facet_planes();
}

}  // namespace gnomon::event
