#include "viz/pictures/picture_geometry.h"

#include <vtkCell.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

#include "viz/vtk/vector.h"

namespace gnomon::viz {
namespace {

/// Twice the polygon's area along its normal.
Point3 area_vector(std::span<const Point3> polygon) {
  Point3 sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum = sum + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return sum;
}

Point3 centroid(std::span<const Point3> points) {
  Point3 sum;
  for (const Point3& p : points) sum = sum + p;
  return 1.0 / static_cast<double>(points.size()) * sum;
}

/// The point where the plane meets the segment, whose ends lie on different sides.
Point3 crossing(const Point3& a, double da, const Point3& b, double db) {
  return a + da / (da - db) * (b - a);
}

/// Points of a convex polygon's boundary in order around it.
Polygon around(Polygon points, const Point3& normal) {
  const Point3 middle = centroid(points);
  const Point3 x = unit(points[0] - middle);
  const Point3 y = cross(normal, x);
  const auto angle = [&](const Point3& p) { return std::atan2(dot(p - middle, y), dot(p - middle, x)); };
  std::ranges::sort(points, {}, angle);
  return points;
}

}  // namespace

double PicturePlane::distance(const Point3& point) const {
  return dot(point - origin, normal);
}

PicturePlane polygon_plane(std::span<const Point3> polygon) {
  return {centroid(polygon), unit(area_vector(polygon))};
}

double polygon_area(std::span<const Point3> polygon) {
  return length(area_vector(polygon)) / 2;
}

Polygon section(vtkPolyData& convex_surface, const PicturePlane& plane) {
  Polygon points;
  for (const Polygon& facet : polygons_of(convex_surface)) {
    for (std::size_t i = 0; i < facet.size(); ++i) {
      const Point3& a = facet[i];
      const Point3& b = facet[(i + 1) % facet.size()];
      const double da = plane.distance(a);
      const double db = plane.distance(b);
      if (da == 0) points.push_back(a);
      if ((da < 0 && db > 0) || (da > 0 && db < 0)) points.push_back(crossing(a, da, b, db));
    }
  }
  return points.size() < 3 ? Polygon{} : around(std::move(points), plane.normal);
}

Polygon clipped(Polygon polygon, std::span<const Point3> window, const Point3& normal) {
  for (std::size_t i = 0; i < window.size(); ++i) {
    const PicturePlane side{window[i], unit(cross(normal, window[(i + 1) % window.size()] - window[i]))};
    Polygon inside;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point3& a = polygon[k];
      const Point3& b = polygon[(k + 1) % polygon.size()];
      const double da = side.distance(a);
      const double db = side.distance(b);
      if (da >= 0) inside.push_back(a);
      if ((da < 0 && db > 0) || (da > 0 && db < 0)) inside.push_back(crossing(a, da, b, db));
    }
    polygon = std::move(inside);
  }
  return polygon.size() < 3 ? Polygon{} : polygon;
}

std::vector<Point3> points_of(vtkPolyData& surface) {
  std::vector<Point3> points;
  for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
    double p[3];
    surface.GetPoint(i, p);
    points.push_back({p[0], p[1], p[2]});
  }
  return points;
}

std::vector<Polygon> polygons_of(vtkPolyData& surface) {
  std::vector<Polygon> polygons;
  for (vtkIdType i = 0; i < surface.GetNumberOfCells(); ++i) {
    vtkPoints* corners = surface.GetCell(i)->GetPoints();
    Polygon polygon;
    for (vtkIdType k = 0; k < corners->GetNumberOfPoints(); ++k) {
      double p[3];
      corners->GetPoint(k, p);
      polygon.push_back({p[0], p[1], p[2]});
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

}  // namespace gnomon::viz
