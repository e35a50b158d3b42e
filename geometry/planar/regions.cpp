#include "gnomon/flatland_regions.h"

#include <algorithm>
#include <tuple>

#include "geometry/planar/shadow_side.h"

namespace gnomon::planar {
namespace {

using Sides = std::vector<PieceSide>;
using Corners = std::vector<PieceCorner>;

/// The boundary comes in from infinity along the ray, or goes out along it.
PieceSide inward(const BoundaryRay& ray) {
  return {ray.name, ray.start, ray.anchor};
}
PieceSide outward(const BoundaryRay& ray) {
  return {ray.name, ray.anchor, ray.start};
}

PieceCorner corner(BlockerVertex end) {
  return {end};
}
constexpr PieceCorner meet{std::nullopt};

PieceSide blocker_side(const Pair& pair, BlockerVertex from) {
  return {{SideKind::blocker}, pair.blocker_end(from), pair.blocker_end(other_end(from))};
}

/// The half-plane left of the blocker as it runs from one end to the other.
ConvexPiece half_plane(const Pair& pair, BlockerVertex from) {
  const BlockerVertex to = other_end(from);
  return {Sides{inward(blocker_ray(pair, from)), blocker_side(pair, from), outward(blocker_ray(pair, to))},
          Corners{corner(from), corner(to)}};
}

/// Behind the blocker, between two rays that start at its ends.
ConvexPiece behind_blocker(const Pair& pair, const ShadowSide& side, const std::array<BoundaryRay, 2>& rays) {
  return {Sides{inward(rays[0]), blocker_side(pair, side.first), outward(rays[1])},
          Corners{corner(side.first), corner(side.last)}};
}

/// Between two rays that start at one end of the blocker.
ConvexPiece wedge(const BoundaryRay& in, BlockerVertex apex, const BoundaryRay& out) {
  return {Sides{inward(in), outward(out)}, Corners{corner(apex)}};
}

void add_lit_wedges(const Pair& pair, const ShadowSide& side, std::vector<ConvexPiece>& lit) {
  if (!side.outer[0].on_blocker_line()) lit.push_back(wedge(blocker_ray(pair, side.first), side.first, side.outer[0]));
  if (!side.outer[1].on_blocker_line()) lit.push_back(wedge(side.outer[1], side.last, blocker_ray(pair, side.last)));
}

/// Rays at one end of the blocker have one line only if they have one name: a line is never named in two ways.
bool same_line(const BoundaryRay& outer, const BoundaryRay& inner) {
  return outer.anchor == inner.anchor;
}

/// Umbra and penumbra where the two rays that bound the umbra meet: cut along both of them, behind their meeting point
/// too.
void add_bounded_umbra(const Pair& pair, const ShadowSide& side, ShadowRegions& regions) {
  const auto& [outer_first, outer_last] = side.outer;
  const auto& [inner_first, inner_last] = *side.inner;
  const PieceCorner first = corner(side.first);
  const PieceCorner last = corner(side.last);
  regions.umbra.pieces.push_back(
      {Sides{blocker_side(pair, side.first), outward(inner_last), inward(inner_first)}, Corners{last, meet, first}});
  auto& penumbra = regions.penumbra;
  penumbra.pieces.push_back(
      {Sides{inward(outer_first), outward(inner_first), outward(inner_last)}, Corners{first, meet}});
  penumbra.pieces.push_back({Sides{inward(inner_last), outward(inner_first)}, Corners{meet}});
  penumbra.pieces.push_back({Sides{inward(inner_first), inward(inner_last), outward(outer_last)}, Corners{meet, last}});
  penumbra.components += 1;
}

void add_unbounded_umbra(const Pair& pair, const ShadowSide& side, ShadowRegions& regions) {
  const auto& [outer_first, outer_last] = side.outer;
  const auto& [inner_first, inner_last] = *side.inner;
  regions.umbra.pieces.push_back(behind_blocker(pair, side, *side.inner));
  auto& penumbra = regions.penumbra;
  const std::size_t before = penumbra.pieces.size();
  if (!same_line(outer_first, inner_first)) penumbra.pieces.push_back(wedge(outer_first, side.first, inner_first));
  if (!same_line(outer_last, inner_last)) penumbra.pieces.push_back(wedge(inner_last, side.last, outer_last));
  penumbra.components += static_cast<std::uint32_t>(penumbra.pieces.size() - before);
}

void add_shadow(const Pair& pair, const ShadowSide& side, ShadowRegions& regions) {
  const ConvexPiece occlusion = behind_blocker(pair, side, side.outer);
  regions.occlusion.pieces.push_back(occlusion);
  regions.occlusion.components += 1;
  add_lit_wedges(pair, side, regions.lit.pieces);
  if (!side.inner) {
    regions.penumbra.pieces.push_back(occlusion);
    regions.penumbra.components += 1;
    return;
  }
  regions.umbra.components += 1;
  if (side.umbra_bounded) {
    add_bounded_umbra(pair, side, regions);
  } else {
    add_unbounded_umbra(pair, side, regions);
  }
}

void add_line(const SideName& side, std::vector<ExtremalLine>& lines) {
  if (side.kind != SideKind::separating && side.kind != SideKind::supporting) return;
  const Contact contact = side.kind == SideKind::separating ? Contact::separating : Contact::supporting;
  lines.push_back({contact, side.blocker_end.value(), side.light_end.value()});
}

std::vector<ExtremalLine> bounding_lines(const std::vector<ShadowSide>& sides) {
  std::vector<ExtremalLine> lines;
  for (const ShadowSide& side : sides) {
    for (const BoundaryRay& ray : side.outer) add_line(ray.name, lines);
    if (!side.inner) continue;
    for (const BoundaryRay& ray : *side.inner) add_line(ray.name, lines);
  }
  std::ranges::sort(
      lines, {}, [](const ExtremalLine& line) { return std::tuple(line.contact, line.blocker_end, line.light_end); });
  return lines;
}

/// The lit region of a light on the blocker's line is cut in two by this line if no point of it is lit: if light and
/// blocker have more than an end in common.
std::uint32_t components_off_common_line(const Pair& pair) {
  const CommonLine line = common_line(pair);
  return line.light_min < line.blocker_max && line.light_max > line.blocker_min ? 2 : 1;
}

}  // namespace

std::string_view name(SideKind kind) {
  constexpr std::string_view names[] = {"blocker", "blocker_line", "separating", "supporting", "clip_box"};
  return names[static_cast<int>(kind)];
}

bool PlanarRegion::bounded() const {
  return std::ranges::all_of(pieces, &ConvexPiece::bounded);
}

ShadowRegions shadow_regions(const Pair& pair) {
  const auto sides = shadow_sides(pair);
  ShadowRegions regions{pair, bounding_lines(sides), {}, {}, {}, {}};
  for (const BlockerVertex from : {BlockerVertex{0}, BlockerVertex{1}}) {
    const bool shadowed = std::ranges::any_of(sides, [&](const ShadowSide& side) { return side.first == from; });
    if (!shadowed) regions.lit.pieces.push_back(half_plane(pair, from));
  }
  for (const ShadowSide& side : sides) add_shadow(pair, side, regions);
  // The blocker's line is lit where the light is not on it, and connects what is lit beside it.
  regions.lit.components = sides.empty() ? components_off_common_line(pair) : !regions.lit.empty();
  return regions;
}

}  // namespace gnomon::planar
