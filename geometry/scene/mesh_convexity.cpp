#include "geometry/scene/mesh_convexity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/orientation.h"
#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

/// How much of the diameter counts as rounding, as for polygons.
const Rational& tolerance() {
  static const Rational value(1, 1'000'000'000);
  return value;
}

std::vector<Point3> used_vertices(std::span<const Point3> vertices,
                                  std::span<const std::vector<std::uint32_t>> facets) {
  std::vector<bool> used(vertices.size());
  for (const auto& facet : facets) {
    for (const std::uint32_t i : facet) used[i] = true;
  }
  std::vector<Point3> result;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (used[i]) result.push_back(vertices[i]);
  }
  return result;
}

/// The square of the diagonal of the box around the points.
Rational squared_diameter(std::span<const Point3> points) {
  Point3 low = points[0], high = points[0];
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const ExactVector d = exact(high) - exact(low);
  return dot(d, d);
}

/// Looks at planes, one after the other, until one has a vertex too far in front.
class Survey {
 public:
  explicit Survey(std::vector<Point3> points) : points_(std::move(points)) {
    filter_.include(points_);
    filter_.close();
    squared_limit_ = tolerance() * tolerance() * squared_diameter(points_);
    limit_ = std::sqrt(nearest_double(squared_limit_));
  }

  /// False if a vertex is too far on the positive side (`front` 1) or on the negative one (-1) of the plane.
  bool holds(const std::array<Point3, 3>& corners, int front) {
    const auto& [a, b, c] = corners;
    const OrientationFilter::Plane plane = filter_.plane(a, b, c);
    const Point3 normal = rough_normal(corners);
    for (const Point3& p : points_) {
      // Nearly all vertices are far behind.
      const double rough = front * (normal.x * (p.x - a.x) + normal.y * (p.y - a.y) + normal.z * (p.z - a.z));
      if (limit_ > 0 && rough < -limit_) continue;
      if (front * plane.side(p) > 0 && !tolerates(corners, p)) return false;
    }
    return true;
  }

  double deviation() const { return std::sqrt(nearest_double(squared_deviation_)); }

 private:
  /// Of about unit length; without one if the corners are too close to a line.
  static Point3 rough_normal(const std::array<Point3, 3>& corners) {
    const auto& [a, b, c] = corners;
    const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    const double size = std::sqrt(u.x * u.x + u.y * u.y + u.z * u.z) * std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    if (!(length > 1e-4 * size)) return {};
    return {n.x / length, n.y / length, n.z / length};
  }

  bool tolerates(const std::array<Point3, 3>& corners, const Point3& p) {
    const ExactPlane plane = plane_through(exact(corners[0]), exact(corners[1]), exact(corners[2]));
    const Rational height = plane.height(exact(p));
    const Rational squared = height * height / dot(plane.normal, plane.normal);
    if (squared > squared_limit_) return false;
    squared_deviation_ = std::max(squared_deviation_, squared);
    return true;
  }

  std::vector<Point3> points_;
  OrientationFilter filter_;
  Rational squared_limit_;
  double limit_ = 0;
  Rational squared_deviation_ = 0;
};

bool has_area(const std::array<Point3, 3>& corners) {
  return !is_zero(plane_through(exact(corners[0]), exact(corners[1]), exact(corners[2])).normal);
}

}  // namespace

std::optional<double> deviation_from_convex(std::span<const Point3> vertices,
                                            std::span<const std::vector<std::uint32_t>> facets) {
  const std::vector<Point3> used = used_vertices(vertices, facets);
  if (are_coplanar(used)) return std::nullopt;
  for (const int front : {1, -1}) {
    Survey survey(used);
    const bool convex = std::all_of(facets.begin(), facets.end(), [&](const auto& facet) {
      for (std::size_t k = 2; k < facet.size(); ++k) {
        const std::array<Point3, 3> corners = {vertices[facet[0]], vertices[facet[k - 1]], vertices[facet[k]]};
        if (has_area(corners) && !survey.holds(corners, front)) return false;
      }
      return true;
    });
    if (convex) return survey.deviation();
  }
  return std::nullopt;
}

}  // namespace gnomon
