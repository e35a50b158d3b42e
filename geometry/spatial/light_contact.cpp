#include "geometry/spatial/light_contact.h"

#include <CGAL/determinant.h>

#include <algorithm>
#include <array>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/kernel.h"

namespace gnomon {
namespace {

/// Six times the volume of a, b, c, p: positive if p lies where a, b, c run counterclockwise.
Rational height(const ExactVector& a, const ExactVector& b, const ExactVector& c, const ExactVector& p) {
  const auto difference = [&](const ExactVector& q, std::size_t i) -> Rational { return q[i] - a[i]; };
  return CGAL::determinant<Rational>(difference(b, 0), difference(b, 1), difference(b, 2), difference(c, 0),
                                     difference(c, 1), difference(c, 2), difference(p, 0), difference(p, 1),
                                     difference(p, 2));
}

/// The part of a convex polygon (segment, point) on the closed negative side of a facet's plane.
std::vector<ExactVector> behind(const std::vector<ExactVector>& polygon, const BodyPair& pair, std::uint32_t facet) {
  const ExactVector a = exact(pair.blocker.facet_point(facet, 0));
  const ExactVector b = exact(pair.blocker.facet_point(facet, 1));
  const ExactVector c = exact(pair.blocker.facet_point(facet, 2));
  std::vector<ExactVector> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactVector& p = polygon[i];
    const ExactVector& q = polygon[(i + 1) % polygon.size()];
    const Rational hp = height(a, b, c, p);
    const Rational hq = height(a, b, c, q);
    if (hp <= 0) result.push_back(p);
    if ((hp < 0 && hq > 0) || (hp > 0 && hq < 0)) {
      const Rational t = hp / (hp - hq);
      result.push_back(
          {Rational(p[0] + t * (q[0] - p[0])), Rational(p[1] + t * (q[1] - p[1])), Rational(p[2] + t * (q[2] - p[2]))});
    }
  }
  return result;
}

/// The dimension of the hull of points: -1 for none.
int dimension(const std::vector<ExactVector>& points) {
  if (points.empty()) return -1;
  const ExactVector& a = points.front();
  const auto other = std::find_if(points.begin(), points.end(), [&](const ExactVector& p) { return p != a; });
  if (other == points.end()) return 0;
  const auto off_line = [&](const ExactVector& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const Rational cross = ((*other)[i] - a[i]) * (p[j] - a[j]) - ((*other)[j] - a[j]) * (p[i] - a[i]);
      if (cross != 0) return true;
    }
    return false;
  };
  return std::any_of(points.begin(), points.end(), off_line) ? 2 : 1;
}

int light_dimension(const BodyPair& pair) {
  return static_cast<int>(std::min<std::size_t>(pair.light.corners.size() - 1, 2));
}

/// The part of the light in a closed solid.
std::vector<ExactVector> light_inside(const BodyPair& pair) {
  std::vector<ExactVector> part;
  for (const Point3& corner : pair.light.corners) part.push_back(exact(corner));
  for (std::uint32_t f = 0; f < pair.blocker.facets.size() && !part.empty(); ++f) {
    if (pair.light_sides(f).positive) part = behind(part, pair, f);
  }
  return part;
}

LightContact contact_with_solid(const BodyPair& pair) {
  LightContact contact;
  const auto facets = static_cast<std::uint32_t>(pair.blocker.facets.size());
  for (std::uint32_t j = 0; j < pair.light.corners.size(); ++j) {
    bool outside = false;
    for (std::uint32_t f = 0; f < facets && !outside; ++f) outside = pair.facet_side(f, j) > 0;
    if (outside) contact.corners_outside.push_back(j);
  }
  for (std::uint32_t f = 0; f < facets; ++f) {
    if (pair.light_sides(f).all_positive()) return contact;
  }
  const std::vector<ExactVector> part = light_inside(pair);
  contact.meets = !part.empty();
  bool in_facet = false;
  for (std::uint32_t f = 0; f < facets; ++f) {
    const auto on_facet = [&](const ExactVector& p) {
      return height(exact(pair.blocker.facet_point(f, 0)), exact(pair.blocker.facet_point(f, 1)),
                    exact(pair.blocker.facet_point(f, 2)), p) == 0;
    };
    if (part.empty() || !std::all_of(part.begin(), part.end(), on_facet)) continue;
    in_facet = true;
    const bool has_extent = pair.light_sides(f).all_zero() && dimension(part) == light_dimension(pair);
    if (has_extent) contact.shared_facets.push_back(f);
  }
  contact.meets_interior = contact.meets && !in_facet;
  return contact;
}

/// True if a corner of the light in the plane of a flat blocker lies in it: on the inner side of every edge. Sides are
/// those of planes through the edges and a light corner off the plane.
bool lies_in_polygon(const BodyPair& pair, std::uint32_t off, std::uint32_t j) {
  const Body& blocker = pair.blocker;
  const auto size = static_cast<std::uint32_t>(blocker.corners.size());
  for (std::uint32_t k = 0; k < size; ++k) {
    const Point3& u = blocker.corners[k];
    const Point3& v = blocker.corners[(k + 1) % size];
    const Point3& apex = pair.light.corners[off];
    const int inner = pair.orientation(u, v, apex, blocker.corners[(k + 2) % size]);
    if (inner * pair.orientation(u, v, apex, pair.light.corners[j]) < 0) return false;
  }
  return true;
}

LightContact contact_with_polygon(const BodyPair& pair) {
  LightContact contact;
  std::uint32_t off = 0;
  while (pair.facet_side(0, off) == 0) ++off;
  for (std::uint32_t j = 0; j < pair.light.corners.size(); ++j) {
    if (pair.facet_side(0, j) == 0 && lies_in_polygon(pair, off, j)) {
      contact.meets = true;
    } else {
      contact.corners_outside.push_back(j);
    }
  }
  return contact;
}

}  // namespace

LightContact light_contact(const BodyPair& pair) {
  return pair.blocker.flat ? contact_with_polygon(pair) : contact_with_solid(pair);
}

}  // namespace gnomon
