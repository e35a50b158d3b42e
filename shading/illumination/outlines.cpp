#include "shading/illumination/outlines.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/vector3.h"

namespace gnomon::illumination {
namespace {

double length(const Vector3<double>& v) {
  return std::hypot(v.x, v.y, v.z);
}

}  // namespace

Point3 near_point(const ExactVector& p) {
  return {p.x.convert_to<double>(), p.y.convert_to<double>(), p.z.convert_to<double>()};
}

double extent_of(std::span<const Point3> points) {
  Point3 low = points[0], high = points[0];
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return length(step(low, high));
}

double distance(const Point3& p, const Point3& a, const Point3& b) {
  const Vector3<double> along = step(a, b), way = step(a, p);
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(way, along) / square, 0.0, 1.0) : 0;
  return length(way - share * along);
}

bool is_on(const ConvexPolygon& receiver, const Point3& p) {
  const auto points = receiver.points();
  const auto corner = [&](std::size_t k) { return points[receiver.corners()[k]]; };
  const Vector3<double> normal = cross(step(corner(0), corner(1)), step(corner(0), corner(2)));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vector3<double> along = step(points[k], points[(k + 1) % points.size()]), way = step(points[k], p);
    if (dot(cross(along, way), normal) < -1e-12 * length(along) * length(way) * length(normal)) return false;
  }
  return true;
}

Outline outline_of(std::span<const ConvexPolygon* const> receivers, std::span<const ReceiverTraces> traces,
                   std::uint8_t highest_order) {
  Outline outline;
  for (std::size_t r = 0; r < receivers.size(); ++r) {
    std::vector<ExactVector>& ring = outline.rings.emplace_back();
    for (const Point3& p : receivers[r]->points()) ring.push_back(exact(p));
    for (const Trace& trace : traces[r].traces) {
      if (trace.order <= highest_order) outline.traces.push_back(trace);
    }
  }
  return outline;
}

}  // namespace gnomon::illumination
