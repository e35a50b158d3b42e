#include "apps/proof/report/targets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace gnomon::report {
namespace {

Timing timing(const std::string& task, std::size_t size, double seconds, std::size_t count = 0) {
  return {task, size, {seconds, seconds, seconds}, count, 0};
}

const Finding& about(const std::vector<Finding>& all, const std::string& subject) {
  const auto found = std::ranges::find(all, subject, &Finding::subject);
  if (found == all.end()) throw std::out_of_range(subject);
  return *found;
}

TEST(Targets, AreAllToldWithWhatMeasuresThemWhereARunDoesNot) {
  const Report nothing;
  for (const Finding& finding : findings(nothing)) EXPECT_TRUE(finding.is_promise) << finding.subject;
  const std::vector<Finding> others = unmeasured(nothing);
  EXPECT_GT(others.size(), 30u);
  for (const Finding& other : others) {
    EXPECT_FALSE(other.reached) << other.subject;
    EXPECT_THAT(other.command, testing::StartsWith("./bootstrap bench ")) << other.subject;
    EXPECT_THAT(other.command, testing::Not(testing::HasSubstr("|"))) << "in a table: " << other.subject;
  }
}

TEST(Targets, OfPairsAreScaledByWhatPlainDoublesTake) {
  const std::string subject = "extremal planes of 4 by 4 vertices";
  Report report;
  report.timings = {timing("plain_planes", 4, 272e-9), timing("exact_planes", 4, 599e-9)};
  EXPECT_EQ(about(findings(report), subject).wanted, "at most 600 ns");
  EXPECT_TRUE(about(findings(report), subject).reached);
  EXPECT_FALSE(about(findings(report), subject + ", beside the same walk in plain doubles").reached);
  report.timings[1] = timing("exact_planes", 4, 601e-9);
  EXPECT_FALSE(about(findings(report), subject).reached);
}

TEST(Targets, OfReflectionTellHowManyPointsOnTheLightAreAsExact) {
  const std::string subject =
      "a tube's lobe of exponent 50 there, beside Embree's stratified rays for an RMS error of 1/256 of the largest";
  Report report;
  report.timings = {timing("penumbra_tube_lobe", 1, 1e-6), timing("penumbra_tube_lobe_at_256", 95, 19e-6)};
  EXPECT_EQ(about(findings(report), subject).found, "19 times (95 points)");
  EXPECT_FALSE(about(findings(report), subject).reached);
  report.timings[1] = timing("penumbra_tube_lobe_at_256", 95, 21e-6);
  EXPECT_TRUE(about(findings(report), subject).reached);
}

TEST(Targets, OfGrowthCompareTimesWithFaces) {
  const std::string subject =
      "193 to 3,073 receivers of stacks of boxes under a square, exponent of growth with the faces";
  Report report;
  report.timings = {timing("square_stacks", 193, 1, 100), timing("square_stacks", 3073, 100, 10000)};
  EXPECT_EQ(about(findings(report), subject).found, "1");
  EXPECT_TRUE(about(findings(report), subject).reached);
  report.timings[1].seconds.median = 300;
  EXPECT_FALSE(about(findings(report), subject).reached);
}

}  // namespace
}  // namespace gnomon::report
