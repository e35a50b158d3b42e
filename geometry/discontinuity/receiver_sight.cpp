#include "geometry/discontinuity/receiver_sight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/discontinuity/shaft.h"
#include "geometry/rounding.h"

namespace gnomon::event {
namespace {

ExactVector exact_point(const EventPoint& p) {
  return exact(p.input);
}

/// True if the conditions hide the closure around a point: no condition speaks against it strictly.
bool hides_closed(const std::vector<HidingCondition>& conditions, const ExactVector& p) {
  return !conditions.empty() && std::none_of(conditions.begin(), conditions.end(),
                                             [&](const HidingCondition& c) { return c.plane.height(p) > 0; });
}

bool is_on_sightline(const ExactVector& p, const ExactVector& between, const ExactVector& far) {
  const ExactVector a = between - p, b = far - p;
  return is_zero(cross(a, b)) && dot(a, b) > 0 && dot(a, a) < dot(b, b);
}

}  // namespace

void ReceiverSight::collect_near(const ExactVector& p) {
  collect_in_shaft({&p, 1});
}

void ReceiverSight::collect_in_shaft(std::span<const ExactVector> face) {
  std::vector<Point3> points;
  for (const ExactVector& p : face) points.push_back({nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)});
  scene_.shape_boxes.search(shaft(scene_, points), near_);
  std::sort(near_.begin(), near_.end());
}

std::vector<HidingCondition> ReceiverSight::hiding(ShapeId s, const ExactVector& p) const {
  const Shape& shape = scene_.shapes[s];
  const auto height = [&](PointId q) { return plane_.plane().height(exact_point(scene_.points[q])); };
  const bool is_coplanar = !shape.is_solid && std::all_of(shape.corners.begin(), shape.corners.end(),
                                                          [&](PointId q) { return height(q) == 0; });
  if (!is_coplanar) return hiding_conditions(blockers_[s], p);
  // In front of a flat blocker on the receiver all is hidden that lies behind.
  const FlatPoint q = plane_.flat(p);
  int sides[2] = {0, 0};
  for (std::size_t k = 0; k < shape.corners.size(); ++k) {
    const FlatPoint a = plane_.flat(exact_point(scene_.points[shape.corners[k]]));
    const FlatPoint b = plane_.flat(exact_point(scene_.points[shape.corners[(k + 1) % shape.corners.size()]]));
    const Rational turn = (b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x);
    ++sides[turn > 0 ? 0 : 1];
  }
  if (sides[0] == 0 || sides[1] == 0) return {{plane_.plane(), HidingCondition::Boundary::excluded}};
  // What nothing fulfils.
  return {{{{}, Rational(1)}, HidingCondition::Boundary::excluded}};
}

std::vector<std::vector<HidingCondition>> ReceiverSight::hiding_of_near(const ExactVector& p) const {
  std::vector<std::vector<HidingCondition>> hidden;
  for (const ShapeId s : near_) hidden.push_back(hiding(s, p));
  return hidden;
}

VisiblePart ReceiverSight::visible_from(const ExactVector& p) {
  collect_near(p);
  return visible_part(light_, hiding_of_near(p), p);
}

/// Of the shapes near those that hide every vertex of the light, from what each of them hides.
std::vector<ShapeId> ReceiverSight::covers(std::span<const std::vector<HidingCondition>> hidden) const {
  std::vector<ShapeId> found;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (std::all_of(scene_.light_vertices.begin(), scene_.light_vertices.end(), [&](const LightVertex& v) {
          return hides_closed(hidden[i], exact_point(scene_.points[v.point]));
        })) {
      found.push_back(near_[i]);
    }
  }
  return found;
}

/// A vertex of the light, or of a blocker in front of it, on the boundary of what is seen.
bool ReceiverSight::shows_vertex(const VisiblePart& part, const ExactVector& p) const {
  for (const VisiblePart::Interval& interval : part.intervals) {
    if (interval[0] == 0 || interval[1] == 1) return true;
  }
  for (const SeenFacet& seen : part.facets) {
    for (const ExactPolygon& piece : seen.visible) {
      for (const ExactVector& q : piece) {
        if (std::find(seen.facet.begin(), seen.facet.end(), q) != seen.facet.end()) return true;
      }
    }
  }
  for (const ShapeId s : near_) {
    for (const PointId corner : scene_.shapes[s].corners) {
      const ExactVector v = exact_point(scene_.points[corner]);
      for (const SeenFacet& seen : part.facets) {
        for (const ExactPolygon& piece : seen.visible) {
          if (std::any_of(piece.begin(), piece.end(), [&](const ExactVector& q) { return is_on_sightline(p, v, q); })) {
            return true;
          }
        }
      }
    }
  }
  return false;
}

/// One blocker hides every vertex of the light from every vertex of the face, so all of it from all of the face.
bool ReceiverSight::is_hidden_by_one(std::span<const ShapeId> shapes, std::span<const ExactVector> face) const {
  return std::any_of(shapes.begin(), shapes.end(), [&](ShapeId s) {
    return std::all_of(scene_.light_vertices.begin(), scene_.light_vertices.end(), [&](const LightVertex& v) {
      const auto hidden = hiding_conditions(blockers_[s], exact_point(scene_.points[v.point]));
      return std::all_of(face.begin(), face.end(), [&](const ExactVector& p) { return hides_closed(hidden, p); });
    });
  });
}

FaceRegion ReceiverSight::region_of_face(const ExactVector& inside, std::span<const ExactVector> vertices,
                                         const std::function<std::vector<FacePiece>()>& pieces) {
  collect_near(inside);
  const auto hidden = hiding_of_near(inside);
  const VisiblePart part = visible_part(light_, hidden, inside);
  const bool may_change = part.region == Region::penumbra || part.region == Region::umbra;
  if (!may_change || scene_.kind == LightKind::point || scene_.kind == LightKind::direction) return {part.region, true};
  if (part.region == Region::penumbra && shows_vertex(part, inside)) return {part.region, true};
  if (part.region == Region::umbra && is_hidden_by_one(covers(hidden), vertices)) return {part.region, true};
  collect_in_shaft(vertices);
  return {part.region, !region_may_change(scene_, near_, pieces())};
}

}  // namespace gnomon::event
