#pragma once

/// Lights and blockers as seen from the apex: convex silhouettes of rays and planes. Private to this folder.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/visibility/viewpoint_rays.h"

namespace gnomon::viewpoint {

/// A box on the light's plane, in two of its coordinates; closed, and large enough whatever was rounded.
struct FlatBox {
  double low_u = HUGE_VAL;
  double low_v = HUGE_VAL;
  double high_u = -HUGE_VAL;
  double high_v = -HUGE_VAL;

  void include(const FlatBox& other) {
    low_u = std::min(low_u, other.low_u);
    low_v = std::min(low_v, other.low_v);
    high_u = std::max(high_u, other.high_u);
    high_v = std::max(high_v, other.high_v);
  }
  void cut(const FlatBox& other) {
    low_u = std::max(low_u, other.low_u);
    low_v = std::max(low_v, other.low_v);
    high_u = std::min(high_u, other.high_u);
    high_v = std::min(high_v, other.high_v);
  }
  bool meets(const FlatBox& other) const {
    return (low_u <= other.high_u) & (other.low_u <= high_u) & (low_v <= other.high_v) & (other.low_v <= high_v);
  }
};

/// The light's plane in front of the apex: depth grows from 0 at the apex to `height` on the plane.
struct LightPlane {
  Vector normal;
  double size = 0;
  double error = 0;  ///< of each coordinate of the normal
  double height = 0;
  double height_error = 0;
  double height_doubt = 0;  ///< at least the relative error of the height; infinite if it may be more than a quarter
  int u = 0;                ///< the two coordinates that are kept where the plane is looked at as flat
  int v = 1;
  double origin_u = 0;  ///< of the flat coordinates, relative to the apex: the point that gave the height
  double origin_v = 0;
  double origin_size = 0;  ///< at least their absolute values

  double depth(const Vector& direction) const { return dot(normal, direction); }

  /// At least the error of depth(), for a direction of this size whose coordinates are off by `direction_error`.
  double depth_error(double direction_size, double direction_error) const {
    return 3.1 * (size * direction_error + error * direction_size) + 9.5 * unit * size * direction_size + tiny;
  }
};

/// The plane through three points; no height.
LightPlane light_plane(const Point3& a, const Point3& b, const Point3& c);

/// Of a vector or a point.
template <class Triple>
double coordinate(const Triple& a, int axis) {
  return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

/// Gives the plane its height over the apex, from which `to_plane` leads to a point of it: the origin of flat
/// coordinates.
inline void set_height(LightPlane& plane, const Vector& to_plane) {
  const double size = size_of(to_plane);
  plane.height = plane.depth(to_plane);
  plane.height_error = plane.depth_error(size, unit * size);
  plane.height_doubt = plane.height > 4 * plane.height_error ? 1.5 * plane.height_error / plane.height : HUGE_VAL;
  plane.origin_u = coordinate(to_plane, plane.u);
  plane.origin_v = coordinate(to_plane, plane.v);
  plane.origin_size = size;
}

/// A point of the light's plane in the two kept coordinates, relative to a point of the plane.
/// Exactness: each coordinate is off by at most `error`, which may be infinite, and is no less than the coordinate's
///            rounding.
struct FlatPoint {
  double u = 0;
  double v = 0;
  double error = HUGE_VAL;

  /// Holds the exact point, whatever is rounded here.
  FlatBox box() const {
    const double e = 2 * error;
    return {u - e, v - e, u + e, v + e};
  }
};

/// One silhouette: the rays and planes `first` to `first + count` of an Silhouettes.
///
/// Orientation: the positive side of every plane holds the silhouette; plane k runs from ray k to ray k + 1.
///              No three consecutive rays lie in one plane.
struct Silhouette {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t element = 0;  ///< index of the blocker
  bool inside = false;        ///< certainly inside the light as seen, strictly: no edge meets one of the light's
  FlatBox box;                ///< cut to the light's, which is all that matters
  bool reversed = false;      ///< of a flat blocker: its corners run the other way

  std::uint32_t before(std::uint32_t k) const { return k == 0 ? count - 1 : k - 1; }
  std::uint32_t after(std::uint32_t k) const { return k + 1 == count ? 0 : k + 1; }
  /// Which of a flat blocker's edges runs from ray k to the next.
  std::uint32_t original(std::uint32_t k) const { return reversed ? count - 1 - after(k) : k; }
};

/// Silhouettes in one piece of memory that is used again for the next apex. The first is the light's.
struct Silhouettes {
  std::vector<Ray> rays;
  std::vector<Plane> planes;
  std::vector<FlatPoint> flats;  ///< where each ray meets the light's plane
  std::vector<Silhouette> list;
  std::vector<Plane> sides;  ///< of a linear light's pyramid; the first two are the light's planes
  /// On which side of the pyramid's planes the rays of a silhouette run: row by row from first * (number of planes),
  /// one row for a plane. The light's own are not filled in.
  std::vector<std::int8_t> at_pyramid;
  /// On which side of each plane the light's rays run, one row for a plane. Not filled in for the light's own and for
  /// silhouettes inside the light.
  std::vector<std::int8_t> of_light;

  void clear() {
    sides.clear();
    rays.clear();
    planes.clear();
    flats.clear();
    list.clear();
  }
  const std::int8_t* sides_at_pyramid(const Silhouette& o, std::size_t plane) const {
    return at_pyramid.data() + o.first * pyramid().size() + plane * o.count;
  }
  const std::int8_t* sides_of_light(std::size_t plane) const { return of_light.data() + plane * list.front().count; }
  /// The sides of the pyramid over the light, positive side inside.
  std::span<const Plane> pyramid() const {
    return sides.empty() ? planes_of(list.front()) : std::span<const Plane>(sides);
  }
  std::span<const Ray> rays_of(const Silhouette& o) const { return {rays.data() + o.first, o.count}; }
  std::span<const Plane> planes_of(const Silhouette& o) const { return {planes.data() + o.first, o.count}; }
};

/// Where a direction meets the light's plane.
/// Bound. The quotient height / depth has the relative error of both and three roundings; the product with a coordinate
/// adds one, and the coordinate's own error is scaled along. The origin is off by u of its size and the difference by u
/// of both.
inline FlatPoint meeting_point(const LightPlane& plane, const Vector& direction, double size, double error) {
  const double depth = plane.depth(direction);
  const double depth_error = plane.depth_error(size, error);
  if (!(depth > 4 * depth_error) || plane.height_doubt == HUGE_VAL) return {};
  const double inverse = 1 / depth;
  const double scale = plane.height * inverse;
  const double relative = 1.5 * depth_error * inverse + plane.height_doubt + 6 * unit;
  const double u = scale * coordinate(direction, plane.u);
  const double v = scale * coordinate(direction, plane.v);
  const double error_from_apex =
      (relative + unit) * std::max(std::fabs(u), std::fabs(v)) + 2 * unit * plane.origin_size;
  return {u - plane.origin_u, v - plane.origin_v, 1.01 * error_from_apex + 2 * scale * error};
}

/// An area light as one side shows it: counterclockwise as seen from the other, the plane's normal towards that.
struct LightSide {
  std::vector<Point3> corners;
  std::vector<std::uint32_t> names;  ///< of the edges that start at the corners
  std::vector<FlatPoint> flats;      ///< of the corners, relative to the first
  FlatBox box;                       ///< of the flats
  LightPlane plane;                  ///< with its height over the apex of the question
};

}  // namespace gnomon::viewpoint
