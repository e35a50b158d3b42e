#pragma once

/// Builds the silhouettes of a light and of blockers as seen from an apex. Private to this folder.

#include <span>

#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/silhouette.h"

namespace gnomon::viewpoint {

/// What became of a blocker.
enum class Outcome {
  apart,      ///< it hides nothing
  kept,       ///< appended to the silhouettes; it may hide something
  covers,     ///< it hides the whole light
  undecided,  ///< not for this level
};

/// What became of all blockers.
enum class Gathered {
  kept,       ///< all that may hide something are among the silhouettes
  covered,    ///< one hides the whole light
  undecided,  ///< not for this level
};

/// Whether a silhouette that runs along a linear light hides it, or is left to the exact level.
enum class Along { hides, undecided };

/// Appends silhouettes; the first is the light's.
///
/// Candidates beyond those that may hide something change nothing: of a linear light a blocker that would be left
/// undecided, but has no point between apex and light, is apart.
///
/// Of an area light, what only touches hides nothing that counts. A blocker that touches the plane of a linear light
/// and the point may hide a part of it.
class SilhouetteBuilder {
 public:
  /// For an area light, the side that it shows to the apex. Keeps a reference to the plane, as below.
  SilhouetteBuilder(const Point3& apex, const LightSide& light, Silhouettes& silhouettes);

  /// For a linear light: `ends` are its start, its end and a point off the plane through both and the apex, so that
  /// all three span a plane to measure depth by.
  /// Requires: the ends run counterclockwise.
  SilhouetteBuilder(const Point3& apex, std::span<const Point3, 3> ends, const LightPlane& plane,
                    Silhouettes& silhouettes, Along along = Along::hides);

  /// Looks at blockers, and stops at one that covers the light.
  Gathered append_blockers(const BlockerSet::Content& blockers, std::span<const std::uint32_t> candidates);

  /// Looks at a flat blocker's corners.
  Outcome append_flat(std::span<const Point3> corners, std::span<const std::uint32_t> names, std::uint32_t element);

  /// Looks at a solid blocker.
  Outcome append_solid(const ConvexSolid& solid, std::uint32_t element);

 private:
  enum class Extent { area, length };
  enum class Depth { in_front, behind, crossing };
  enum class Beyond { none, part, all };

  void append_rays(std::span<const Point3> corners);
  void reverse_rays();
  void append_planes(std::span<const std::uint32_t> names, bool reversed);
  Outcome from_inside(const ConvexSolid& solid) const;
  bool certainly_outside();
  void make_sides_exact(const Silhouette& silhouette);
  bool certainly_behind_apex() const;
  Depth depth_of(std::span<const Ray> rays) const;
  int append_counterclockwise(std::span<const std::uint32_t> names);
  void append_light(std::span<const FlatPoint> flats, const FlatBox& box);
  Outcome look_at(const BlockerSet::Content& blockers, std::uint32_t blocker);
  bool runs_along_light(std::span<const Ray> rays) const;
  bool hides_edge_on(std::span<const Point3> corners) const;
  Beyond light_beyond(const Point3& a, const Point3& b, const Point3& c) const;
  bool light_beyond_all_shown(const ConvexSolid& solid) const;
  Outcome finished(std::uint32_t element);
  Outcome before_light(const Silhouette& silhouette);
  Outcome dropped();
  bool is_between(const BlockerSet::Content& blockers, std::uint32_t blocker) const;

  Point3 apex_;
  Extent extent_;
  Along along_ = Along::hides;
  std::span<const Point3> light_corners_;
  std::span<const Point3> depth_corners_;  ///< three of the light's plane
  const LightPlane& plane_;
  Silhouettes& silhouettes_;
  std::uint32_t first_ = 0;      ///< of the silhouette being built
  bool sides_are_exact_ = true;  ///< of its rays, at the pyramid
  bool inside_ = false;          ///< all of these are positive
  bool reversed_ = false;        ///< its rays run against the corners' order
};

}  // namespace gnomon::viewpoint
