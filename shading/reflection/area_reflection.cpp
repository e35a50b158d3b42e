#include "shading/reflection/area_reflection.h"

#include <algorithm>

#include "shading/reflection/boundary_cut.h"

namespace gnomon::shading {
namespace {

/// Peaks are those of the solid angle, roughly; the sum of axes times angles is short of it by its curvature only.
template <class Number>
double solid_angle_about(const std::vector<Arc<Number>>& arcs) {
  Vector sum;
  for (const Arc<Number>& arc : arcs) sum = sum + middle(arc.angle) / 2 * middle_of(arc.axis);
  return length(sum);
}

double lobe_peak_of(double solid_angle, const Lobe& lobe) {
  return std::fmin(solid_angle, 2 * std::numbers::pi / (lobe.exponent + 1.0));
}

/// `whole` is the solid angle of all that is seen: slivers beside the rest need no digits of their own.
template <class Number>
Integrals<Number> integrals(const VisibleBoundary<Number>& seen, const Directions<Number>& view, const Lobe& lobe,
                            double whole) {
  Integrals<Number> sums;
  sums.received = area_diffuse(seen, view.normal);
  sums.received_peak = solid_angle_about(seen.above_horizon);
  sums.lobe_peak = lobe_peak_of(sums.received_peak, lobe);
  sums.lobe = area_lobe(seen, view, lobe, lobe_peak_of(whole, lobe));
  return sums;
}

/// What of a polygon lies on a vector's side; corners are relative to the point.
ExactPolygon cut_before(const ExactPolygon& polygon, const ExactVector& axis) {
  ExactPolygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ExactVector& a = polygon[k];
    const ExactVector& b = polygon[(k + 1) % polygon.size()];
    const Rational from = dot(axis, a), to = dot(axis, b);
    if (from >= 0) result.push_back(a);
    if (from.sign() * to.sign() >= 0) continue;
    result.push_back(a + Rational(from / (from - to)) * (b - a));
  }
  return result;
}

/// Visible polygons relative to the point, counterclockwise seen from outside of the sphere of directions.
std::vector<ExactPolygon> relative_polygons(std::span<const VisibleFacet> facets, bool two_sided,
                                            const ExactVector& p) {
  std::vector<ExactPolygon> result;
  for (const VisibleFacet& seen : facets) {
    const int side = plane_through(seen.facet[0], seen.facet[1], seen.facet[2]).height(p).sign();
    if (side == 0 || (side < 0 && !two_sided)) continue;
    for (const ExactPolygon& visible : seen.visible) {
      ExactPolygon polygon;
      for (const ExactVector& corner : visible) polygon.push_back(corner - p);
      if (side > 0) std::reverse(polygon.begin(), polygon.end());
      result.push_back(std::move(polygon));
    }
  }
  return result;
}

/// Lengths do not matter: with a largest coordinate of 1.
ExactVector shortened(const ExactVector& v) {
  const Rational x = abs(v.x), y = abs(v.y), z = abs(v.z);
  return Rational(1 / std::max(std::max(x, y), z)) * v;
}

template <class Number>
void add_arcs(std::vector<Arc<Number>>& arcs, const ExactPolygon& polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ExactVector a = shortened(polygon[k]), b = shortened(polygon[(k + 1) % polygon.size()]);
    const ExactVector axis = cross(a, b);
    if (is_zero(axis)) continue;
    const Vector3<Number> u = vector_of<Number>(a), v = vector_of<Number>(b), m = vector_of<Number>(axis);
    const Number angle = atan2(norm(m), number_of<Number>(dot(a, b)));
    arcs.push_back({unit_of(u), unit_of(v), unit_of(m), angle});
  }
}

/// Polygons above the horizon, and what of them lies before the mirrored eye's plane.
struct ExactViews {
  std::vector<ExactPolygon> above_horizon, before_mirror;
};

ExactViews exact_views(std::span<const VisibleFacet> facets, bool two_sided, const ReflectionQuery& query) {
  ExactViews views;
  const ExactVector normal = exact(query.normal), mirror = exact_mirror(query);
  for (const ExactPolygon& polygon : relative_polygons(facets, two_sided, exact(query.point))) {
    views.above_horizon.push_back(cut_before(polygon, normal));
    views.before_mirror.push_back(cut_before(views.above_horizon.back(), mirror));
  }
  return views;
}

template <class Number>
Integrals<Number> integrals(const ExactViews& views, const ReflectionQuery& query) {
  const Directions<Number> view = directions<Number>(query.normal, query.to_eye);
  std::vector<VisibleBoundary<Number>> boundaries(views.above_horizon.size());
  double whole = 0;
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    add_arcs(boundaries[k].above_horizon, views.above_horizon[k]);
    add_arcs(boundaries[k].before_mirror, views.before_mirror[k]);
    whole += solid_angle_about(boundaries[k].above_horizon);
  }
  Integrals<Number> sums;
  for (const VisibleBoundary<Number>& seen : boundaries) {
    const Integrals<Number> part = integrals(seen, view, query.lobe, whole);
    sums.received = sums.received + part.received;
    sums.lobe = sums.lobe + part.lobe;
    sums.received_peak += part.received_peak;
    sums.lobe_peak = std::fmax(sums.lobe_peak, part.lobe_peak);
  }
  return sums;
}

}  // namespace

std::optional<Reflection> area_reflection(const VisibleAreaLight& seen, const ReflectionQuery& query) {
  const Directions<Bounded> view = directions<Bounded>(query.normal, query.to_eye);
  const std::optional<VisibleBoundary<Bounded>> boundary = cut_boundary(seen, view);
  if (!boundary) return std::nullopt;
  const Integrals<Bounded> sums = integrals(*boundary, view, query.lobe, solid_angle_about(boundary->above_horizon));
  if (!is_narrow(sums)) return std::nullopt;
  return reflection(sums, 0);
}

Reflection area_reflection(std::span<const VisibleFacet> facets, bool two_sided, const ReflectionQuery& query) {
  const ExactViews views = exact_views(facets, two_sided, query);
  const auto ask = [&]<class Number>(const Number&) { return integrals<Number>(views, query); };
  return with_rising_precision(ask, 0);
}

}  // namespace gnomon::shading
