#include "gnomon/visibility.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "apps/proof/laws/visibility_cases.h"
#include "tests/geometry/visibility/definition_check.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::LightKind;
using laws::VisibilityCase;

void check_against_definition(const VisibilityCase& drawn) {
  const Visibility got = exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point);
  RC_TAG(std::string(name(got.region)));
  if (const auto difference = disagreement(drawn, got)) RC_FAIL(*difference + "\n" + description(drawn));
}

struct Kinds {
  const char* name;
  LightKind light;
  BlockerKind blocker;
};

class VisibilityAgreement : public testing::TestWithParam<Kinds> {
 protected:
  void run(Domain domain) const {
    const laws::VisibilityMix mix{{GetParam().light}, {GetParam().blocker}, 2};
    EXPECT_TRUE(rc::check([&] { check_against_definition(*laws::visibility_cases(domain, mix).as("case")); }));
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
