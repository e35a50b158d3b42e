#include "geometry/discontinuity/plane_traces.h"

#include <algorithm>

namespace gnomon::event {
namespace {

/// Finds and appends the segments of one receiver.
class PlaneTraces {
 public:
  PlaneTraces(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
              std::vector<NamedSegment>& segments)
      : scene_(scene), receiver_(scene.receivers[receiver]), plane_(plane), segments_(segments) {}

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
      if (s == 0) ends.push_back(flat_corner(p));
      if (s * t < 0) ends.push_back(plane_.flat(crossing(light_plane(), p, q)));
    }
    if (ends.size() != 2) return;
    add(ends[0], ends[1], {EventKind::light_plane, {EventOf::light}, {EventOf::light}, 0, Extremal::none});
  }

 private:
  int side(const EventPoint& p) const {
    const auto& c = receiver_.plane;
    return orientation(scene_.points[c[0]], scene_.points[c[1]], scene_.points[c[2]], p);
  }

  std::vector<ShapeId> shapes_near_plane() const {
    const auto& c = receiver_.corners;
    const auto place = [&](std::size_t k) { return scene_.points[receiver_.plane[k]].input; };
    const Point3 p = place(0), q = place(1), r = place(2);
    std::vector<RoughHalfSpace> region{
        rough_half_space(p, {q.x - p.x, q.y - p.y, q.z - p.z}, {r.x - p.x, r.y - p.y, r.z - p.z})};
    region.push_back(reversed(region[0]));
    // Sides between constructed corners are farther off than half-spaces in doubles tell.
    const bool is_input =
        std::ranges::all_of(c, [&](PointId k) { return scene_.points[k].kind == EventPoint::Kind::input; });
    for (std::size_t k = 0; is_input && k < c.size(); ++k) {
      const Point3 &a = scene_.points[c[k]].input, &b = scene_.points[c[(k + 1) % c.size()]].input;
      region.push_back(
          rough_side(region[0], {b.x - a.x, b.y - a.y, b.z - a.z}, a, scene_.points[c[(k + 2) % c.size()]].input));
    }
    std::vector<ShapeId> found;
    find_boxes(scene_.shape_boxes, region, found);
    std::erase_if(found, [&](ShapeId s) { return EventScene::is_own(receiver_, s); });
    std::sort(found.begin(), found.end());
    return found;
  }

  ExactPlane light_plane() const {
    const auto& l = scene_.light_plane;
    return plane_through(exact(scene_.points[l[0]].input), exact(scene_.points[l[1]].input),
                         exact(scene_.points[l[2]].input));
  }

  ExactVector crossing(const ExactPlane& plane, PointId p, PointId q) const {
    const ExactVector a = exact_place(scene_.points[p]), b = exact_place(scene_.points[q]);
    const Rational at_a = plane.height(a), at_b = plane.height(b);
    return a + Rational(at_a / (at_a - at_b)) * (b - a);
  }

  void add(const FlatPoint& p, const FlatPoint& q, const EventName& name) {
    if (!(p == q)) segments_.push_back({{p, q, 0}, name});
  }

  EventName contact(ShapeId shape, std::uint32_t index) const {
    const EventElement element{EventOf::blocker, EventBody{shape}, EventIndex{index}};
    return {EventKind::contact, element, element, 0, Extremal::none};
  }

  FlatPoint flat_corner(PointId p) const { return plane_.flat(exact_place(scene_.points[p])); }

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

  Sides sides_of(const std::vector<PointId>& corners) const {
    return sides(corners, [&](PointId p) { return side(scene_.points[p]); });
  }

  void append_flat_contact(ShapeId s) {
    const Shape& shape = scene_.shapes[s];
    if (sides_of(shape.corners).positive) add_section(shape.corners, contact(s, 0));
  }

  void append_solid_contact(ShapeId s) {
    const Shape& shape = scene_.shapes[s];
    const Sides corners = sides_of(shape.corners);
    if (corners.cross()) {
      for (std::uint32_t f = 0; f < shape.facets.size(); ++f) add_section(shape.facets[f], contact(s, f));
      return;
    }
    if (!corners.positive) return;
    for (std::uint32_t f = 0; f < shape.facets.size(); ++f) {
      if (sides_of(shape.facets[f]).all_zero()) {
        add_outline(shape.facets[f], contact(s, f));
      } else {
        add_section(shape.facets[f], contact(s, f));  // an edge on which the solid stands
      }
    }
  }

  const EventScene& scene_;
  const Shape& receiver_;
  const ReceiverPlane& plane_;
  std::vector<NamedSegment>& segments_;
};

}  // namespace

void append_plane_traces(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
                         std::vector<NamedSegment>& segments) {
  PlaneTraces traces(scene, receiver, plane, segments);
  traces.append_contacts();
  traces.append_light_plane();
}

}  // namespace gnomon::event
