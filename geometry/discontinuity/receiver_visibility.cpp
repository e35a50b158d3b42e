#include "geometry/discontinuity/receiver_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/discontinuity/passage.h"
#include "geometry/discontinuity/shaft.h"
#include "geometry/numbers/rounding.h"

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

ExactVector mean(std::span<const ExactVector> points) {
  ExactVector sum;
  for (const ExactVector& p : points) sum = sum + p;
  return Rational(1, points.size()) * sum;
}

/// A point in the middle of every part of the light that is seen.
std::vector<ExactVector> middles(const VisiblePart& part, const Light& light) {
  std::vector<ExactVector> found;
  for (const VisibleFacet& seen : part.facets) {
    for (const ExactPolygon& piece : seen.visible) found.push_back(mean(piece));
  }
  if (const auto* linear = std::get_if<LinearLight>(&light)) {
    const ExactVector start = exact(linear->start), way = exact(linear->end) - start;
    for (const auto& [from, to] : part.intervals) found.push_back(start + Rational((from + to) / 2) * way);
  }
  return found;
}

Place nearby(const ExactVector& p) {
  const CGAL::Protect_FPU_rounding<true> upward;
  return Place(p);
}

std::optional<bool> is_known_to_pass(const EventScene& scene, const Shape& shape, const Place& light,
                                     std::span<const Place> face) {
  const CGAL::Protect_FPU_rounding<true> upward;
  return certainly_passes(scene, shape, light, face);
}

bool is_on_sightline(const ExactVector& p, const ExactVector& between, const ExactVector& far) {
  const ExactVector a = between - p, b = far - p;
  return is_zero(cross(a, b)) && dot(a, b) > 0 && dot(a, a) < dot(b, b);
}

}  // namespace

ReceiverVisibility::ReceiverVisibility(const EventScene& scene, const Light& light,
                                       std::span<const ConvexBlocker> blockers, std::uint32_t receiver,
                                       const ReceiverPlane& plane)
    : scene_(scene),
      receiver_(scene.receivers[receiver]),
      light_(light),
      blockers_(blockers),
      plane_(plane),
      known_(scene.shapes.size(), 0),
      cones_(scene, plane) {
  const CGAL::Protect_FPU_rounding<true> upward;
  before_ = light_before(scene, scene.receivers[receiver], plane);
}

void ReceiverVisibility::collect_near(const ExactVector& p) {
  collect_in_shaft({&p, 1});
}

void ReceiverVisibility::collect_in_shaft(std::span<const ExactVector> face) {
  std::vector<Point3> points;
  for (const ExactVector& p : face) points.push_back({nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)});
  find_boxes(scene_.shape_boxes, shaft(scene_, points), near_);
  std::erase_if(near_, [&](ShapeId s) { return !may_hide(s); });
  std::sort(near_.begin(), near_.end());
}

std::vector<std::vector<HidingCondition>> ReceiverVisibility::hiding_of_near(const ExactVector& p) const {
  std::vector<std::vector<HidingCondition>> hidden;
  for (const ShapeId s : near_) hidden.push_back(hiding_conditions(blockers_[s], p));
  return hidden;
}

VisiblePart ReceiverVisibility::visible_from(const ExactVector& p) {
  collect_near(p);
  return visible_part_of(hiding_of_near(p), p);
}

VisibleFraction ReceiverVisibility::visible_fraction_from(const ExactVector& p) {
  VisiblePart part = quickly_visible_from(p);
  // Of a light that is seen as far as it lies before the plane the measure is not all there is.
  if (part.region == Region::lit && !before_.is_whole()) part.region = Region::penumbra;
  return visible_fraction(part);
}

/// Nothing that lies in or behind the receiver's plane hides light from it.
bool ReceiverVisibility::may_hide(ShapeId shape) {
  if (known_[shape] == 0) {
    const auto& corners = scene_.shapes[shape].corners;
    const bool is_before = std::any_of(corners.begin(), corners.end(), [&](PointId q) {
      return plane_.plane().height(exact_point(scene_.points[q])) > 0;
    });
    known_[shape] = is_before && !EventScene::is_own(receiver_, shape) ? 1 : 2;
  }
  return known_[shape] == 1;
}

/// The plane takes away what lies in or behind it as a blocker would; what is left are the regions of L+.
VisiblePart ReceiverVisibility::visible_part_of(std::span<const std::vector<HidingCondition>> hidden,
                                                const ExactVector& p) const {
  if (before_.is_empty()) return {Region::unlit, {}, {}};
  if (before_.is_whole()) return visible_part(light_, hidden, p);
  std::vector<std::vector<HidingCondition>> all{{{plane_.plane(), HidingCondition::Boundary::belongs}}};
  const VisiblePart received = visible_part(light_, all, p);
  all.insert(all.end(), hidden.begin(), hidden.end());
  VisiblePart part = visible_part(light_, all, p);
  if (part.region != Region::penumbra) return part;
  const auto is_same = [](const VisibleFacet& a, const VisibleFacet& b) { return a.visible == b.visible; };
  const bool is_all = part.intervals == received.intervals &&
                      std::equal(part.facets.begin(), part.facets.end(), received.facets.begin(), is_same);
  if (is_all) part.region = Region::lit;
  return part;
}

