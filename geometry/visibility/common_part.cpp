#include "geometry/visibility/common_part.h"

#include "geometry/numbers/exact_vector.h"

namespace gnomon::viewpoint {
namespace {

/// What of a convex loop lies on a plane or below it.
ExactPolygon part_below(const ExactPlane& plane, const ExactPolygon& loop) {
  ExactPolygon part;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const ExactVector& a = loop[i];
    const ExactVector& b = loop[i + 1 == loop.size() ? 0 : i + 1];
    const Rational at_a = plane.height(a);
    const Rational at_b = plane.height(b);
    if (at_a <= 0) part.push_back(a);
    if (at_a.sign() * at_b.sign() < 0) part.push_back(a + Rational(at_a / (at_a - at_b)) * (b - a));
  }
  return part;
}

ExactPlane turned(const ExactPlane& plane) {
  return {Rational(-1) * plane.normal, -plane.offset};
}

/// The part in a polygon: in its plane, and below the planes that stand on its sides.
ExactPolygon part_in(std::span<const Point3> corners, ExactPolygon loop) {
  const ExactVector origin = exact(corners[0]);
  const ExactPlane plane = plane_through(origin, exact(corners[1]), exact(corners[2]));
  loop = part_below(turned(plane), part_below(plane, loop));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const ExactVector from = exact(corners[k]);
    const ExactVector outward = cross(exact(corners[k + 1 == corners.size() ? 0 : k + 1]) - from, plane.normal);
    loop = part_below({outward, -dot(outward, from)}, loop);
  }
  return loop;
}

ExactPolygon part_in(const ConvexSolid& solid, ExactPolygon loop) {
  const std::span<const Point3> points = solid.points();
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    const auto corner = [&](std::size_t i) { return exact(points[facet.loop[i]]); };
    loop = part_below(plane_through(corner(0), corner(1), corner(2)), loop);
  }
  return loop;
}

}  // namespace

bool have_common_point(const BlockerSet::Content& blockers, std::uint32_t blocker, std::span<const Point3> hull) {
  ExactPolygon loop;
  for (const Point3& p : hull) loop.push_back(exact(p));
  const BlockerSet::Content::Shape& shape = blockers.shapes[blocker];
  if (shape.solid >= 0) return !part_in(blockers.solids[static_cast<std::size_t>(shape.solid)], loop).empty();
  return !part_in(blockers.corners(shape), loop).empty();
}

}  // namespace gnomon::viewpoint
