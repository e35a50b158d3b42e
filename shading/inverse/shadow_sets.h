#pragma once

#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// Whose names planes get.
struct GoalPart {
  std::uint32_t goal;
  std::uint32_t part;
};

/// Whether grazing counts: hidden for points, of no measure for what has a size.
enum class Grazing { hides, counts_not };

/// The positions of points from which all, or some, of a subject is hidden by a blocker; nothing if there are none.
struct SubjectShadow {
  std::optional<ConvexSet> umbra;
  std::optional<ConvexSet> occlusion;
};

/// Throws: DesignError for a polygon that is not flat beside a blocker that stands across its plane.
SubjectShadow subject_shadow(DesignSpace& space, const DesignSubject& subject, const ConvexBlocker& blocker,
                             const GoalPart& names);

/// The convex hull of points and directions as a set whose planes are named by goal and part alone; nothing if it is
/// flat.
std::optional<ConvexSet> hull_set(DesignSpace& space, const std::vector<Whole>& generators, const GoalPart& names,
                                  bool is_closed);

/// The same for a hull that lies in one plane; nothing if it lies in a line.
std::optional<ConvexSet> flat_hull_set(DesignSpace& space, std::vector<Whole> generators, const GoalPart& names);

/// The positions from which a mirrored eye sees a flat subject before it.
ConvexSet mirror_set(DesignSpace& space, const DesignSubject& subject, const Point3& eye, std::uint32_t goal);

}  // namespace gnomon::inverse
