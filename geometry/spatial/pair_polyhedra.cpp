#include "geometry/spatial/pair_polyhedra.h"

#include <algorithm>

#include "geometry/spatial/occlusion_volume.h"
#include "geometry/spatial/umbra_volume.h"

namespace gnomon {
namespace {

/// The half-space behind a facet, of flat blockers too with the facet's number: front and back have one plane, but two
/// half-spaces.
HalfSpace numbered_facet_half_space(const BodyPair& pair, std::uint32_t facet) {
  HalfSpace half_space = facet_half_space(pair, facet);
  half_space.name.vertex_index = facet;
  return half_space;
}

HalfSpace first_half_space(const PreparedPair& pair) {
  return pair.standard ? pair.half_spaces.occlusion.front() : numbered_facet_half_space(*pair.bodies, 0);
}

/// The sides of a box, those first that face the shadow of a pair most: what reaches infinity ends there, and little is
/// left to cut for the others. The order decides nothing but the cost.
std::array<PlaneId, 6> in_order_of_use(const std::array<PlaneId, 6>& sides, const StandardPair& pair) {
  const Point3& from = pair.light.corner(0);
  const Point3& to = pair.blocker.corner(0);
  const std::array<double, 3> along = {to.x - from.x, to.y - from.y, to.z - from.z};
  std::array<std::size_t, 6> order = {0, 1, 2, 3, 4, 5};
  const auto facing = [&](std::size_t side) { return side % 2 == 0 ? -along[side / 2] : along[side / 2]; };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return facing(a) != facing(b) ? facing(a) > facing(b) : a < b; });
  std::array<PlaneId, 6> result{};
  for (std::size_t i = 0; i < 6; ++i) result[i] = sides[order[i]];
  return result;
}

}  // namespace

PairPolyhedra::PairPolyhedra(const PreparedPair& pair, const Box3& box)
    : planes(pair.half_spaces, first_half_space(pair)), sides(add_box(planes.space, box)), box_(box) {
  if (pair.standard) {
    make_standard(*pair.standard, *pair.contacts);
  } else {
    make_general(pair.half_spaces);
  }
}

const ConvexPolyhedron& PairPolyhedra::whole_box() {
  if (!whole_box_) whole_box_ = box_polyhedron(planes.space, box_, sides);
  return *whole_box_;
}

void PairPolyhedra::make_standard(const StandardPair& pair, const StandardContacts& contacts) {
  ExactSpace& space = planes.space;
  const std::array<PlaneId, 6> order = in_order_of_use(sides, pair);
  const std::vector<VertexId> corners = standard_corners(space, pair);
  occlusion = clipped(space, standard_occlusion(space, pair, contacts, corners, planes.occlusion), {}, order);
  const ConvexPolyhedron widening = standard_umbra(space, corners, planes.umbra);
  umbra = widening.empty() ? part_inside(space, whole_box(), planes.umbra) : clipped(space, widening, {}, order);
}

void PairPolyhedra::make_general(const PairHalfSpaces& half_spaces) {
  if (!half_spaces.occlusion_empty) occlusion = part_inside(planes.space, whole_box(), planes.occlusion);
  if (!half_spaces.umbra_empty) umbra = part_inside(planes.space, whole_box(), planes.umbra);
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
  for (std::uint32_t f = 0; f < pair.bodies->blocker.facets.size(); ++f) {
    planes.push_back(polyhedra.planes.space.add_plane(numbered_facet_half_space(*pair.bodies, f)));
  }
  return part_inside(polyhedra.planes.space, polyhedra.umbra, planes);
}

}  // namespace gnomon
