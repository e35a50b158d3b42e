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

AreaSum::AreaSum(const LightPlane& plane, const Outlines& outlines) : plane_(plane), outlines_(outlines) {}

/// The light's first corner is the origin.
FlatPoint AreaSum::from_origin(const Edge& edge, const Station& station, const SightDirection& direction) const {
  const FlatPoint& origin = outlines_.flats.front();
  const std::uint32_t ray = ray_at(edge, station);
  if (ray != Station::none) return difference(outlines_.flats[ray], origin);
  const Vector d{direction.x, direction.y, direction.z};
  return difference(meeting_point(plane_, d, size_of(d), direction.error), origin);
}

/// Bound. With errors e and f of the two points, the product errs by 2 (|p| f + e |q| + e f) and 3 roundings; the sum
/// by one rounding of what it is.
void AreaSum::add(const Piece& piece, const BoundaryPiece& made) {
  const bool forward = piece.edge.of_light();
  const FlatPoint p = from_origin(piece.edge, forward ? piece.stretch.from : piece.stretch.to, made.start);
  const FlatPoint q = from_origin(piece.edge, forward ? piece.stretch.to : piece.stretch.from, made.end);
  const double p_size = std::max(std::fabs(p.u), std::fabs(p.v));
  const double q_size = std::max(std::fabs(q.u), std::fabs(q.v));
  sum_ += p.u * q.v - p.v * q.u;
  error_ += 2 * (p_size * q.error + q_size * p.error + p.error * q.error) + 4 * unit * p_size * q_size +
            unit * std::fabs(sum_) + tiny;
}

}  // namespace gnomon::sight
