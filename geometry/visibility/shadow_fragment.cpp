#include "geometry/visibility/shadow_fragment.h"

#include <algorithm>
#include <optional>

#include "geometry/numbers/orientation.h"
#include "geometry/numbers/rounding.h"

namespace gnomon::viewpoint {
namespace {

FragmentCorner corner_at(const ExactVector& p, std::int32_t edge) {
  return {p, {nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)}, edge};
}

/// Where the way from one corner to another crosses the plane.
ExactVector crossing(const ExactPlane& plane, const ExactVector& p, const ExactVector& q) {
  const Rational at_p = plane.height(p);
  return p + Rational(at_p / (at_p - plane.height(q))) * (q - p);
}

}  // namespace

/// Bound. As that of Plane: a normal of two rounded differences errs by 8.6 u times their sizes, its product with a
/// rounded step by three times that error and 12.5 u of the sizes.
SignedPlane::SignedPlane(const std::array<Point3, 3>& points, bool is_along) : points_(points), is_along_(is_along) {
  const Vector first = points[1] - points[0];
  const Vector second = is_along ? Vector{points[2].x, points[2].y, points[2].z} : points[2] - points[0];
  normal_ = is_along ? cross(second, first) : cross(first, second);
  const double error = 8.6 * unit * size_of(first) * size_of(second) + tiny;
  size_ = size_of(normal_) + error;
  side_bound_ = 3.1 * error + 12.5 * unit * size_;
}

SignedPlane SignedPlane::through(const Point3& a, const Point3& b, const Point3& c) {
  return {{a, b, c}, false};
}

SignedPlane SignedPlane::along(const Point3& a, const Point3& b, const Point3& direction) {
  return {{a, b, direction}, true};
}

SignedPlane SignedPlane::reversed() const {
  SignedPlane result = *this;
  result.is_reversed_ = !is_reversed_;
  result.normal_ = {-normal_.x, -normal_.y, -normal_.z};
  return result;
}

int SignedPlane::exact_side(const Point3& p) const {
  const int side = is_along_ ? exact_direction_side(points_[0], points_[1], p, points_[2])
                             : exact_orientation(points_[0], points_[1], points_[2], p);
  return is_reversed_ ? -side : side;
}

/// Bound. Rounding the point moves it by u of its size along each axis.
int SignedPlane::side(const Point3& near, const ExactVector& p) const {
  const Vector step = near - points_[0];
  const double value = dot(normal_, step);
  const double moved = 4 * unit * std::max({std::fabs(near.x), std::fabs(near.y), std::fabs(near.z)}) * size_;
  const double bound = side_bound_ * size_of(step) + moved + tiny;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return exact_plane().height(p).sign();
}

ExactPlane SignedPlane::exact_plane() const {
  const ExactVector origin = exact(points_[0]);
  const ExactVector first = exact(points_[1]) - origin;
  const ExactVector second = is_along_ ? exact(points_[2]) : exact(points_[2]) - origin;
  ExactVector normal = is_along_ ? cross(second, first) : cross(first, second);
  if (is_reversed_) normal = Rational(-1) * normal;
  return {normal, -dot(normal, origin)};
}

Fragment fragment_of(std::span<const Point3> corners) {
  Fragment fragment;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    fragment.push_back({exact(corners[k]), corners[k], static_cast<std::int32_t>(k)});
  }
  return fragment;
}

SplitFragment split(const Fragment& fragment, const SignedPlane& plane) {
  std::vector<int> sides;
  for (const FragmentCorner& corner : fragment) sides.push_back(plane.side(corner.near, corner.point));
  const auto has = [&](int side) { return std::find(sides.begin(), sides.end(), side) != sides.end(); };
  SplitFragment result;
  std::optional<ExactPlane> exact_plane;
  for (const int kept : {1, -1}) {
    if (!has(kept)) continue;
    Fragment& part = kept > 0 ? result.positive : result.negative;
    for (std::size_t k = 0; k < fragment.size(); ++k) {
      const std::size_t next = k + 1 == fragment.size() ? 0 : k + 1;
      const int here = sides[k] * kept, there = sides[next] * kept;
      // Along the plane, and where the way leaves to the other side, it is the plane that bounds the part.
      if (here >= 0)
        part.push_back({fragment[k].point, fragment[k].near, here == 0 && there <= 0 ? -1 : fragment[k].edge});
      if (here * there >= 0) continue;
      if (!exact_plane) exact_plane = plane.exact_plane();
      const ExactVector p = crossing(*exact_plane, fragment[k].point, fragment[next].point);
      part.push_back(corner_at(p, here > 0 ? -1 : fragment[k].edge));
    }
  }
  return result;
}

}  // namespace gnomon::viewpoint
