#include "geometry/visibility/flat_area.h"

#include "geometry/kernel.h"
#include "geometry/rounding.h"

namespace gnomon::sight {
namespace {

using Kind = Station::Kind;

double coordinate(const Point3& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

FlatPoint difference(const FlatPoint& p, const FlatPoint& origin) {
  const double u = p.u - origin.u;
  const double v = p.v - origin.v;
  return {u, v, p.error + origin.error + 2 * unit * std::max(std::fabs(u), std::fabs(v))};
}

}  // namespace

FlatArea flat_area(std::span<const Point3> corners, int u, int v) {
  Rational sum = 0;
  const Rational u0(coordinate(corners[0], u));
  const Rational v0(coordinate(corners[0], v));
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Rational pu(Rational(coordinate(corners[k], u)) - u0);
    const Rational pv(Rational(coordinate(corners[k], v)) - v0);
    const Rational qu(Rational(coordinate(corners[k + 1], u)) - u0);
    const Rational qv(Rational(coordinate(corners[k + 1], v)) - v0);
    sum += pu * qv - pv * qu;
  }
  const double doubled = std::fabs(nearest_double(sum));
  return {doubled, unit * doubled};
}

/// Bound. A cross product of normals errs by 4.1 u na nb from rounding and 2 (ea nb + na eb) from its factors.
SightDirection direction_of(const Edge& edge, const Station& station) {
  if (station.kind == Kind::start) return direction_of(*edge.start);
  if (station.kind == Kind::end) return direction_of(*edge.end);
  if (station.vertex != nullptr) return direction_of(*station.vertex);
  const Plane& a = station.rising ? *station.plane : *edge.plane;
  const Plane& b = station.rising ? *edge.plane : *station.plane;
  const Vector d = cross(a.normal, b.normal);
  const double error = 4.2 * unit * a.size * b.size + 2.1 * (a.error * b.size + a.size * b.error) + tiny;
  return {d.x, d.y, d.z, root_of_three * error};
}

AreaSum::AreaSum(const LightPlane& plane, const Ray& origin)
    : plane_(plane),
      origin_{coordinate(origin.direction, plane.u), coordinate(origin.direction, plane.v), unit * origin.size} {}

/// The corners of the light lie on its plane: there is nothing to intersect.
FlatPoint AreaSum::from_origin(const SightDirection& direction, bool is_corner) const {
  const Vector d{direction.x, direction.y, direction.z};
  if (!is_corner) return difference(meeting_point(plane_, d, size_of(d), direction.error), origin_);
  return difference({coordinate(d, plane_.u), coordinate(d, plane_.v), direction.error}, origin_);
}

/// Bound. With errors e and f of the two points, the product errs by 2 (|p| f + e |q| + e f) and 3 roundings; the sum
/// by one rounding of what it is.
void AreaSum::add(const Piece& piece, const BoundaryPiece& made) {
  const FlatPoint p = from_origin(made.start, piece.of_light && piece.stretch.from.kind != Kind::inner);
  const FlatPoint q = from_origin(made.end, piece.of_light && piece.stretch.to.kind != Kind::inner);
  const double p_size = std::max(std::fabs(p.u), std::fabs(p.v));
  const double q_size = std::max(std::fabs(q.u), std::fabs(q.v));
  sum_ += p.u * q.v - p.v * q.u;
  error_ += 2 * (p_size * q.error + q_size * p.error + p.error * q.error) + 4 * unit * p_size * q_size +
            unit * std::fabs(sum_) + tiny;
}

}  // namespace gnomon::sight
