#include "gnomon/irradiance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "geometry/numbers/kernel.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Numbers known exactly, and what is claimed of them: rounded, with a bound that is just wide enough.
struct Sample {
  std::vector<Rational> exact;
  std::vector<Irradiance> claimed;

  void add(const Rational& value) {
    const double rounded = static_cast<double>(value);
    const Rational off = Rational(rounded) < value ? Rational(value - rounded) : Rational(rounded - value);
    double bound = static_cast<double>(off);
    if (Rational(bound) < off) bound = std::nextafter(bound, no_limit);
    exact.push_back(value);
    claimed.push_back({rounded, bound});
  }
};

void expect_encloses(const Irradiance& claimed, const Rational& exact, const char* what) {
  const Rational off =
      Rational(claimed.value) < exact ? Rational(exact - claimed.value) : Rational(claimed.value - exact);
  EXPECT_LE(off, Rational(claimed.error_bound)) << what;
}

TEST(IrradianceSummary, BoundsHoldForTheExactMeanLeastAndLargestAndTheTotal) {
  std::mt19937 random(2);
  for (int round = 0; round < 300; ++round) {
    Sample sample;
    const int scale = static_cast<int>(random() % 40) - 20;
    for (std::size_t i = 0; i <= random() % 40; ++i) {
      const int own = random() % 4 == 0 ? static_cast<int>(random() % 30) : 0;
      sample.add(Rational(random() % 1000) / (1 + random() % 97) * Rational(std::ldexp(1.0, scale - own)));
    }
    IrradianceSummary summary;
    Rational sum = 0;
    for (std::size_t i = 0; i < sample.exact.size(); ++i) {
      summary.add(sample.claimed[i]);
      sum += sample.exact[i];
    }
    expect_encloses(total_irradiance(sample.claimed), sum, "total");
    expect_encloses(summary.mean(), sum / sample.exact.size(), "mean");
    expect_encloses(summary.least(), *std::min_element(sample.exact.begin(), sample.exact.end()), "least");
    expect_encloses(summary.largest(), *std::max_element(sample.exact.begin(), sample.exact.end()), "largest");
    EXPECT_LE(summary.mean().error_bound, 1e-14 * summary.mean().value) << "no wider than it has to be";
  }
}

TEST(IrradianceSummary, IsExactWhereNothingIsRounded) {
  IrradianceSummary summary;
  for (const double value : {0.0, 1.0, 2.0, 5.0}) summary.add({value, 0});
  EXPECT_EQ(summary.mean().value, 2);
  EXPECT_EQ(summary.mean().error_bound, 0);
  EXPECT_EQ(summary.least().value, 0);
  EXPECT_EQ(summary.least().error_bound, 0);
  EXPECT_EQ(summary.largest().value, 5);
  EXPECT_EQ(summary.largest().error_bound, 0);
}

TEST(IrradianceSummary, TheLeastMayBeAnotherPointsThanItsRoundedValueSays) {
  IrradianceSummary summary;
  summary.add({1, 0});
  summary.add({1.5, 1});  // may be 0.5
  EXPECT_EQ(summary.least().value, 1);
  EXPECT_GE(summary.least().error_bound, 0.5);
  EXPECT_LT(summary.least().error_bound, 0.51);
}

TEST(IrradianceSummaryDegenerate, PointsAtTheLightAreInfinite) {
  IrradianceSummary summary;
  summary.add({1, 0});
  summary.add({no_limit, no_limit});
  for (const Irradiance& e : {summary.mean(), summary.largest()}) {
    EXPECT_EQ(e.value, no_limit);
    EXPECT_EQ(e.error_bound, no_limit);
  }
  EXPECT_EQ(summary.least().value, 1);
  EXPECT_EQ(summary.least().error_bound, 0);
  EXPECT_THROW(IrradianceSummary().mean(), PreconditionError);
}

}  // namespace
}  // namespace gnomon
