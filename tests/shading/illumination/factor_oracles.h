#pragma once

/// Slow ways to view factors that share nothing with the library's, and rooms.

#include <utility>
#include <vector>

#include "gnomon/view_factors.h"

namespace gnomon::factors {

enum class Facing { up, down };
ConvexPolygon rectangle_at(double x0, double y0, double x1, double y1, double z, Facing facing);

/// From a corner along two ways, counterclockwise in that order.
ConvexPolygon parallelogram(const Point3& corner, const Point3& first, const Point3& second);

/// The polygon or its reverse, so that its front looks up or down an axis.
ConvexPolygon turned_to(const ConvexPolygon& polygon, int axis, bool up);

/// A_1 F_12 of two triangles that see each other wholly, by the definition: cos cos / (pi r²) over both areas, with
/// Gauss's rule of 14 nodes four times.
double double_area_integral(const ConvexPolygon& first, const ConvexPolygon& second);

/// The factor from the unit square at height 0 to that at height 1 behind a rectangle between them, by Gauss's rule in
/// 64-bit precision on the faces between all lines at which what is seen changes its formula.
double behind_rectangle(double x0, double x1, double y0, double y1, double z);

/// The walls of the unit cube, each in n times n squares, from inside.
std::vector<ViewSurface> cube_walls(int n);

/// A box with its facets from outside.
void add_box(std::vector<ViewSurface>& surfaces, std::vector<ConvexBlocker>& blockers, const Point3& low,
             const Point3& high);

/// [0, 2] x [0, 2] without [1, 2] x [1, 2], 1 high: its walls from inside, floor and ceiling of two pieces each, and
/// the two walls at the inner corner as blockers.
std::pair<std::vector<ViewSurface>, std::vector<ConvexBlocker>> l_shaped_room();

}  // namespace gnomon::factors
