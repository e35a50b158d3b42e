#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "apps/laws/flatland_claims.h"
#include "apps/laws/flatland_laws.h"
#include "apps/laws/planar_laws.h"
#include "geometry/planar/partition_data.h"

// The laws of the plane can fail too: every test breaks the subject in one way and names laws that see it.

namespace gnomon::laws {
namespace {

using planar::ExtremalLine;
using planar::ShadowRegions;
using Lines = std::array<ExtremalLine, 4>;

Subject with_lines(void (*break_them)(Lines&)) {
  Subject subject;
  subject.planar_extremal_lines = [=](const planar::Pair& pair) {
    Lines lines = planar::extremal_lines(pair);
    break_them(lines);
    return lines;
  };
  return subject;
}

Subject with_regions(void (*break_them)(ShadowRegions&)) {
  Subject subject;
  subject.planar_regions = [=](const planar::Pair& pair) {
    ShadowRegions regions = planar::shadow_regions(pair);
    break_them(regions);
    return regions;
  };
  return subject;
}

Subject with_region_of(Region (*broken)(Region)) {
  Subject subject;
  subject.planar_region_of = [=](const planar::Pair& pair, const Point2& p) {
    return broken(planar::region_of(pair, p));
  };
  return subject;
}

/// True if each of the laws finds a counterexample within 1,000 cases of either domain.
testing::AssertionResult caught(const Subject& subject, const std::vector<std::string>& keys) {
  std::size_t tried = 0;
  std::vector<Law> laws = planar_laws();
  for (const auto& family : {flatland_laws(), flatland_claims()}) laws.insert(laws.end(), family.begin(), family.end());
  for (const Law& law : laws) {
    if (std::ranges::find(keys, law.key) == keys.end()) continue;
    ++tried;
    for (const Domain domain : {Domain::random, Domain::near_degenerate}) {
      if (law.run(domain, {.cases = 1000, .subject = subject}).counterexample) continue;
      return testing::AssertionFailure() << law.key << " holds on " << name(domain) << " cases";
    }
  }
  return tried == keys.size() ? testing::AssertionSuccess() : testing::AssertionFailure() << "no such law";
}

TEST(PlanarLawsCatch, SeparatingAndSupportingLinesExchanged) {
  const Subject subject = with_lines([](Lines& lines) {
    for (ExtremalLine& line : lines) {
      line.contact = line.contact == Contact::separating ? Contact::supporting : Contact::separating;
    }
  });
  EXPECT_TRUE(caught(subject, {"P1", "P2", "P3", "P4", "P7", "P9"}));
}

TEST(PlanarLawsCatch, OneLineThroughTheWrongEndOfTheBlocker) {
  const Subject separating = with_lines([](Lines& lines) { lines[0].blocker_end = lines[1].blocker_end; });
  EXPECT_TRUE(caught(separating, {"P1", "P2"}));
  const Subject supporting = with_lines([](Lines& lines) { lines[2].blocker_end = lines[3].blocker_end; });
  EXPECT_TRUE(caught(supporting, {"P4", "P7"}));
}

TEST(PlanarLawsCatch, AnUmbraWithoutItsLastSide) {
  const Subject subject = with_regions([](ShadowRegions& regions) {
    if (!regions.umbra.empty()) regions.umbra.pieces.front().sides.pop_back();
  });
  EXPECT_TRUE(caught(subject, {"P4", "P7", "P8"}));
}

TEST(PlanarLawsCatch, APieceTurnedAround) {
  const Subject penumbra = with_regions([](ShadowRegions& regions) {
    if (regions.penumbra.empty()) return;
    auto& side = regions.penumbra.pieces.back().sides.back();
    std::swap(side.from, side.to);
  });
  EXPECT_TRUE(caught(penumbra, {"P3", "P8"}));
  const Subject lit = with_regions([](ShadowRegions& regions) {
    if (regions.lit.empty()) return;
    auto& side = regions.lit.pieces.back().sides.back();
    std::swap(side.from, side.to);
  });
  EXPECT_TRUE(caught(lit, {"P2", "P8", "P10"}));
}

TEST(PlanarLawsCatch, AMissingPieceOfThePenumbra) {
  const Subject subject = with_regions([](ShadowRegions& regions) {
    if (!regions.penumbra.empty()) regions.penumbra.pieces.pop_back();
  });
  EXPECT_TRUE(caught(subject, {"P3", "P8"}));
}

TEST(PlanarLawsCatch, WrongCounts) {
  const Subject umbra = with_regions([](ShadowRegions& regions) { regions.umbra.components += 1; });
  EXPECT_TRUE(caught(umbra, {"P5", "P7", "P8", "P9", "P10"}));
  const Subject penumbra = with_regions([](ShadowRegions& regions) { regions.penumbra.components += 1; });
  EXPECT_TRUE(caught(penumbra, {"P6", "P7", "P8", "P9", "P10"}));
}

TEST(PlanarLawsCatch, AnUmbraTakenForPenumbra) {
  const Subject subject =
      with_region_of([](Region region) { return region == Region::umbra ? Region::penumbra : region; });
  EXPECT_TRUE(caught(subject, {"P1", "P8", "P9", "P10"}));
}

TEST(PlanarLawsCatch, ABlockerThatIsForgotten) {
  Subject subject;
  subject.planar_visible_light = [](const planar::Flatland& flatland, const Point2& p) {
    const auto& all = flatland.blockers();
    const auto some = planar::Flatland::from_points(flatland.light(), std::span(all).first(all.size() - 1));
    return planar::Sight(some).visible_light(p);
  };
  EXPECT_TRUE(caught(subject, {"Q1", "Q2", "Q3", "Q4", "Q6", "F3", "F5"}));
}

TEST(PlanarLawsCatch, ACommonPenumbraTakenForUmbra) {
  Subject subject;
  subject.planar_visible_light = [](const planar::Flatland& flatland, const Point2& p) {
    planar::VisibleLight seen = planar::Sight(flatland).visible_light(p);
    if (seen.region == Region::penumbra) seen.region = Region::umbra;
    return seen;
  };
  EXPECT_TRUE(caught(subject, {"Q2", "Q3", "F3", "F4"}));
}

TEST(PlanarLawsCatch, EventsNamedByOtherPoints) {
  Subject subject;
  subject.planar_partition = [](const planar::Flatland& flatland) {
    auto data = planar::partition(planar::Sight(flatland)).data();
    for (planar::BoundaryName& name : data.names) name.far = {planar::EventPointKind::blocker_end, 0, 0};
    return planar::Partition(std::make_shared<const planar::Partition::Data>(std::move(data)));
  };
  EXPECT_TRUE(caught(subject, {"Q5"}));
}

TEST(PlanarLawsCatch, AnException) {
  Subject subject;
  subject.planar_regions = [](const planar::Pair&) -> ShadowRegions { throw std::runtime_error("broken"); };
  EXPECT_TRUE(caught(subject, {"P2", "P3", "P4", "P5", "P6", "P7", "P8", "P9", "P10"}));
}

}  // namespace
}  // namespace gnomon::laws
