#pragma once

/// Convex cells of any dimension up to three, cut by planes, exactly.

#include <cstdint>
#include <vector>

#include "shading/inverse/whole.h"

namespace gnomon::inverse {

using CellPlane = std::uint32_t;
using CornerId = std::uint32_t;

/// A corner of a cell: a point, or a direction in which the cell is unbounded; and the planes that it lies on.
struct Corner {
  CornerId id;
  std::vector<CellPlane> planes;  ///< ascending
};

/// A convex cell as its corners. Two corners have an edge between them if no third one lies on all planes that they
/// have in common; so nothing else need be kept, whatever the cell's dimension. A cell of lower dimension has planes on
/// which all its corners lie.
struct Cell {
  std::vector<Corner> corners;

  bool empty() const { return corners.empty(); }
};

/// What becomes of a part that has no interior in its cell.
enum class FlatParts { dropped, kept };

/// Which side of a plane.
enum class PlaneSide { within, beyond };

/// Planes and corners of cells. Signs are taken of doubles with a bound, and of whole numbers where that does not
/// decide.
///
/// Bound. Planes and points are scaled by powers of two until their largest number is between 1/2 and 1; doubles hold
/// each within 2^-52 of its size, or, where it is below 2^-1000, within that. The sum of four products errs by less
/// than 9 * 2^-52 of the sum of their sizes, and 2^-990.
class CellSpace {
 public:
  CellPlane add_plane(Whole plane);
  CornerId add_corner(Whole corner);

  const Whole& plane(CellPlane plane) const { return planes_[plane].exact; }
  const Whole& corner(CornerId corner) const { return corners_[corner].exact; }
  std::size_t plane_count() const { return planes_.size(); }

  /// -1 within, 0 on the plane, +1 beyond.
  int side(CellPlane plane, CornerId corner) const;

 private:
  struct Numbers {
    Whole exact;
    std::array<double, 4> near;
  };
  static Numbers numbers(Whole exact);

  std::vector<Numbers> planes_;
  std::vector<Numbers> corners_;
};

/// The part of a cell on one closed side of a plane. Its corners know the plane where they lie on it.
///
/// Returns: nothing, where only the cell's boundary lies there and flat parts are dropped.
Cell part(CellSpace& space, const Cell& cell, CellPlane plane, PlaneSide side, FlatParts flat);

/// The part on the plane itself.
Cell section(CellSpace& space, const Cell& cell, CellPlane plane);

/// True if all corners lie on the closed side.
bool lies(const CellSpace& space, const Cell& cell, CellPlane plane, PlaneSide side);

/// 0 for a point, 1 for a segment or ray, 2, 3; of a cone of directions one less than the cone's.
int dimension(const CellSpace& space, const Cell& cell);

/// True if a corner lies at infinity.
bool reaches_infinity(const CellSpace& space, const Cell& cell);

/// A point inside, or for a cone of directions a direction inside, relative to the cell's dimension: the mean of the
/// corners, those at infinity added to it.
Whole middle(const CellSpace& space, const Cell& cell);

/// Pairs of corners, by their places in the cell, that an edge joins.
std::vector<std::array<std::uint32_t, 2>> edges(const Cell& cell);

/// The planes that the cell has faces of one dimension less on, each with the places of its corners in the cell.
struct CellFace {
  CellPlane plane;
  std::vector<std::uint32_t> corners;  ///< in order around the face where that is a polygon
};
std::vector<CellFace> faces(const CellSpace& space, const Cell& cell);

}  // namespace gnomon::inverse
