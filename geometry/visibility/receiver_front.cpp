#include "geometry/visibility/receiver_front.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/orientation.h"

namespace gnomon {
namespace {

/// Sign of dot(n, q - p).
/// Bound. Differences, products and two sums are rounded: less than 5 u of the absolute terms, and what underflows.
int side_of_normal(const Point3& n, const Point3& p, const Point3& q) {
  const double x = n.x * (q.x - p.x);
  const double y = n.y * (q.y - p.y);
  const double z = n.z * (q.z - p.z);
  const double sum = x + y + z;
  const double bound = 5 * 0x1p-53 * (std::fabs(x) + std::fabs(y) + std::fabs(z)) + 1e-300;
  if (sum > bound && sum < HUGE_VAL) return 1;
  if (sum < -bound && sum > -HUGE_VAL) return -1;
  return dot(exact(n), exact(q) - exact(p)).sign();
}

}  // namespace

ExactPlane exact_front(const ReceiverPoint& receiver) {
  if (const auto* facet = std::get_if<FacetFront>(&receiver.front)) {
    const auto& [a, b, c] = facet->corners;
    return plane_through(exact(a), exact(b), exact(c));
  }
  const ExactVector normal = exact(std::get<FacingNormal>(receiver.front).normal);
  return {normal, -dot(normal, exact(receiver.point))};
}

FacetFront facet_front(const ConvexPolygon& facet) {
  const auto corner = [&](std::size_t k) { return facet.points()[facet.corners()[k]]; };
  return {{corner(0), corner(1), corner(2)}};
}

int side_of_front(const ReceiverPoint& receiver, const Point3& q) {
  if (const auto* facing = std::get_if<FacingNormal>(&receiver.front)) {
    return side_of_normal(facing->normal, receiver.point, q);
  }
  const auto& [a, b, c] = std::get<FacetFront>(receiver.front).corners;
  return exact_orientation(a, b, c, q);
}

int side_of_front_towards(const ReceiverFront& front, const Point3& direction) {
  if (const auto* facing = std::get_if<FacingNormal>(&front)) return side_of_normal(facing->normal, {}, direction);
  const auto& [a, b, c] = std::get<FacetFront>(front).corners;
  return exact_direction_side(a, b, c, direction);
}

int side_of_step(const ReceiverFront& front, const Point3& a, const Point3& b, const Point3& c) {
  if (const auto* facing = std::get_if<FacingNormal>(&front)) return exact_direction_side(a, b, c, facing->normal);
  const ExactPlane plane = plane_through(exact(a), exact(b), exact(c));
  return plane.slope(exact_front({{}, front}).normal).sign();
}

bool reaches_before(const ReceiverPoint& receiver, std::span<const Point3> points) {
  return std::any_of(points.begin(), points.end(), [&](const Point3& q) { return side_of_front(receiver, q) > 0; });
}

}  // namespace gnomon
