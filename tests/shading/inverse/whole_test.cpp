#include "shading/inverse/whole.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/dice.h"

namespace gnomon::inverse {
namespace {

using test_support::Dice;

/// The planes through three generators that have all others on one side: the definition.
std::set<Whole> half_spaces_by_trial(const std::vector<Whole>& generators) {
  std::set<Whole> found;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        for (const int sign : {-1, 1}) {
          Whole plane = complement(generators[i], generators[j], generators[k]);
          for (Integer& x : plane) x *= sign;
          if (plane[0] == 0 && plane[1] == 0 && plane[2] == 0) continue;
          const auto within = [&](const Whole& g) { return value(plane, g) <= 0; };
          if (std::ranges::all_of(generators, within)) found.insert(plane);
        }
      }
    }
  }
  return found;
}

TEST(HullHalfSpacesAgreement, AreThePlanesThroughThreeGeneratorsWithAllOthersOnOneSide) {
  int compared = 0;
  for (std::uint32_t seed = 1; seed <= (GNOMON_LONG ? 5000 : 500); ++seed) {
    Dice dice(seed);
    const int r = dice.once_in(2) ? 1 : 5;
    std::vector<Whole> generators;
    const int points = dice.draw(1, 7), directions = dice.draw(0, 3);
    for (int k = 0; k < points + directions; ++k) {
      const Point3 p = {double(dice.draw(-r, r)), double(dice.draw(-r, r)), double(dice.draw(-r, r))};
      if (k >= points && p == Point3{}) continue;
      generators.push_back(k < points ? whole_point(p) : whole_direction(p));
    }
    const auto planes = hull_half_spaces(generators);
    if (!planes) continue;
    ++compared;
    EXPECT_EQ(std::set<Whole>(planes->begin(), planes->end()), half_spaces_by_trial(generators)) << "seed " << seed;
  }
  EXPECT_GT(compared, 100);
}

TEST(WholeNumbers, OfEqualPlanesAreEqual) {
  const HalfSpace a{{}, {Point3{0, 0, 0.1}, Point3{1, 0, 0.1}, Point3{0, 1, 0.1}}};
  const HalfSpace b{{}, {Point3{3, 5, 0.1}, Point3{9, 5, 0.1}, Point3{3, 8, 0.1}}};
  EXPECT_EQ(whole_plane(a), whole_plane(b));
  EXPECT_LT(value(whole_plane(a), whole_point(Point3{0, 0, 1})) * value(whole_plane(a), whole_point(Point3{0, 0, 0})),
            0);
}

}  // namespace
}  // namespace gnomon::inverse
