#pragma once

/// Planes with names, and convex sets of them.

#include <vector>

#include "gnomon/light_design.h"
#include "shading/inverse/cells.h"

namespace gnomon::inverse {

/// A half-space with its name. The plane itself belongs to it or not: what decides for positions on boundaries.
struct Wall {
  CellPlane plane;
  bool is_closed = true;
};

/// The intersection of half-spaces; without any, all of space.
struct ConvexSet {
  std::vector<Wall> walls;
  std::optional<CellPlane> flat = {};  ///< of a set in one plane: that plane
};

/// What a goal leaves: positions within all of `within`, in one of `any` if there are alternatives, in none of `none`,
/// and on all of the planes `on`.
struct GoalSets {
  std::vector<CellPlane> on;
  std::vector<Wall> within;
  std::vector<std::vector<ConvexSet>> any;  ///< of each alternative list one; an empty list is a contradiction
  std::vector<ConvexSet> none;
  /// Lists of sets: where two of one list overlap, more than `any` says may fulfil the goal.
  std::vector<std::vector<ConvexSet>> overlapping;
};

/// Cells, and what their planes come from.
struct DesignSpace {
  CellSpace cells;
  std::vector<DesignWall> names;  ///< of each plane

  CellPlane add(Whole plane, const DesignWall& name) {
    names.push_back(name);
    return cells.add_plane(std::move(plane));
  }
};

/// All of a plane as a set.
inline ConvexSet whole_plane_set(DesignSpace& space, const ExactVector& normal, const Rational& offset,
                                 const DesignWall& name) {
  ConvexSet set;
  set.flat = space.add(whole_plane(normal, offset), name);
  set.walls = {{*set.flat, true}, {space.add(whole_plane(Rational(-1) * normal, Rational(-offset)), name), true}};
  return set;
}

/// True if a point lies in the set; on its boundary where that belongs to it.
bool contains(const DesignSpace& space, const ConvexSet& set, CornerId point);
bool contains(const DesignSpace& space, const Wall& wall, CornerId point);

/// True if the sets of a goal hold at a point.
bool holds(const DesignSpace& space, const GoalSets& goal, CornerId point);

/// The cells of a domain. What is everywhere ends far beyond all corners that the planes of the space can have: cells
/// that reach its end are unbounded.
///
/// Requires: for DomainShape::everywhere all planes are in the space already.
/// Throws:   DesignError for a polygon that is not flat.
std::vector<Cell> domain_cells(DesignSpace& space, const DesignDomain& domain);

}  // namespace gnomon::inverse
