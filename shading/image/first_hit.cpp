#include "shading/image/first_hit.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/numbers/orientation.h"
#include "geometry/numbers/rounding.h"
#include "shading/reflection/space.h"

namespace gnomon::image {
namespace {

using shading::Bounded;
using shading::certain_sign;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Triangle {
  std::uint32_t facet, number;
};

Kernel::Point_3 cgal(const Point3& p) {
  return {p.x, p.y, p.z};
}

template <class Number>
Number height_ratio(const Vector3<Number>& normal, const Vector3<Number>& to_plane, const Vector3<Number>& along) {
  return dot(normal, to_plane) / dot(normal, along);
}

Vector3<Bounded> bounded_step(const Point3& from, const Point3& to) {
  const auto difference = [](double a, double b) {
    const double d = b - a;
    return Bounded(d, shading::unit * std::fabs(d));
  };
  return {difference(from.x, to.x), difference(from.y, to.y), difference(from.z, to.z)};
}

/// Where along the ray a facet's plane is met: 0 at the eye, 1 at the point that it goes through.
class RayParameter {
 public:
  RayParameter(const Ray& ray, const std::array<Point3, 3>& corners) : ray_(&ray), corners_(corners) {
    const Vector3<Bounded> normal = cross(bounded_step(corners[0], corners[1]), bounded_step(corners[0], corners[2]));
    quick_ = height_ratio(normal, bounded_step(ray.eye, corners[0]), bounded_step(ray.eye, ray.through));
    if (!(shading::final_bound(quick_) < HUGE_VAL)) quick_ = Bounded(0, HUGE_VAL);
  }

  /// The sign of the difference to another one.
  int compared_to(const RayParameter& other) const {
    const int sign = certain_sign(quick_ - other.quick_);
    return sign == 1 || sign == -1 ? sign : Rational(exact() - other.exact()).sign();
  }
  double value() const {
    const bool is_good = shading::final_bound(quick_) <= 1e-13 * std::fabs(quick_.value);
    return is_good ? quick_.value : nearest_double(exact());
  }

 private:
  Rational exact() const {
    const ExactVector a = gnomon::exact(corners_[0]), o = gnomon::exact(ray_->eye);
    const ExactVector normal = cross(gnomon::exact(corners_[1]) - a, gnomon::exact(corners_[2]) - a);
    return Rational(dot(normal, a - o) / dot(normal, gnomon::exact(ray_->through) - o));
  }

  const Ray* ray_;
  std::array<Point3, 3> corners_;
  Bounded quick_;
};

/// Twice the areas of the triangles between a point and the sides, as seen along the largest coordinate of a normal.
std::array<double, 3> shares_of(const std::array<Point3, 3>& corners, const Point3& p, const Point3& n) {
  const auto flat = [&](const Point3& q) -> std::array<double, 2> {
    if (std::fabs(n.x) >= std::fabs(n.y) && std::fabs(n.x) >= std::fabs(n.z)) return {q.y - p.y, q.z - p.z};
    if (std::fabs(n.y) >= std::fabs(n.z)) return {q.z - p.z, q.x - p.x};
    return {q.x - p.x, q.y - p.y};
  };
  std::array<double, 3> shares;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = flat(corners[(k + 1) % 3]), b = flat(corners[(k + 2) % 3]);
    shares[k] = std::fabs(a[0] * b[1] - a[1] * b[0]);
    sum += shares[k];
  }
  for (double& share : shares) share = sum > 0 ? share / sum : 1.0 / 3;
  return shares;
}

bool is_shown(const Facet& facet, bool is_front) {
  return !facet.light || is_front || std::get<AreaLight>(facet.light->shape).two_sided;
}

}  // namespace

class FirstHit::Work {
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

 public:
  explicit Work(std::span<const Facet> facets) : facets_(facets) {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const auto& p = facets[f].shape.points();
      for (std::size_t k = 0; k + 2 < p.size(); ++k) {
        // Corners may lie on a side: a triangle without area is met by nothing.
        const Kernel::Triangle_3 triangle(cgal(p[0]), cgal(p[k + 1]), cgal(p[k + 2]));
        if (triangle.is_degenerate()) continue;
        names_.push_back({static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(k)});
        triangles_.push_back(triangle);
      }
    }
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
  }

  std::optional<Hit> along(const Ray& ray) const {
    const Kernel::Ray_3 line(cgal(ray.eye), cgal(ray.through));
    std::vector<Triangles::const_iterator> met;
    tree_.all_intersected_primitives(line, std::back_inserter(met));
    std::optional<Found> nearest;
    for (const auto& triangle : met) {
      const Triangle name = names_[static_cast<std::size_t>(triangle - triangles_.begin())];
      const Facet& facet = facets_[name.facet];
      const std::array<Point3, 3> corners = corners_of(name);
      const int side = exact_orientation(corners[0], corners[1], corners[2], ray.eye);
      if (side == 0 || !is_shown(facet, side > 0)) continue;
      const Found found{name, side > 0, RayParameter(ray, corners)};
      if (!nearest || is_before(found, *nearest)) nearest = found;
    }
    if (!nearest) return std::nullopt;
    return hit(ray, *nearest);
  }

 private:
  struct Found {
    Triangle name;
    bool is_front;
    RayParameter parameter;
  };

  /// At one place a light comes first: it lies on what it is flush with.
  bool is_before(const Found& a, const Found& b) const {
    const int sign = a.parameter.compared_to(b.parameter);
    if (sign != 0) return sign < 0;
    const bool is_light = facets_[a.name.facet].light != nullptr, other_is = facets_[b.name.facet].light != nullptr;
    if (is_light != other_is) return is_light;
    return std::pair(a.name.facet, a.name.number) < std::pair(b.name.facet, b.name.number);
  }

  std::array<Point3, 3> corners_of(const Triangle& name) const {
    const auto& p = facets_[name.facet].shape.points();
    return {p[0], p[name.number + 1], p[name.number + 2]};
  }
  Hit hit(const Ray& ray, const Found& found) const {
    const double t = found.parameter.value();
    const auto at = [t](double a, double b) { return a + t * (b - a); };
    const Point3 place{at(ray.eye.x, ray.through.x), at(ray.eye.y, ray.through.y), at(ray.eye.z, ray.through.z)};
    return {found.name.facet, found.name.number, found.is_front, place,
            shares_of(corners_of(found.name), place, facets_[found.name.facet].normal)};
  }

  std::span<const Facet> facets_;
  Triangles triangles_;
  std::vector<Triangle> names_;
  Tree tree_;
};

FirstHit::FirstHit(std::span<const Facet> facets) : work_(std::make_unique<Work>(facets)) {}
FirstHit::FirstHit(FirstHit&&) noexcept = default;
FirstHit::~FirstHit() = default;

std::optional<Hit> FirstHit::along(const Ray& ray) const {
  return work_->along(ray);
}

}  // namespace gnomon::image
