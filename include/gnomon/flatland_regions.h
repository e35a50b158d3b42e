#pragma once

/// @file
/// The plane: the regions of one light and one segment, without end or in a box.
///
///     #include <gnomon/flatland_regions.h>
///     int main() {
///       using namespace gnomon;
///       const Point2 light[] = {{-2, 4}, {2, 4}}, wall[] = {{-1, 2}, {1, 2}};
///       const planar::ShadowRegions regions = planar::shadow_regions(planar::Pair::from_points(light, wall));
///       const auto in_box = planar::regions_in_box(regions, {{-9, -9}, {9, 9}});
///       return regions.umbra.bounded() && in_box.umbra.area.exact == "2" ? 0 : 1;  // a triangle
///     }

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "gnomon/flatland_pair.h"
#include "gnomon/point.h"

namespace gnomon::planar {

/// What a side of a region's piece lies on.
enum class SideKind : std::uint8_t {
  blocker,       ///< the blocker itself
  blocker_line,  ///< the blocker's line, beyond its end `blocker_end`
  separating,    ///< the separating line (`blocker_end`, `light_end`)
  supporting,    ///< the supporting line (`blocker_end`, `light_end`)
  clip_box,      ///< side `box_side` of a box: 0 to 3 for x min, x max, y min, y max
};

/// The name scripts read.
std::string_view name(SideKind kind);

/// The name of a side: its kind and the input elements it goes through, where there are any.
struct SideName {
  SideKind kind = SideKind::blocker;
  std::optional<BlockerVertex> blocker_end = {};
  std::optional<LightVertex> light_end = {};
  std::optional<std::uint32_t> box_side = {};

  friend bool operator==(const SideName&, const SideName&) = default;
};

/// One side of a piece, on the line through two input points.
/// Orientation: directed from `from` to `to`; the piece lies on its left, the line itself included.
struct PieceSide {
  SideName name;
  Point2 from;
  Point2 to;
};

/// A corner of a piece: an end of the blocker or, if there is none, the point where the lines of its two sides meet.
struct PieceCorner {
  std::optional<BlockerVertex> blocker_end;

  friend bool operator==(const PieceCorner&, const PieceCorner&) = default;
};

/// A closed convex piece of the plane with interior, its boundary named by input elements.
///
/// Definition:  the intersection of the closed half-planes to the left of its sides.
/// Orientation: sides and corners run counterclockwise. Of a bounded piece, corner k lies between the sides k and k + 1
///              (cyclically). An unbounded piece has one side more than corners: its boundary arrives from infinity
///              along the first side's direction and leaves along the last one's.
/// Degenerate:  the ends of the blocker are corners wherever a piece has them on its boundary, straight ones included;
///              so pieces that meet share whole sides.
struct ConvexPiece {
  std::vector<PieceSide> sides;
  std::vector<PieceCorner> corners;

  bool bounded() const { return sides.size() == corners.size(); }
};

/// A region: convex pieces that share no interior point, and what is known of it as a whole.
struct PlanarRegion {
  std::vector<ConvexPiece> pieces;
  std::uint32_t components = 0;  ///< of the interior of the set of points that have the region's visible fraction

  bool empty() const { return pieces.empty(); }
  bool bounded() const;  ///< true if all pieces are; so is the empty region
};

/// The regions of one pair. Lit, penumbra and umbra tile the plane; occlusion is penumbra and umbra together.
///
/// Definition: every region is the closure of the interior of its set of points {f = 1}, {0 < f < 1}, {f = 0} and
///             {f < 1}, f being the visible fraction. What has no interior is left out: the shadow that a light on the
///             blocker's line throws along this line, and the blocker's line itself where it is lit and both its sides
///             are not. region_of() knows these.
struct ShadowRegions {
  Pair pair;
  std::vector<ExtremalLine>
      lines;  ///< in standard position the four extremal lines; otherwise those that bound a region
  PlanarRegion lit;
  PlanarRegion penumbra;
  PlanarRegion umbra;
  PlanarRegion occlusion;
};

/// The regions of a pair, in every position.
///
/// Returns:    pieces that lie each on one side of the blocker's line. Where the supporting lines of a pair meet behind
///             the blocker, the penumbra is cut along them.
/// Degenerate: a line through the whole light names the light end of extremal_lines(); outside standard position, the
///             light end that throws the shadow.
/// Exactness:  all decisions are exact; nothing is constructed.
/// After:      [P93] §4.2.2.1, properties 1 to 6.
ShadowRegions shadow_regions(const Pair& pair);

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
