#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "apps/laws/law.h"

// The laws are worth nothing unless they can fail: every test breaks the subject in one way and names a law that sees
// it.

namespace gnomon::laws {
namespace {

using BreakPlanes = void (*)(ExtremalPlanes&);
using BreakVolumes = void (*)(ShadowVolumes&);

Subject with_planes(BreakPlanes break_them) {
  Subject subject;
  subject.extremal_planes = [=](const Light& light, const ConvexPolygon& blocker) {
    ExtremalPlanes planes = extremal_planes(light, blocker);
    break_them(planes);
    return planes;
  };
  return subject;
}

Subject with_volumes(BreakVolumes break_them) {
  Subject subject;
  subject.shadow_volumes = [=](const Light& light, const ConvexBlocker& blocker) {
    ShadowVolumes volumes = shadow_volumes(light, blocker);
    break_them(volumes);
    return volumes;
  };
  return subject;
}

/// True if each of the laws finds a counterexample within 1,000 cases of either domain.
testing::AssertionResult caught(const Subject& subject, const std::vector<std::string>& keys) {
  for (const Law& law : all_laws()) {
    if (std::ranges::find(keys, law.key) == keys.end()) continue;
    for (const Domain domain : {Domain::random, Domain::near_degenerate}) {
      if (law.run(domain, {.cases = 1000, .subject = subject}).counterexample) continue;
      return testing::AssertionFailure() << law.key << " holds on " << name(domain) << " cases";
    }
  }
  return testing::AssertionSuccess();
}

void drop_last(ConvexVolume& volume) {
  volume.half_spaces.pop_back();
}

void drop_kind(ConvexVolume& volume, FacetKind kind) {
  std::erase_if(volume.half_spaces, [=](const HalfSpace& half_space) { return half_space.name.kind == kind; });
}

void turn_last(ConvexVolume& volume) {
  auto& plane = volume.half_spaces.back().plane;
  std::swap(plane[0], plane[1]);
}

TEST(LawsCatch, SeparatingAndSupportingPlanesExchanged) {
  const Subject subject =
      with_planes([](ExtremalPlanes& planes) { std::swap(planes.separating_blocker, planes.supporting_blocker); });
  EXPECT_TRUE(caught(subject, {"S2", "S7", "S10"}));
}

TEST(LawsCatch, AnotherLightVertexNamed) {
  const Subject subject = with_planes([](ExtremalPlanes& planes) {
    LightVertex& vertex = planes.separating_blocker.front().vertex;
    vertex = LightVertex{number(vertex) == 0 ? 1u : number(vertex) - 1};
  });
  EXPECT_TRUE(caught(subject, {"S2", "S10"}));
}

TEST(LawsCatch, AnotherBlockerVertexNamed) {
  const Subject subject = with_planes([](ExtremalPlanes& planes) {
    if (planes.separating_light.empty()) return;
    BlockerVertex& vertex = planes.separating_light.front().vertex;
    vertex = BlockerVertex{number(vertex) == 0 ? 1u : number(vertex) - 1};
  });
  EXPECT_TRUE(caught(subject, {"S3", "S10"}));
}

TEST(LawsCatch, AWrongTouchingVertexOfASupportingPlane) {
  const Subject subject = with_planes([](ExtremalPlanes& planes) {
    LightVertex& vertex = planes.supporting_blocker.front().vertex;
    vertex = LightVertex{number(vertex) == 0 ? 1u : number(vertex) - 1};
  });
  EXPECT_TRUE(caught(subject, {"S7", "S10"}));
}

TEST(LawsCatch, APlaneListedTwiceOrForgotten) {
  EXPECT_TRUE(caught(with_planes([](ExtremalPlanes& planes) { planes.supporting_blocker.pop_back(); }), {"S10"}));
  EXPECT_TRUE(caught(with_planes([](ExtremalPlanes& planes) {
                       if (!planes.separating_light.empty()) planes.separating_light.pop_back();
                     }),
                     {"S10"}));
  EXPECT_TRUE(caught(with_planes([](ExtremalPlanes& planes) {
                       planes.separating_blocker.push_back(planes.separating_blocker.back());
                     }),
                     {"S10"}));
}

TEST(LawsCatch, AHalfSpaceMissingFromTheOcclusionVolume) {
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { drop_last(v.occlusion); }), {"S1", "S4", "S5", "S6"}));
}

