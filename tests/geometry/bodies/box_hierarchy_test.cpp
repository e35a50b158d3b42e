#include "geometry/bodies/box_hierarchy.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "apps/proof/laws/draw.h"
#include "geometry/bodies/boxes.h"

namespace gnomon {
namespace {

/// A box on small integers, often flat, often a copy of another one.
Box3 draw_box(int range) {
  Box3 box = empty_box3();
  for (int i = 0; i < 2; ++i) {
    const double x = laws::draw(-range, range), y = laws::draw(-range, range);
    include(box, {x, y, double(laws::draw(-range, range))});
  }
  return box;
}

RC_GTEST_PROP(BoxHierarchyProperty, FindsTheBoxesThatMeetABoxAndNoOther, ()) {
  std::vector<Box3> boxes(std::size_t(laws::draw(0, 70)));
  for (Box3& box : boxes) box = draw_box(6);
  const Box3 asked = draw_box(6);
  const auto meets = [&](const Box3& box) { return overlap(box, asked); };
  std::vector<std::uint32_t> expected, found{99};
  for (std::uint32_t n = 0; n < boxes.size(); ++n) {
    if (meets(boxes[n])) expected.push_back(n);
  }
  BoxHierarchy(boxes).search(meets, found);
  std::sort(found.begin(), found.end());
  RC_ASSERT(found == expected);
}

TEST(BoxHierarchy, OfNoBoxesFindsNothing) {
  std::vector<std::uint32_t> found{1, 2};
  BoxHierarchy().search([](const Box3&) { return true; }, found);
  EXPECT_TRUE(found.empty());
  EXPECT_TRUE(BoxHierarchy(std::vector<Box3>{}).empty());
}

}  // namespace
}  // namespace gnomon
