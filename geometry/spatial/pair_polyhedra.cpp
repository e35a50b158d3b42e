#include "geometry/spatial/pair_polyhedra.h"

#include "geometry/errors.h"
#include "geometry/spatial/position.h"

namespace gnomon {
namespace {

HalfSpace facet_half_space(const HullPair& pair, std::uint32_t facet) {
  return {{FacetKind::blocker_face, -1, static_cast<std::int32_t>(facet)},
          {pair.blocker.facet_point(facet, 0), pair.blocker.facet_point(facet, 1), pair.blocker.facet_point(facet, 2)}};
}

HalfSpace first_half_space(const PreparedPair& pair) {
  return pair.standard ? pair.half_spaces.occlusion.front() : facet_half_space(*pair.hulls, 0);
}

}  // namespace

PreparedPair prepared_pair(const Light& light, const ConvexBlocker& blocker) {
  if (!is_supported(light, blocker)) {
    throw PreconditionError(
        "a light that is not exactly flat needs the blocker strictly apart from it, and in front if it is one-sided");
  }
  PreparedPair result;
  if (is_standard_polygon_pair(light, blocker)) {
    result.standard = standard_pair(light, std::get<ConvexPolygon>(blocker));
    result.contacts.emplace(*result.standard);
    result.half_spaces = standard_half_spaces(*result.standard, *result.contacts);
  } else {
    result.hulls.emplace(hull(light), hull(blocker));
    result.half_spaces = pair_half_spaces(*result.hulls, light);
  }
  return result;
}

PairPolyhedra::PairPolyhedra(const PreparedPair& pair, const Box3& box)
    : planes(pair.half_spaces, first_half_space(pair)),
      sides(add_box(planes.space, box)),
      whole_box(box_polyhedron(planes.space, box, sides)) {
  ExactSpace& space = planes.space;
  if (pair.standard) {
    occlusion = clipped(space, standard_occlusion(space, *pair.standard, *pair.contacts, planes.occlusion), {}, sides);
  } else if (!pair.half_spaces.occlusion_empty) {
    occlusion = part_inside(space, whole_box, planes.occlusion);
  }
  if (!pair.half_spaces.umbra_empty) umbra = part_inside(space, whole_box, planes.umbra);
}

std::vector<ConvexPolyhedron> penumbra_cells(const PreparedPair& pair, PairPolyhedra& polyhedra) {
  if (!pair.has_penumbra() || polyhedra.occlusion.empty()) return {};
  if (pair.half_spaces.umbra_empty) return {polyhedra.occlusion};
  std::vector<PlaneId> inner;
  for (std::size_t i = 0; i < polyhedra.planes.umbra.size(); ++i) {
    if (pair.half_spaces.shared[i] == PairHalfSpaces::none) inner.push_back(polyhedra.planes.umbra[i]);
  }
  return cells_outside(polyhedra.planes.space, polyhedra.occlusion, inner);
}

ConvexPolyhedron solid_in_umbra(const PreparedPair& pair, PairPolyhedra& polyhedra) {
  std::vector<PlaneId> planes;
  for (std::uint32_t f = 0; f < pair.hulls->blocker.facets.size(); ++f) {
    planes.push_back(polyhedra.planes.space.add_plane(facet_half_space(*pair.hulls, f)));
  }
  return part_inside(polyhedra.planes.space, polyhedra.umbra, planes);
}

}  // namespace gnomon
