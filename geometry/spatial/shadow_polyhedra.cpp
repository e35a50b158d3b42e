#include "geometry/spatial/shadow_polyhedra.h"

#include <utility>

namespace gnomon {

ShadowPlanes::ShadowPlanes(const PairHalfSpaces& half_spaces, const HalfSpace& downward) : space(downward) {
  const auto is_first = [&](const HalfSpace& half_space) {
    return half_space.name.kind == FacetKind::blocker_face && half_space.name == downward.name;
  };
  occlusion.reserve(half_spaces.occlusion.size());
  for (const HalfSpace& half_space : half_spaces.occlusion) {
    occlusion.push_back(is_first(half_space) ? ExactSpace::downward : space.add_plane(half_space));
  }
  umbra.reserve(half_spaces.umbra.size());
  for (std::size_t i = 0; i < half_spaces.umbra.size(); ++i) {
    const std::uint32_t same = half_spaces.shared[i];
    if (same != PairHalfSpaces::none) {
      umbra.push_back(occlusion[same]);
    } else {
      umbra.push_back(is_first(half_spaces.umbra[i]) ? ExactSpace::downward : space.add_plane(half_spaces.umbra[i]));
    }
  }
}

std::array<PlaneId, 6> add_box(ExactSpace& space, const Box3& box) {
  std::array<PlaneId, 6> sides;
  for (int side = 0; side < 6; ++side) sides[static_cast<std::size_t>(side)] = space.add_box_side(box, side);
  return sides;
}

ConvexPolyhedron box_polyhedron(ExactSpace& space, const Box3& box, const std::array<PlaneId, 6>& sides) {
  std::array<VertexId, 8> corner;
  for (unsigned c = 0; c < 8; ++c) {
    corner[c] =
        space.add_point({c & 1 ? box.max.x : box.min.x, c & 2 ? box.max.y : box.min.y, c & 4 ? box.max.z : box.min.z});
  }
  constexpr unsigned loops[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  ConvexPolyhedron result;
  for (std::size_t side = 0; side < 6; ++side) {
    ConvexPolyhedron::Face face{sides[side], {}};
    for (const unsigned c : loops[side]) face.loop.push_back(corner[c]);
    result.faces.push_back(std::move(face));
  }
  return result;
}

ConvexPolyhedron part_inside(ExactSpace& space, const ConvexPolyhedron& polyhedron,
                             const std::vector<PlaneId>& planes) {
  std::vector<Cut> cuts;
  cuts.reserve(planes.size());
  // Planes through edges of one facet meet beyond it, often many in one point.
  for (const PlaneId plane : planes) {
    cuts.push_back({plane, std::nullopt, space.name(plane).kind == FacetKind::blocker_face});
  }
  return clipped(space, polyhedron, std::move(cuts));
}

std::vector<ConvexPolyhedron> cells_outside(ExactSpace& space, ConvexPolyhedron rest,
                                            const std::vector<PlaneId>& planes) {
  std::vector<ConvexPolyhedron> cells;
  for (const PlaneId plane : planes) {
    if (rest.empty()) break;
    ConvexPolyhedron cell = clipped(space, rest, space.add_reversed(plane));
    if (!cell.empty()) cells.push_back(std::move(cell));
    rest = clipped(space, rest, plane);
  }
  return cells;
}

}  // namespace gnomon
