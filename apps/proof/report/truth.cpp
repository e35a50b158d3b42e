#include "apps/proof/report/truth.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/visibility/visible_fraction.h"
#include "geometry/visibility/visible_part.h"
#include "shading/reference_irradiance.h"

namespace gnomon::report {
namespace {

/// The visible pieces of facets that show their face, relative to the point.
std::vector<ExactView> views(const VisiblePart& part, bool two_sided, const ExactVector& p) {
  std::vector<ExactView> result;
  for (const VisibleFacet& seen : part.facets) {
    const Rational above = plane_through(seen.facet[0], seen.facet[1], seen.facet[2]).height(p);
    if (above == 0 || (above < 0 && !two_sided)) continue;
    for (const ExactPolygon& polygon : seen.visible) {
      result.emplace_back();
      for (const ExactVector& corner : polygon) {
        const ExactVector view = corner - p;
        result.back().push_back({view.x, view.y, view.z});
      }
    }
  }
  return result;
}

TrueValue irradiance_of(const VisiblePart& part, const AreaLight& light, const Point3& p, const Point3& normal,
                        int bits) {
  const ExactVector n = exact(normal);
  const IrradianceInterval found = reference_irradiance(views(part, light.two_sided, exact(p)), {n.x, n.y, n.z}, bits);
  return {found.low, found.high};
}

TrueValue fraction_of(const VisiblePart& part) {
  const VisibleFraction fraction = visible_fraction(part);
  if (fraction.exact && Rational(fraction.nearest) == *fraction.exact) return {fraction.nearest, fraction.nearest};
  return {std::nextafter(fraction.nearest, 0), std::nextafter(fraction.nearest, 1)};
}

}  // namespace

double TrueValue::error_of(double value) const {
  return std::fabs(value - (low + (high - low) / 2));
}

bool TrueValue::is_within(double value, double bound) const {
  return value - bound <= high && low <= value + bound;
}

VisibilityTruth visibility_truth(const AreaLight& light, const Obstacles& obstacles, const Point3& p,
                                 const Point3& normal, int bits) {
  const VisiblePart part = exact_visible_part(light, obstacles, p);
  return {part.region, fraction_of(part), irradiance_of(part, light, p, normal, bits)};
}

TrueValue true_irradiance(const AreaLight& light, const Obstacles& obstacles, const Point3& p, const Point3& normal,
                          int bits) {
  return irradiance_of(exact_visible_part(light, obstacles, p), light, p, normal, bits);
}

}  // namespace gnomon::report
