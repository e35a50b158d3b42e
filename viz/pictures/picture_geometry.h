#pragma once

#include <span>
#include <vector>

#include "gnomon/point.h"

class vtkPolyData;

namespace gnomon::viz {

/// A plane of a picture. Orientation: points with a positive distance are on the side of the normal.
struct PicturePlane {
  Point3 origin;
  Point3 normal;  ///< of length 1

  double distance(const Point3& point) const;
};

using Polygon = std::vector<Point3>;

/// The plane of a polygon by Newell's formula; counterclockwise seen from the side of the normal.
PicturePlane polygon_plane(std::span<const Point3> polygon);

double polygon_area(std::span<const Point3> polygon);

/// Where the plane cuts a convex closed surface: a convex polygon, counterclockwise seen from the side of the normal;
/// empty where it misses.
Polygon section(vtkPolyData& convex_surface, const PicturePlane& plane);

/// The part of a convex polygon inside another one that lies in the same plane and runs counterclockwise around
/// `normal`.
Polygon clipped(Polygon polygon, std::span<const Point3> window, const Point3& normal);

/// All points of a surface.
std::vector<Point3> points_of(vtkPolyData& surface);

/// The cells of a surface as polygons, whatever their size.
std::vector<Polygon> polygons_of(vtkPolyData& surface);

}  // namespace gnomon::viz
