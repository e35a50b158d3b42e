#pragma once

#include <vector>

#include "geometry/exact_number.h"
#include "geometry/planar/regions.h"
#include "geometry/point.h"

namespace gnomon::planar {

/// A convex polygon with interior.
/// Orientation: counterclockwise; side k runs from vertex k to vertex k + 1 and lies on the line that its name says.
/// Exactness:   vertices are constructed exactly, then each coordinate is rounded once, to the nearest double; two
///              vertices may round to one point. The area is that of the exact polygon.
struct NamedPolygon {
  std::vector<Point2> vertices;
  std::vector<SideName> sides;
  ExactNumber area;
};

/// A region cut by a box: one polygon for every convex piece that has interior there. Polygons share whole sides.
struct RegionInBox {
  std::vector<NamedPolygon> polygons;
  ExactNumber area;
  bool truncated = false;  ///< true if a side of the box bounds it
};

/// An extremal line cut by a box. Orientation: from the light to the blocker. Rounding as in NamedPolygon.
struct LineInBox {
  ExtremalLine name;
  Point2 start;
  Point2 end;
};

/// Everything of one pair that is drawn or written. Lit, penumbra and umbra tile the box.
struct ShadowRegionsInBox {
  RegionInBox lit;
  RegionInBox penumbra;
  RegionInBox umbra;
  RegionInBox occlusion;
  std::vector<LineInBox> lines;  ///< those that reach the inside of the box or run along a side of it
};

/// The regions of a pair, cut exactly by a box.
///
/// Requires: box.min < box.max in both coordinates, all finite.
/// Throws:   PreconditionError.
ShadowRegionsInBox regions_in_box(const ShadowRegions& regions, const Box2& box);

}  // namespace gnomon::planar
