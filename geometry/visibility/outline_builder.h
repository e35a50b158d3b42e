#pragma once

/// Builds the outlines of a light and of blockers as seen from an apex. Private to this folder.

#include <span>

#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/outline.h"

namespace gnomon::sight {

/// What became of a blocker.
enum class Seen {
  apart,      ///< it hides nothing
  outlined,   ///< appended to the outlines; it may hide something
  covers,     ///< it hides the whole light
  undecided,  ///< not for this level
};

/// Appends outlines; the first is the light's.
class OutlineBuilder {
 public:
  /// Requires: the apex in front of the corners' plane: they run clockwise, seen from it, if `reversed`.
  OutlineBuilder(const Point3& apex, std::span<const Point3> light_corners, std::span<const std::uint32_t> names,
                 bool reversed, const LightPlane& plane, Outlines& outlines);

  /// Looks at a flat blocker's corners.
  Seen append_flat(std::span<const Point3> corners, std::span<const std::uint32_t> names, std::uint32_t element);

  /// Looks at a solid blocker.
  Seen append_solid(const ConvexSolid& solid, std::uint32_t element);

 private:
  enum class Depth { in_front, behind, crossing };
  enum class Beyond { none, part, all };

  void append_rays(std::span<const Point3> corners, bool reversed);
  void append_planes(std::span<const std::uint32_t> names, bool reversed);
  Seen append_silhouette(std::span<const Point3* const> loop, std::span<const std::uint32_t> names,
                         std::uint32_t element);
  Seen seen_from_inside(const ConvexSolid& solid) const;
  bool certainly_outside() const;
  bool certainly_behind_apex() const;
  Depth depth_of_rays() const;
  Beyond light_beyond(const Point3& a, const Point3& b, const Point3& c) const;
  bool light_beyond_all_shown(const ConvexSolid& solid) const;
  Seen finished(std::uint32_t element);
  Seen dropped();
  FlatBox point_box(const Ray& ray, bool& ahead) const;

  Point3 apex_;
  std::span<const Point3> light_corners_;
  LightPlane plane_;
  Outlines& outlines_;
  std::uint32_t first_ = 0;  ///< of the outline being built
};

}  // namespace gnomon::sight
