#include "gnomon/flatland_regions.h"

#include <algorithm>
#include <cmath>

#include "geometry/bodies/boxes.h"
#include "geometry/numbers/rounding.h"
#include "geometry/planar/exact_polygon.h"
#include "gnomon/errors.h"

namespace gnomon::planar {
namespace {

Point2 rounded(const ExactPoint& p) {
  return {nearest_double(p.x), nearest_double(p.y)};
}

RegionInBox region_in_box(const Pair& pair, const PlanarRegion& region, const Box2& box) {
  RegionInBox result;
  Rational twice = 0;
  for (const ConvexPiece& piece : region.pieces) {
    ExactPolygon polygon = clipped(pair, piece, box);
    if (polygon.vertices.empty()) continue;
    const Rational twice_piece = twice_area(polygon);
    twice += twice_piece;
    NamedPolygon named{{}, std::move(polygon.sides), exact_number(twice_piece / 2)};
    std::ranges::transform(polygon.vertices, std::back_inserter(named.vertices), rounded);
    result.truncated = result.truncated || std::ranges::any_of(named.sides, [](const SideName& side) {
                         return side.kind == SideKind::clip_box;
                       });
    result.polygons.push_back(std::move(named));
  }
  result.area = exact_number(twice / 2);
  return result;
}

std::vector<LineInBox> lines_in_box(const ShadowRegions& regions, const Box2& box) {
  std::vector<LineInBox> lines;
  for (const ExtremalLine& line : regions.lines) {
    const auto ends =
        clipped_line(regions.pair.light_end(line.light_end), regions.pair.blocker_end(line.blocker_end), box);
    if (ends) lines.push_back({line, rounded((*ends)[0]), rounded((*ends)[1])});
  }
  return lines;
}

}  // namespace

ShadowRegionsInBox regions_in_box(const ShadowRegions& regions, const Box2& box) {
  if (!has_interior(box)) throw PreconditionError("a box needs finite coordinates and an interior");
  const auto cut = [&](const PlanarRegion& region) { return region_in_box(regions.pair, region, box); };
  return {cut(regions.lit), cut(regions.penumbra), cut(regions.umbra), cut(regions.occlusion),
          lines_in_box(regions, box)};
}

}  // namespace gnomon::planar
