#include "apps/proof/report/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "apps/proof/report/divided_blockers.h"
#include "apps/proof/report/pareto.h"
#include "apps/proof/report/shapes.h"
#include "gnomon/visibility.h"

namespace gnomon::report {
namespace {

const HardCase& called(const std::vector<HardCase>& cases, const std::string& name) {
  const auto found = std::ranges::find(cases, name, &HardCase::name);
  if (found == cases.end()) throw std::out_of_range(name);
  return *found;
}

Region region_at_focus(const HardCase& hard) {
  return exact_visibility(hard.light, {hard.blockers, {}}, hard.focus).region;
}

TEST(HardCases, AnUlpMakesTheDifference) {
  const std::vector<HardCase> cases = hard_cases();
  for (const std::string event :
       {"separating_blocker_plane", "separating_light_plane", "vertex_and_vertex", "aligned_edges"}) {
    EXPECT_EQ(region_at_focus(called(cases, event + "_exact")), Region::lit) << event;
    EXPECT_EQ(region_at_focus(called(cases, event + "_one_ulp_out")), Region::penumbra) << event;
    EXPECT_EQ(region_at_focus(called(cases, event + "_one_ulp_in")), Region::lit) << event;
  }
  EXPECT_EQ(region_at_focus(called(cases, "supporting_blocker_plane_exact")), Region::umbra);
  EXPECT_EQ(region_at_focus(called(cases, "supporting_blocker_plane_one_ulp_in")), Region::penumbra);
  EXPECT_EQ(region_at_focus(called(cases, "light_plane_exact")), Region::unlit);
  EXPECT_NE(region_at_focus(called(cases, "light_plane_one_ulp_below")), Region::unlit);
  EXPECT_EQ(region_at_focus(called(cases, "abutting_blockers")), Region::umbra);
  EXPECT_EQ(region_at_focus(called(cases, "gap_of_one_ulp")), Region::penumbra);
  EXPECT_EQ(region_at_focus(called(cases, "triple_edge_exact")), Region::umbra);
  EXPECT_EQ(region_at_focus(called(cases, "triple_edge_one_ulp_out")), Region::penumbra);
}

TEST(HardCases, HaveDifferentNamesAndPointsThatAreTheSameEachTime) {
  std::set<std::string> names;
  for (const HardCase& hard : hard_cases()) {
    EXPECT_TRUE(names.insert(hard.name).second) << hard.name;
    const std::vector<Point3> points = points_around(hard, 20);
    ASSERT_EQ(points.size(), 20u);
    EXPECT_EQ(points.front(), hard.focus);
    EXPECT_EQ(points, points_around(hard, 20));
  }
  EXPECT_GE(names.size(), 40u);
}

std::size_t corners(const ConvexBlocker& blocker) {
  return std::visit([](const auto& shape) { return shape.corners().size(); }, blocker);
}

TEST(DividedBlockers, HideWhatTheWholeOnesHide) {
  HardCase hard{"hundred_gon", "", square_light(1, 4), {}, {2, 0, 0}};
  hard.blockers = {ConvexPolygon::from_points(flat_round(100, 1, 2)), diamond(2, 1)};
  const std::vector<ConvexBlocker> pieces = divided(hard.blockers);
  EXPECT_EQ(pieces.size(), 7u);  // five corners, five pieces cut off, and the square, which stays
  for (const ConvexBlocker& piece : pieces) EXPECT_LE(corners(piece), 21u);
  EXPECT_EQ(corners(pieces.back()), 4u);
  const double half_an_ulp_of_one = 0x1p-53;
  for (const Point3& p : points_around(hard, 40)) {
    const Visibility whole = exact_visibility(hard.light, {hard.blockers, {}}, p);
    const Visibility divided = exact_visibility(hard.light, {pieces, {}}, p);
    EXPECT_EQ(divided.region, whole.region);
    EXPECT_NEAR(divided.fraction, whole.fraction, half_an_ulp_of_one);
  }
}

Measurement measurement(const std::string& method, std::size_t samples, double seconds, double rms) {
  Measurement m;
  m.task = "irradiance";
  m.method = method;
  m.size = 1;
  m.samples = samples;
  m.seconds = {seconds, seconds, seconds};
  m.errors.rms = rms;
  m.errors.relative_rms = rms;
  m.errors.largest = 0.1;
  return m;
}

TEST(ParetoFront, HoldsWhatNothingElseBeatsInBoth) {
  const std::vector<Measurement> all = {measurement("slow", 0, 3, 1e-3), measurement("fast", 0, 1, 1e-2),
                                        measurement("beaten", 0, 2, 1e-1), measurement("best", 0, 4, 0)};
  std::vector<std::string> names;
  for (const Measurement& m : pareto_front(all)) names.push_back(m.method);
  EXPECT_EQ(names, (std::vector<std::string>{"fast", "slow", "best"}));
}

TEST(Equivalents, AreFoundBetweenTheNumbersMeasured) {
  const std::vector<Measurement> all = {measurement("gnomon", 0, 1e-6, 1e-16),
                                        measurement("embree_regular", 4, 1e-7, 1e-1),
                                        measurement("embree_regular", 400, 1e-5, 1e-3)};
  const std::vector<Equivalent> found = equivalents(all);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].samples, 40, 1e-9);
  EXPECT_NEAR(found[0].rms, 1e-2, 1e-12);
  EXPECT_NEAR(*seconds_for_error(all, all[1], ErrorScale::own_value, 1e-2), 1e-6, 1e-15);
  EXPECT_NEAR(*seconds_for_error(all, all[1], ErrorScale::largest_value, 1e-1), 1e-6, 1e-15);
}

}  // namespace
}  // namespace gnomon::report
