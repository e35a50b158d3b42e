#include "geometry/visibility/outline_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/support/dice.h"

namespace gnomon::sight {
namespace {

using test_support::Dice;

/// A box on a small grid, so that sides in common, equal boxes and boxes without area are common; now and then one that
/// is as wide as all.
FlatBox draw_box(Dice& dice, int reach) {
  const auto draw = [&](double& low, double& high) {
    low = dice.draw(0, 16);
    high = std::min(16.0, low + dice.draw(0, dice.once_in(40) ? 16 : reach));
  };
  FlatBox box;
  draw(box.low_u, box.high_u);
  draw(box.low_v, box.high_v);
  return box;
}

std::vector<Outline> draw_outlines(Dice& dice, std::size_t count, int reach) {
  std::vector<Outline> outlines(count + 1);
  outlines[0].box = {0, 0, 16, 16};
  for (std::size_t i = 1; i <= count; ++i) outlines[i].box = draw_box(dice, reach);
  return outlines;
}

std::vector<std::uint32_t> all_that_meet(const std::vector<Outline>& outlines, const FlatBox& box) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 1; i < outlines.size(); ++i) {
    if (box.meets(outlines[i].box)) found.push_back(i);
  }
  return found;
}

/// Few and many outlines, small and large ones, one grid for all.
RC_GTEST_PROP(OutlineGridProperty, FindsEveryBoxThatMeetsAnotherOnceAndInOrder, ()) {
  Dice dice;
  OutlineGrid grid;
  std::vector<std::uint32_t> found;
  for (const std::size_t count : {std::size_t{1000}, std::size_t{3}, std::size_t{300}}) {
    const std::vector<Outline> outlines = draw_outlines(dice, count, dice.once_in(2) ? 1 : 6);
    grid.build(outlines);
    for (int k = 0; k < 20; ++k) {
      const FlatBox box = k == 0 ? outlines[0].box : draw_box(dice, 3);
      grid.find(box, found);
      RC_ASSERT(found == all_that_meet(outlines, box));
    }
  }
}

}  // namespace
}  // namespace gnomon::sight
