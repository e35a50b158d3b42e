#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "geometry/visibility/blocker_set.h"
#include "gnomon/light.h"
#include "gnomon/names.h"
#include "gnomon/point.h"
#include "gnomon/visibility.h"

namespace gnomon {

namespace viewpoint {
class OccluderIndex;
struct SearchCounts;
}  // namespace viewpoint

/// An end of a visible stretch of a linear light: one of the light's ends, or where a blocker's edge crosses it as
/// seen.
struct StretchEnd {
  std::optional<std::uint32_t> blocker;  ///< its index in the set; empty at an end of the light
  std::uint32_t edge = 0;                ///< of the polygon as given, or of the solid
  double share = 0;                      ///< of the way from the light's start to its end
  double error = 0;                      ///< |share - exact| is at most this; it may be infinite
};

/// A part of a linear light that is visible.
struct VisibleStretch {
  StretchEnd from;
  StretchEnd to;
};

/// What a point sees of a linear light.
struct VisibleLinearLight {
  Region region = Region::lit;
  double fraction = 0;     ///< visible fraction
  double error_bound = 0;  ///< |fraction - exact| is at most this; 0 outside the penumbra
  /// The stretches of positive length, from the light's start to its end. Valid until the next question.
  std::span<const VisibleStretch> visible;
  double before_receiver = 1;  ///< of a receiver's point, the share of the light before its plane; correctly rounded
};

/// The fast level of visibility for one linear light behind many blockers, in doubles that know their bounds.
///
/// Definition: a point of the light is blocked if the open segment to it meets a blocker.
/// Exactness:  the region and the edges that bound what is visible are exact: a sign that doubles cannot certify is
///             taken in exact arithmetic. Shares and the fraction carry bounds. Where this level does not decide it
///             says so.
/// Cost:       a search for blockers that may hide the light, and one cover for each blocker near the triangle between
/// point and light.
///             Memory is kept for the next question, so one object per thread.
class FastLinearVisibility {
 public:
  FastLinearVisibility(const LinearLight& light, BlockerSet blockers, const LinearSearch& search = {});
  /// The index is the light's.
  FastLinearVisibility(const LinearLight& light, std::shared_ptr<const viewpoint::OccluderIndex> index);
  FastLinearVisibility(FastLinearVisibility&&) noexcept;
  FastLinearVisibility& operator=(FastLinearVisibility&&) noexcept;
  ~FastLinearVisibility();

  /// What the point sees, or nothing if that is left to the exact level: the point lies on the light's line or, with
  /// the light, in the plane of a flat blocker; a blocker holds a part of the light's line or may reach beyond the
  /// light where its plane cuts it; or a coordinate exceeds 1e30.
  ///
  /// Requires: finite coordinates.
  std::optional<VisibleLinearLight> visible_from(const Point3& point);

  /// The same for a point of a receiver: region and fraction of what lies before its plane, after exact_received. The
  /// stretches are all that are visible, also behind the plane.
  ///
  /// Returns: nothing also where a blocker may hold the point, an edge is coplanar with light and point, or doubles do
  ///          not tell whether a stretch reaches before the plane.
  std::optional<VisibleLinearLight> visible_by(const ReceiverPoint& receiver);

  /// The blockers that the search finds for the point, ascending: all that have a point in the triangle between it and
  /// the light, and some others. Nothing for a point on the light's line or coordinates beyond 1e30. Valid until the
  /// next question.
  std::optional<std::span<const std::uint32_t>> occluders(const Point3& point);

  /// What the searches of all questions did.
  const viewpoint::SearchCounts& search_counts() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace gnomon