TEST(LawsCatch, LightPlanesMissingFromTheOcclusionVolume) {
  const Subject subject =
      with_volumes([](ShadowVolumes& v) { drop_kind(v.occlusion, FacetKind::separating_light_plane); });
  EXPECT_TRUE(caught(subject, {"S4", "S5", "S6"}));
}

TEST(LawsCatch, TheBlockersFaceMissing) {
  const Subject subject = with_volumes([](ShadowVolumes& v) {
    drop_kind(v.occlusion, FacetKind::blocker_face);
    drop_kind(v.umbra, FacetKind::blocker_face);
  });
  EXPECT_TRUE(caught(subject, {"S1", "S4", "S5", "S6", "S8", "S9"}));
}

TEST(LawsCatch, AHalfSpaceMissingFromTheUmbra) {
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { drop_last(v.umbra); }), {"S1", "S8", "S9"}));
}

TEST(LawsCatch, AHalfSpaceTurnedAround) {
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { turn_last(v.occlusion); }), {"S1", "S4", "S5", "S6"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { turn_last(v.umbra); }), {"S1", "S8", "S9"}));
}

TEST(LawsCatch, TheUmbraTakenForTheOcclusionVolumeAndTheOtherWayRound) {
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.occlusion = v.umbra; }), {"S4", "S5", "S6"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.umbra = v.occlusion; }), {"S8", "S9"}));
}

TEST(LawsCatch, WrongFacts) {
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.umbra_facts.bounded = true; }), {"S12"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.umbra_facts.bounded = false; }), {"S12"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.penumbra_facts.bounded = true; }), {"S13"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.penumbra_facts.empty = false; }), {"S13"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.penumbra_facts.components = 1; }), {"S14"}));
}

TEST(LawsCatch, BoundariesDecidedWithRoundedOrWidenedPlanes) {
  const auto rounded = [](ShadowVolumes& v) {
    for (ConvexVolume* volume : {&v.occlusion, &v.umbra}) {
      for (HalfSpace& half_space : volume->half_spaces) half_space.plane[2].z *= 1 + 0x1p-50;
    }
  };
  EXPECT_TRUE(caught(with_volumes(rounded), {"S1", "S4", "S5", "S6", "S8", "S9"}));
}

// In any position.

void drop_last_of(ConvexVolume& volume) {
  if (!volume.half_spaces.empty()) volume.half_spaces.pop_back();
}

TEST(LawsCatch, AHalfSpaceMissingInAnyPosition) {
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { drop_last_of(v.occlusion); }), {"S6_any"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { drop_last_of(v.umbra); }), {"S9_any"}));
}

TEST(LawsCatch, AnUmbraForgottenOrMadeUp) {
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.umbra.empty = true; }), {"S11"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.umbra.empty = false; }), {"S11"}));
}

TEST(LawsCatch, WrongFactsInAnyPosition) {
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.umbra_facts.bounded = true; }), {"S12_any"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.umbra_facts.bounded = false; }), {"S12_any"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.penumbra_facts.components = 1; }), {"S14_any"}));
  EXPECT_TRUE(caught(with_volumes([](ShadowVolumes& v) { v.umbra_pockets = 1; }), {"S15"}));
}

TEST(LawsCatch, AVolumeOfAPartTooLargeOrForgotten) {
  Subject subject;
  subject.convex_hull_shadow_volume = [](const Light& light, const ConvexBlocker& blocker) {
    ConvexVolume volume = convex_hull_shadow_volume(light, blocker);
    drop_last_of(volume);
    return volume;
  };
  EXPECT_TRUE(caught(subject, {"M4"}));
  subject.convex_hull_shadow_volume = [](const Light& light, const ConvexBlocker& blocker) {
    return std::holds_alternative<ConvexSolid>(blocker) ? ConvexVolume{{}, true}
                                                        : convex_hull_shadow_volume(light, blocker);
  };
  EXPECT_TRUE(caught(subject, {"M4"}));
}

}  // namespace
}  // namespace gnomon::laws
