#pragma once

/// Surfaces as flat pieces. Private to the libraries.

#include <cstdint>
#include <span>
#include <vector>

#include "gnomon/view_factors.h"
#include "shading/illumination/contour_integral.h"

namespace gnomon::illumination {

/// A flat piece of a surface.
struct Piece {
  ConvexPolygon polygon;
  std::uint32_t surface = 0;
  double area = 0;
  std::vector<Point3> plate =
      {};  ///< of a triangle, the vertices of the polygon it was cut from, in an order of theirs
};

/// True of pieces of one polygon whose vertices were rounded off their plane, of its front or its back: they would see
/// each other past what was rounded.
bool are_of_one_plate(const Piece& a, const Piece& b);

/// The pieces of all surfaces, in their order; polygons whose vertices were rounded off their plane as triangles.
std::vector<Piece> flat_pieces(std::span<const ViewSurface> surfaces);

/// Off by at most 4 units in the last place.
double area_of(const ConvexPolygon& polygon);

/// What of a piece lies before another, as one loop; nothing where none of it does.
struct PartBefore {
  Loops loops;
  double rounding = 0;  ///< the area by which rounded corners may change it
};
PartBefore part_before(const ConvexPolygon& piece, const ConvexPolygon& other);

}  // namespace gnomon::illumination
