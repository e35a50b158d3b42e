#include "geometry/visibility/silhouette_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/support/dice.h"

namespace gnomon::viewpoint {
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

std::vector<Silhouette> draw_silhouettes(Dice& dice, std::size_t count, int reach) {
  std::vector<Silhouette> silhouettes(count + 1);
  silhouettes[0].box = {0, 0, 16, 16};
  for (std::size_t i = 1; i <= count; ++i) silhouettes[i].box = draw_box(dice, reach);
  return silhouettes;
}

std::vector<std::uint32_t> all_that_meet(const std::vector<Silhouette>& silhouettes, const FlatBox& box) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 1; i < silhouettes.size(); ++i) {
    if (box.meets(silhouettes[i].box)) found.push_back(i);
  }
  return found;
}

/// Few and many silhouettes, small and large ones, one grid for all.
RC_GTEST_PROP(SilhouetteGridProperty, FindsEveryBoxThatMeetsAnotherOnceAndInOrder, ()) {
  Dice dice;
  SilhouetteGrid grid;
  std::vector<std::uint32_t> found;
  for (const std::size_t count : {std::size_t{1000}, std::size_t{3}, std::size_t{300}}) {
    const std::vector<Silhouette> silhouettes = draw_silhouettes(dice, count, dice.once_in(2) ? 1 : 6);
    grid.build(silhouettes);
    for (int k = 0; k < 20; ++k) {
      const FlatBox box = k == 0 ? silhouettes[0].box : draw_box(dice, 3);
      grid.find(box, found);
      RC_ASSERT(found == all_that_meet(silhouettes, box));
    }
  }
}

}  // namespace
}  // namespace gnomon::viewpoint
