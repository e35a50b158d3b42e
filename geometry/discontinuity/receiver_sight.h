#pragma once

/// What the points of receivers see of the light. Private to this folder.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/discontinuity/region_change.h"
#include "geometry/visibility/hidden_set.h"
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
  std::function<std::vector<FacePiece>()> pieces;  ///< cuts it up
  /// Whether a shape hides all of the light from all of the face; nothing where it is not known.
  std::function<std::optional<bool>(ShapeId)> is_hidden_by;
};

/// Answers for one receiver.
///
/// Definition: of a point on the receiver the limit from its front is meant.
/// Exactness:  rational arithmetic.
class ReceiverSight {
 public:
  ReceiverSight(const EventScene& scene, const Light& light, std::span<const ConvexBlocker> blockers,
                std::uint32_t receiver, const ReceiverPlane& plane)
      : scene_(scene), light_(light), blockers_(blockers), receiver_(scene.receivers[receiver]), plane_(plane) {}

  /// What a point sees.
  VisiblePart visible_from(const ExactVector& p);

  /// The region of a face.
  ///
  /// Definition: it is certain if the same is seen from each of its points up to triple-edge events, and one of these
  ///             holds: region lit or unlit; a vertex of the light or a blocker is seen; one blocker hides all of the
  ///             light from all of the face; region_may_change denies it; some point of the light is seen from all of
  ///             the face, or one from all of each of a few triangles of it.
  FaceRegion region_of_face(const FaceOfReceiver& face);

 private:
  void collect_near(const ExactVector& p);
  void collect_in_shaft(std::span<const ExactVector> face);
  std::vector<HidingCondition> hiding(ShapeId shape, const ExactVector& p) const;
  bool shows_vertex(const VisiblePart& part, const ExactVector& p) const;
  std::vector<std::vector<HidingCondition>> hiding_of_near(const ExactVector& p) const;
  bool hides_light_from(ShapeId shape, std::span<const ExactVector> face) const;
  bool is_hidden_by_one(const FaceOfReceiver& face, std::span<const std::vector<HidingCondition>> hidden) const;
  bool leaves_open(ShapeId shape, const ExactVector& light_point, std::span<const ExactVector> face) const;
  bool shows_one_point(const VisiblePart& part, std::span<const ExactVector> face) const;
  bool shows_light_to_all(std::vector<FacePiece> pieces);

  const EventScene& scene_;
  const Light& light_;
  std::span<const ConvexBlocker> blockers_;
  const Shape& receiver_;
  const ReceiverPlane& plane_;
  std::vector<std::uint32_t> near_;
};

}  // namespace gnomon::event
