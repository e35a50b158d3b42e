#pragma once

#include <array>
#include <vector>

#include "geometry/spatial/exact_polyhedron.h"
#include "geometry/spatial/pair.h"

namespace gnomon {

/// The contacts of a pair in standard position and the half-spaces they bound, in the order of the rings.
struct PairHalfSpaces {
  explicit PairHalfSpaces(const StandardPair& pair);

  std::vector<TouchedCorners> separating;     ///< for each blocker side
  std::vector<TouchedCorners> supporting;     ///< for each blocker side
  std::vector<LightSideContact> light_sides;  ///< from separating_light_contacts
  HalfSpace blocker_face;
  std::vector<HalfSpace> separating_blocker;  ///< for each of `separating`
  std::vector<HalfSpace> separating_light;    ///< for each of `light_sides`
  std::vector<HalfSpace> supporting_blocker;  ///< for each of `supporting`
};

/// Occlusion and umbra of a pair as exact polyhedra, unbounded as they are.
///
/// Requires: the rounding mode is protected while it is made and used.
struct ShadowPolyhedra {
  ShadowPolyhedra(const StandardPair& pair, const PairHalfSpaces& half_spaces);

  ExactSpace space;
  PlaneId blocker_face = ExactSpace::downward;
  std::vector<PlaneId> separating_blocker;  ///< for each blocker side
  std::vector<PlaneId> supporting_blocker;  ///< for each blocker side
  ConvexPolyhedron occlusion;
  ConvexPolyhedron umbra;
};

/// True if the polyhedron (or one face of it) reaches infinity.
bool reaches_infinity(const ExactSpace& space, const ConvexPolyhedron& polyhedron);
bool reaches_infinity(const ExactSpace& space, const ConvexPolyhedron::Face& face);

/// The six planes of a box, in the order of FacetName's sides.
std::array<PlaneId, 6> add_box(ExactSpace& space, const Box3& box);

/// The polyhedron cut by all six sides of a box.
ConvexPolyhedron clipped_by_box(ExactSpace& space, ConvexPolyhedron polyhedron, const std::array<PlaneId, 6>& sides);

/// The penumbra as convex cells: the occlusion split along the supporting planes. Each cell lies outside one of them
/// and inside all before it; cells without interior are left out.
std::vector<ConvexPolyhedron> penumbra_cells(ExactSpace& space, ConvexPolyhedron occlusion,
                                             const std::vector<PlaneId>& supporting);

}  // namespace gnomon
