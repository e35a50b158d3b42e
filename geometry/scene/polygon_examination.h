#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/scene/polygon_refusal.h"
#include "geometry/scene/polygon_rings.h"

namespace gnomon {

/// What rings of vertices are.
struct PolygonExamination {
  std::optional<PolygonRefusal> refusal;  ///< nothing if they bound a polygon
  bool has_area = true;                   ///< false only with a refusal: nothing is left between the edges
  std::vector<Ring> rings;                ///< the outer ring, then its holes, without seams and spikes
  bool is_convex = false;                 ///< the outer ring, seen along the dominant axis
  PolygonPlane plane{0};
};

/// Looks at a ring of vertices, with seams to holes or without, and at the rings of holes beside it.
///
/// Requires:  rings without equal neighbours.
/// Exactness: signs of determinants of input points, seen along the dominant axis; limits as Flatness says.
PolygonExamination examined_polygon(std::span<const Point3> points, const Ring& boundary,
                                    const std::vector<Ring>& holes = {});

}  // namespace gnomon
