#include <algorithm>
#include <cmath>

#include "geometry/numbers/vector3.h"
#include "gnomon/illumination.h"

namespace gnomon {
namespace {

double illuminated_area(const Point3& a, const Point3& b, const Point3& c) {
  const Vector3<double> n = cross(step(a, b), step(a, c));
  return std::hypot(n.x, n.y, n.z) / 2;
}

double illuminated_area(const IlluminationMesh& mesh, const IlluminationFace& face) {
  const auto& [a, b, c] = face.corners;
  return illuminated_area(mesh.points[a], mesh.points[b], mesh.points[c]);
}

}  // namespace

double IlluminationMesh::largest_error() const {
  double largest = 0;
  for (const IlluminationFace& face : faces) largest = std::max(largest, face.error);
  return largest;
}

std::size_t IlluminationMesh::unmet_faces() const {
  return static_cast<std::size_t>(std::ranges::count(faces, false, &IlluminationFace::is_met));
}

double IlluminationMesh::unmet_area() const {
  double sum = 0;
  for (const IlluminationFace& face : faces) sum += face.is_met ? 0 : illuminated_area(*this, face);
  return sum;
}

double IlluminationMesh::area() const {
  double sum = 0;
  for (const IlluminationFace& face : faces) sum += illuminated_area(*this, face);
  return sum;
}

double IlluminationMesh::flux() const {
  double sum = 0;
  for (const IlluminationFace& face : faces) {
    // The mean of a quadratic function on a triangle is that of the middles of its edges.
    const auto& [a, b, c] = order == 1 ? face.corners : face.middles;
    sum +=
        illuminated_area(*this, face) * (irradiance[a].value / 3 + irradiance[b].value / 3 + irradiance[c].value / 3);
  }
  return sum;
}

double IlluminationMesh::flux_error() const {
  double sum = 0;
  for (const IlluminationFace& face : faces) sum += illuminated_area(*this, face) * face.error;
  return sum;
}

}  // namespace gnomon
