#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "geometry/visibility/blocker_set.h"
#include "geometry/visibility/receiver_front.h"
#include "gnomon/light.h"
#include "gnomon/names.h"
#include "gnomon/point.h"

namespace gnomon {

/// A direction from the point that looks, of any length.
/// Exactness: the vector is off by at most `error` parts of its length; it may be infinite.
struct VisibleDirection {
  double x = 0;
  double y = 0;
  double z = 0;
  double error = 0;
};

/// A piece of the boundary of the visible part of a light, on one edge of the light or of a blocker.
/// Orientation: from `start` to `end` the visible part lies to the left, seen from beyond the light, and so to the
///              right, seen from the point that looks; `normal` is perpendicular to both and points to the visible
///              part's side of the edge.
struct BoundaryPiece {
  std::optional<std::uint32_t> blocker;  ///< its index in the set; empty for an edge of the light
  std::uint32_t edge = 0;                ///< of the polygon as given, or of the solid
  VisibleDirection start;
  VisibleDirection end;
  VisibleDirection normal;
};

/// What a point sees of an area light.
struct VisibleAreaLight {
  Region region = Region::lit;
  double fraction = 0;     ///< visible fraction
  double error_bound = 0;  ///< |fraction - exact| is at most this; 0 outside the penumbra
  /// The boundary of the visible part: the pieces of positive length, in no particular order. Empty unless lit or in
  /// penumbra. Valid until the next question.
  std::span<const BoundaryPiece> boundary;
  VisibleDirection forward;    ///< perpendicular to the light, to its side of the point
  double before_receiver = 1;  ///< of a receiver's point, the share of the light before its plane; correctly rounded
};

/// The fast level of visibility: what points see of one area light behind many blockers, in doubles that know their
/// bounds.
///
/// Definition: a point of the light is blocked if the open segment to it meets a blocker.
/// Exactness:  region and boundary are exact: a sign that doubles cannot certify is taken in exact arithmetic. The
///             fraction carries a bound. Where this level does not decide it says so.
/// Cost:       a search in the hierarchy, and for each edge near the pyramid between point and light those blockers
///             that overlap it as seen; nothing is split. Memory is kept for the next question, so one object per
///             thread.
class FastVisibility {
 public:
  /// Requires: nothing; a light that is not exactly flat is never decided.
  FastVisibility(const AreaLight& light, BlockerSet blockers);
  FastVisibility(FastVisibility&&) noexcept;
  FastVisibility& operator=(FastVisibility&&) noexcept;
  ~FastVisibility();

  /// What the point sees, or nothing if that is left to the exact level: the light is not flat, the point lies on a
  /// solid that hides a part of it, a blocker that crosses the light's plane and whose own plane cuts the light may
  /// hide some of it, or a coordinate exceeds 1e30.
  ///
  /// Requires: finite coordinates.
  std::optional<VisibleAreaLight> visible_from(const Point3& point);

  /// The same for a point of a receiver: region and fraction of what lies before its plane, after exact_received. The
  /// boundary is that of all that is visible, also behind the plane.
  ///
  /// Returns: nothing also where a blocker may hold the point, or doubles do not tell on which side of the plane the
  ///          boundary's corners are.
  std::optional<VisibleAreaLight> visible_by(const ReceiverPoint& receiver);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace gnomon
