#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>

#include "apps/proof/laws/any_pair.h"
#include "gnomon/pair.h"
#include "gnomon/shadow_volume.h"
#include "gnomon/visibility.h"
#include "tests/geometry/spatial/expected_region.h"

// The volumes of pairs that stand anywhere, against what points see by the definition.

namespace gnomon::laws {

void showValue(const AnyPair& pair, std::ostream& out) {
  out << description(pair);
}

}  // namespace gnomon::laws

namespace gnomon {
namespace {

using laws::AnyPair;
using laws::Domain;
using laws::PairBlockerKind;
using laws::PairLightKind;

void check_regions(Domain domain, PairLightKind light, PairBlockerKind blocker) {
  const AnyPair pair = *rc::gen::exec([=] { return laws::draw_any_pair(domain, light, blocker, 4); });
  const ShadowVolumes volumes = shadow_volumes(pair.light, pair.blocker);
  if (light != PairLightKind::direction) RC_TAG(std::string(name(pair_position(pair.light, pair.blocker))));
  const Obstacles obstacles{{pair.blocker}, {}};
  for (const Point3& p : pair.points) {
    if (is_on_blocker(pair.blocker, p)) continue;
    const Region seen = exact_visibility(pair.light, obstacles, p).region;
    if (seen == Region::unlit) continue;
    const std::optional<Region> expected = expected_region(pair.light, volumes, p);
    if (!expected) continue;
    RC_LOG() << "point " << p.x << ' ' << p.y << ' ' << p.z << ": volumes say " << name(*expected)
             << ", the definition says " << name(seen) << '\n';
    RC_ASSERT(*expected == seen);
  }
}

class AnyPositionAgreement : public testing::TestWithParam<laws::PairKinds> {};

TEST_P(AnyPositionAgreement, VolumesSayOfEveryPointWhatTheDefinitionSays) {
  const laws::PairKinds kinds = GetParam();
  EXPECT_TRUE(rc::check("random", [=] { check_regions(Domain::random, kinds.light, kinds.blocker); }));
  EXPECT_TRUE(
      rc::check("nearly degenerate", [=] { check_regions(Domain::near_degenerate, kinds.light, kinds.blocker); }));
}

INSTANTIATE_TEST_SUITE_P(Kinds, AnyPositionAgreement, testing::ValuesIn(laws::all_pair_kinds),
                         [](const auto& kinds) { return std::string(kinds.param.name); });

}  // namespace
}  // namespace gnomon
