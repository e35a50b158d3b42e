#include "shading/illumination/brightest_place.h"

#include <array>
#include <cmath>

#include "geometry/numbers/vector3.h"
#include "shading/illumination/outlines.h"

namespace gnomon::illumination {
namespace {

Vector3<double> unit_vector(const Vector3<double>& v) {
  return 1 / std::hypot(v.x, v.y, v.z) * v;
}

}  // namespace

Probe brightest_place(const ConvexPolygon& receiver, const Probe& from, LightsTogether& lights, std::size_t worker) {
  const auto corner = [&](std::size_t k) { return receiver.points()[receiver.corners()[k]]; };
  const Vector3<double> u = unit_vector(step(corner(0), corner(1)));
  const Vector3<double> v = unit_vector(cross(cross(u, step(corner(0), corner(2))), u));
  const std::array<Vector3<double>, 8> ways = {u,        unit_vector(u + v),          v,        unit_vector(v - u),
                                               -1.0 * u, unit_vector(-1.0 * (u + v)), -1.0 * v, unit_vector(u - v)};
  const double extent = extent_of(receiver.points());
  Probe best = from;
  for (double stride = extent / 4; stride > 0x1p-14 * extent;) {
    const Probe before = best;
    for (const Vector3<double>& way : ways) {
      const Point3& p = before.point;
      const Point3 q{p.x + stride * way.x, p.y + stride * way.y, p.z + stride * way.z};
      if (!is_on(receiver, q)) continue;
      const Irradiance found = lights.sum(worker, from.receiver, q);
      if (std::isfinite(found.value) && found.value > best.irradiance.value) best = {from.receiver, q, found};
    }
    if (best.irradiance.value == before.irradiance.value) stride /= 2;
  }
  return best;
}

}  // namespace gnomon::illumination
