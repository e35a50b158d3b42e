#pragma once

/// What the points of receivers see of the light. Private to this folder.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/discontinuity/closing_arcs.h"
#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/light_before.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/discontinuity/visible_cones.h"
#include "geometry/visibility/hidden_set.h"
#include "geometry/visibility/visible_fraction.h"
#include "geometry/visibility/visible_part.h"

namespace gnomon::event {

/// The region of a face, and whether it is known to be that of all its points.
struct FaceRegion {
  Region region = Region::lit;
  bool is_certain = true;
};

/// A face that no traced event crosses.
struct FaceOfReceiver {
  ExactVector inside;  ///< a point inside
  std::vector<ExactVector> vertices;
  /// Whether a shape hides all of the light from all of the face; nothing where it is not known.
  std::function<std::optional<bool>(ShapeId)> is_hidden_by;
};

/// Answers for one receiver.
///
/// Definition: of a point p on the receiver the limit from its front is meant, p + e N for e > 0 that vanishes, and of
///             the light only L+, what lies strictly before the receiver's plane. Unlit if L+ is empty; lit if no
///             blocker hides any of it, by measure; umbra if all of it is hidden. Segments to L+ run strictly before
///             the plane but for p itself; so blockers without a point there are left out, and of others, if p does not
///             lie on their outline in the plane, the limit is what the definition says of p: next to a facet on which
///             p lies, the solid is met at once or never.
/// Exactness:  exact: planes by name where VisibleCones is for it, else rational arithmetic.
class ReceiverVisibility {
 public:
  ReceiverVisibility(const EventScene& scene, const Light& light, std::span<const ConvexBlocker> blockers,
                     std::uint32_t receiver, const ReceiverPlane& plane);

  /// What a point sees of L+. The facet of an area light is all of it, intervals are shares of all of a linear one.
  VisiblePart visible_from(const ExactVector& p);

  /// The measure of what a point sees of L+ as a share of that of all of the light.
  VisibleFraction visible_fraction_from(const ExactVector& p);

  /// The region of a face.
  ///
  /// Definition: it is certain if the same is seen from each of its points up to triple-edge events, and one of these
  ///             holds: region lit or unlit; a vertex of the light or a blocker is seen; one blocker hides all of the
  ///             light from all of the face; some point of the light is seen from all of the face. Of others closing
  ///             arcs tell.
  FaceRegion region_of_face(const FaceOfReceiver& face);

  /// The region of a point that lies on no arc.
  Region region_of(const ExactVector& p) { return quickly_visible_from(p).region; }

  /// The blockers that may hide something from a face.
  std::span<const ShapeId> blockers_near(std::span<const ExactVector> face) {
    collect_in_shaft(face);
    return near_;
  }

 private:
  void collect_near(const ExactVector& p);
  void collect_in_shaft(std::span<const ExactVector> face);
  bool may_hide(ShapeId shape);
  VisiblePart visible_part_of(std::span<const std::vector<HidingCondition>> hidden, const ExactVector& p) const;
  bool shows_vertex(const VisiblePart& part, const ExactVector& p) const;
  std::vector<std::vector<HidingCondition>> hiding_of_near(const ExactVector& p) const;
  bool hides_light_from(ShapeId shape, std::span<const ExactVector> face) const;
  bool is_hidden_by_one(const FaceOfReceiver& face) const;
  VisiblePart quickly_visible_from(const ExactVector& p);
  bool is_same_throughout(const VisiblePart& part, const FaceOfReceiver& face);
  bool leaves_open(ShapeId shape, const ExactVector& light_point, std::span<const ExactVector> face) const;
  bool shows_one_point(const VisiblePart& part, std::span<const ExactVector> face) const;

  const EventScene& scene_;
  const Shape& receiver_;
  const Light& light_;
  std::span<const ConvexBlocker> blockers_;
  const ReceiverPlane& plane_;
  LightBefore before_;
  std::vector<std::int8_t> known_;  ///< of each shape: 0 not yet, 1 may hide something, 2 hides nothing
  std::vector<std::uint32_t> near_;
  VisibleCones cones_;
};

}  // namespace gnomon::event
