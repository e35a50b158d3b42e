#include "tests/geometry/visibility/definition_check.h"

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <vector>

#include "apps/proof/laws/visibility_definition.h"

namespace gnomon {
namespace {

using laws::VisibilityCase;
using laws::Walls;
using Real = boost::multiprecision::mpfr_float_100;

std::vector<Walls> all_walls(const VisibilityCase& drawn) {
  std::vector<Walls> result;
  for (const ConvexBlocker& blocker : drawn.blockers) result.push_back(laws::walls(blocker));
  return result;
}

template <class Claim>
bool any_of(const std::vector<Walls>& blockers, Claim claim) {
  return std::any_of(blockers.begin(), blockers.end(), claim);
}

struct Expected {
  Region region;
  Real fraction;
};

Expected expected_share(const Rational& share) {
  return {share == 1 ? Region::lit : share == 0 ? Region::umbra : Region::penumbra, Real(share)};
}

Real norm(const laws::ExactVector& v) {
  return sqrt(Real(laws::dot(v, v)));
}

Expected expected_of_area(const ConvexPolygon& polygon, const std::vector<Walls>& blockers,
                          const laws::ExactVector& p) {
  const auto facets = laws::light_facets(polygon);
  if (facets.size() == 1) return expected_share(laws::visible_area_share(facets[0], blockers, p));
  Real visible = 0, whole = 0;
  bool all = true, none = true;
  for (const auto& facet : facets) {
    const Rational share = laws::visible_area_share(facet, blockers, p);
    const Real area = norm(laws::plane_of(facet).normal);
    visible += Real(share) * area;
    whole += area;
    all = all && share == 1;
    none = none && share == 0;
  }
  return {all ? Region::lit : none ? Region::umbra : Region::penumbra, visible / whole};
}

Expected expected(const VisibilityCase& drawn) {
  const std::vector<Walls> blockers = all_walls(drawn);
  const laws::ExactVector p = laws::exact(drawn.point);
  if (laws::is_unlit(drawn.light, p)) return {Region::unlit, 0};
  if (const auto* point = std::get_if<PointLight>(&drawn.light)) {
    const laws::ExactVector l = laws::exact(point->position);
    const auto strictly_inside = [&](const Walls& b) {
      return std::all_of(b.begin(), b.end(), [&](const auto& wall) { return wall.side(p) < 0; });
    };
    const bool hidden =
        any_of(blockers, [&](const Walls& b) { return laws::is_blocked(b, p, l) || strictly_inside(b); });
    return expected_share(hidden ? 0 : 1);
  }
  if (const auto* sun = std::get_if<DirectionalLight>(&drawn.light)) {
    const laws::ExactVector towards = Rational(-1) * laws::exact(sun->direction);
    const bool hidden = any_of(blockers, [&](const Walls& b) { return laws::is_blocked_towards(b, p, towards); });
    return expected_share(hidden ? 0 : 1);
  }
  if (const auto* linear = std::get_if<LinearLight>(&drawn.light)) {
    return expected_share(
        laws::visible_length_share(laws::exact(linear->start), laws::exact(linear->end), blockers, p));
  }
  return expected_of_area(std::get<AreaLight>(drawn.light).polygon, blockers, p);
}

}  // namespace

std::optional<std::string> disagreement(const VisibilityCase& drawn, const Visibility& got) {
  const Expected want = expected(drawn);
  if (got.region != want.region) return std::string(name(got.region)) + " for " + std::string(name(want.region));
  const auto error = [&](double value) { return Real(abs(Real(value) - want.fraction)); };
  // A hundred digits are enough to be sure of these.
  const Real doubt("1e-60");
  if (error(got.fraction) > Real(got.error_bound) + doubt) return "the error bound is too small";
  for (const double neighbour : {std::nextafter(got.fraction, 2.0), std::nextafter(got.fraction, -1.0)}) {
    if (error(got.fraction) > error(neighbour) + doubt) return "the fraction is not the nearest double";
  }
  return std::nullopt;
}

}  // namespace gnomon
