#include "geometry/visibility/visibility.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/multiprecision/mpfr.hpp>

#include "apps/laws/draw.h"
#include "apps/laws/sight.h"
#include "apps/laws/sight_cases.h"
#include "geometry/visibility/hidden_set.h"
#include "geometry/visibility/visible_part.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::LightKind;
using laws::SightCase;
using laws::Walls;
using Real = boost::multiprecision::mpfr_float_100;

std::vector<Walls> all_walls(const SightCase& drawn) {
  std::vector<Walls> result;
  for (const ConvexBlocker& blocker : drawn.blockers) result.push_back(laws::walls(blocker));
  return result;
}

template <class Claim>
bool any_of(const std::vector<Walls>& blockers, Claim claim) {
  return std::any_of(blockers.begin(), blockers.end(), claim);
}

/// What is expected, as a number of many digits, and exactly where it is rational.
struct Expected {
  Region region;
  Real fraction;
  std::optional<Rational> exact;
};

Expected expected_share(const Rational& share) {
  return {share == 1 ? Region::lit : share == 0 ? Region::umbra : Region::penumbra, Real(share), share};
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
  return {all ? Region::lit : none ? Region::umbra : Region::penumbra, visible / whole, std::nullopt};
}

Expected expected(const SightCase& drawn) {
  const std::vector<Walls> blockers = all_walls(drawn);
  const laws::ExactVector p = laws::exact(drawn.point);
  if (laws::is_unlit(drawn.light, p)) return {Region::unlit, 0, Rational(0)};
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

void check_against_definition(const SightCase& drawn) {
  const Expected want = expected(drawn);
  const Visibility got = exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point);
  RC_TAG(std::string(name(want.region)));
  if (got.region != want.region)
    RC_FAIL(std::string(name(got.region)) + " for " + std::string(name(want.region)) + "\n" + description(drawn));
  const Real error = abs(Real(got.fraction) - want.fraction);
  if (error > Real(got.error_bound) + Real("1e-60")) RC_FAIL("fraction\n" + description(drawn));
  // The nearest double, or as good as.
  const double above = std::nextafter(got.fraction, 2.0), below = std::nextafter(got.fraction, -1.0);
  RC_ASSERT(error <= abs(Real(above) - want.fraction) + Real("1e-50"));
  RC_ASSERT(error <= abs(Real(below) - want.fraction) + Real("1e-50"));
}

struct Kinds {
  const char* name;
  LightKind light;
  BlockerKind blocker;
};

class VisibilityAgreement : public testing::TestWithParam<Kinds> {
 protected:
  void run(Domain domain) const {
    const laws::SightMix mix{{GetParam().light}, {GetParam().blocker}, 2};
    EXPECT_TRUE(rc::check([&] { check_against_definition(*laws::sight_cases(domain, mix).as("case")); }));
  }
};

TEST_P(VisibilityAgreement, MatchesTheDefinitionOnRandomCases) {
  run(Domain::random);
}

TEST_P(VisibilityAgreement, MatchesTheDefinitionNearDegeneracy) {
  run(Domain::near_degenerate);
}

std::vector<Kinds> all_kinds() {
  using enum LightKind;
  return {{"PointBehindPolygons", point, BlockerKind::polygon},
          {"PointBehindSolids", point, BlockerKind::solid},
          {"PointBehindRoundedPolygons", point, BlockerKind::rounded_polygon},
          {"DirectionBehindPolygons", direction, BlockerKind::polygon},
          {"DirectionBehindSolids", direction, BlockerKind::solid},
          {"DirectionBehindRoundedPolygons", direction, BlockerKind::rounded_polygon},
          {"SegmentBehindPolygons", segment, BlockerKind::polygon},
          {"SegmentBehindSolids", segment, BlockerKind::solid},
          {"SegmentBehindRoundedPolygons", segment, BlockerKind::rounded_polygon},
          {"PolygonBehindPolygons", polygon, BlockerKind::polygon},
          {"PolygonBehindSolids", polygon, BlockerKind::solid},
          {"PolygonBehindRoundedPolygons", polygon, BlockerKind::rounded_polygon},
          {"RoundedPolygonBehindPolygons", rounded_polygon, BlockerKind::polygon},
          {"RoundedPolygonBehindSolids", rounded_polygon, BlockerKind::solid},
          {"RoundedPolygonBehindRoundedPolygons", rounded_polygon, BlockerKind::rounded_polygon}};
}

INSTANTIATE_TEST_SUITE_P(Kinds, VisibilityAgreement, testing::ValuesIn(all_kinds()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace gnomon
