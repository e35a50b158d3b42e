#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/spatial/prepared_pair.h"
#include "geometry/spatial/shadow_polyhedra.h"

namespace gnomon {

/// A pair's volumes in a box as exact polyhedra, and the space they live in.
///
/// Requires: the rounding mode is protected while it is made and used.
struct PairPolyhedra {
  PairPolyhedra(const PreparedPair& pair, const Box3& box);

  /// The box itself, made when it is first needed.
  const ConvexPolyhedron& whole_box();

  ShadowPlanes planes;
  std::array<PlaneId, 6> sides;
  ConvexPolyhedron occlusion;
  ConvexPolyhedron umbra;

 private:
  void make_standard(const StandardPair& pair, const StandardContacts& contacts);
  void make_general(const PairHalfSpaces& half_spaces);

  Box3 box_;
  std::optional<ConvexPolyhedron> whole_box_;
};

/// The penumbra as convex cells that share no interior point; none for lights of a single point.
std::vector<ConvexPolyhedron> penumbra_cells(const PreparedPair& pair, PairPolyhedra& polyhedra);

/// The part of a solid blocker in the umbra: in the box and, where it crosses a one-sided light's plane, in front of
/// it.
///
/// Requires: pair.has_solid().
ConvexPolyhedron solid_in_umbra(const PreparedPair& pair, PairPolyhedra& polyhedra);

}  // namespace gnomon