/// A vertex of L+, or of a blocker in front of it, on the boundary of what is seen.
bool ReceiverVisibility::shows_vertex(const VisiblePart& part, const ExactVector& p) const {
  const auto is_corner = [&](const ExactVector& q) {
    return std::any_of(before_.corners.begin(), before_.corners.end(), [&](const auto& c) { return c.point == q; });
  };
  if (const auto* linear = std::get_if<LinearLight>(&light_)) {
    const ExactVector start = exact(linear->start), way = exact(linear->end) - start;
    for (const auto& [from, to] : part.intervals) {
      if (is_corner(start + from * way) || is_corner(start + to * way)) return true;
    }
  }
  for (const VisibleFacet& seen : part.facets) {
    for (const ExactPolygon& piece : seen.visible) {
      if (std::any_of(piece.begin(), piece.end(), is_corner)) return true;
    }
  }
  for (const ShapeId s : near_) {
    for (const PointId corner : scene_.shapes[s].corners) {
      const ExactVector v = exact_point(scene_.points[corner]);
      for (const VisibleFacet& seen : part.facets) {
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

/// A blocker hides every vertex of the light from every vertex of the face, so all of it from all of the face.
bool ReceiverVisibility::hides_light_from(ShapeId shape, std::span<const ExactVector> face) const {
  return std::all_of(before_.corners.begin(), before_.corners.end(), [&](const auto& corner) {
    const auto hidden = hiding_conditions(blockers_[shape], corner.point);
    return std::all_of(face.begin(), face.end(), [&](const ExactVector& p) { return hides_closed(hidden, p); });
  });
}

/// One shape hides all of the light from all of the face.
bool ReceiverVisibility::is_hidden_by_one(const FaceOfReceiver& face) const {
  return std::any_of(near_.begin(), near_.end(), [&](ShapeId s) {
    if (const std::optional<bool> known = face.is_hidden_by(s)) return *known;
    const auto hidden = hiding_conditions(blockers_[s], face.inside);
    return std::all_of(before_.corners.begin(), before_.corners.end(),
                       [&](const auto& corner) { return hides_closed(hidden, corner.point); }) &&
           hides_light_from(s, face.vertices);
  });
}

/// The shape hides a point of the light from no point inside the face: a plane through it parts them.
bool ReceiverVisibility::leaves_open(ShapeId shape, const ExactVector& light_point,
                                     std::span<const ExactVector> face) const {
  const auto hidden = hiding_conditions(blockers_[shape], light_point);
  return std::any_of(hidden.begin(), hidden.end(), [&](const HidingCondition& c) {
    bool touches_only = true;
    for (const ExactVector& p : face) {
      const int side = c.plane.height(p).sign();
      if (side < 0) return false;
      touches_only = touches_only && side == 0;
    }
    // Where the receiver lies in the plane the limit from its front counts.
    return !touches_only || c.plane.slope(plane_.plane().normal) > 0;
  });
}

/// A point of the light, among some in the middle of what is seen from somewhere in the face, is seen from all of it.
bool ReceiverVisibility::shows_one_point(const VisiblePart& part, std::span<const ExactVector> face) const {
  std::vector<Place> places;
  for (const ExactVector& p : face) places.push_back(nearby(p));
  const std::vector<ExactVector> candidates = middles(part, light_);
  return std::any_of(candidates.begin(), candidates.end(), [&](const ExactVector& q) {
    const Place light = nearby(q);
    const auto passes = [&](ShapeId s) {
      const std::optional<bool> known = is_known_to_pass(scene_, scene_.shapes[s], light, places);
      return known ? *known : leaves_open(s, q, face);
    };
    return plane_.plane().height(q) > 0 && std::all_of(near_.begin(), near_.end(), passes);
  });
}

/// The same as visible_from, but for how the part is cut up.
VisiblePart ReceiverVisibility::quickly_visible_from(const ExactVector& p) {
  collect_near(p);
  if (!before_.is_empty() && cones_.view(p, near_)) return cones_.part(std::get<AreaLight>(light_));
  return visible_part_of(hiding_of_near(p), p);
}

/// Some light is seen from all of the face, or none, and it is known which.
bool ReceiverVisibility::is_same_throughout(const VisiblePart& part, const FaceOfReceiver& face) {
  if (part.region == Region::umbra && is_hidden_by_one(face)) return true;
  if (part.region == Region::penumbra && shows_vertex(part, face.inside)) return true;
  collect_in_shaft(face.vertices);
  return part.region == Region::penumbra && shows_one_point(part, face.vertices);
}

FaceRegion ReceiverVisibility::region_of_face(const FaceOfReceiver& face) {
  if (before_.is_empty()) return {Region::unlit, true};
  collect_near(face.inside);
  const bool has_cones = cones_.view(face.inside, near_);
  if (has_cones && cones_.region() == Region::lit) return {Region::lit, true};
  if (has_cones && cones_.region() == Region::penumbra && cones_.shows_vertex()) return {Region::penumbra, true};
  const VisiblePart part =
      has_cones ? cones_.part(std::get<AreaLight>(light_)) : visible_part_of(hiding_of_near(face.inside), face.inside);
  const bool may_change = part.region == Region::penumbra || part.region == Region::umbra;
  if (!may_change || scene_.kind == LightKind::point || scene_.kind == LightKind::direction) return {part.region, true};
  return {part.region, is_same_throughout(part, face)};
}

}  // namespace gnomon::event
