#include "viz/pictures/label_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr DrawingSize frame{800, 600};

TEST(LabelLayout, LeavesLabelsApartWhereTheyAre) {
  std::vector<LabelBox> boxes = {{100, 100, 50, 16}, {100, 130, 50, 16}, {400, 300, 90, 16}};
  EXPECT_THAT(pushed_apart(boxes, frame), SizeIs(3));
  EXPECT_EQ(boxes[0].y, 100);
  EXPECT_EQ(boxes[1].y, 130);
}

TEST(LabelLayout, PushesTwoLabelsInOnePlaceApart) {
  std::vector<LabelBox> boxes = {{100, 100, 50, 16}, {100, 100, 50, 16}};
  EXPECT_THAT(pushed_apart(boxes, frame), SizeIs(2));
  EXPECT_FALSE(overlap(boxes[0], boxes[1]));
  EXPECT_NEAR(boxes[1].y - boxes[0].y, 16, 1);
}

TEST(LabelLayout, LeavesOutWhatFindsNoRoom) {
  std::vector<LabelBox> boxes(5, {30, 20, 50, 16});
  EXPECT_THAT(pushed_apart(boxes, {60, 40}), SizeIs(2));
}

TEST(LabelLayoutProperty, LabelsKeptOverlapNoneAndLieInTheFrame) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0, frame.width), y(0, frame.height), width(20, 200);
  for (int round = 0; round < 200; ++round) {
    std::vector<LabelBox> boxes;
    for (int i = 0; i < 24; ++i) boxes.push_back({x(random), y(random), width(random), 16});
    const std::vector<std::size_t> kept = pushed_apart(boxes, frame);
    EXPECT_GE(kept.size(), 12) << "round " << round << " of seed 7";
    for (const std::size_t i : kept) {
      EXPECT_LE(boxes[i].width / 2, boxes[i].x + 1e-9);
      EXPECT_LE(boxes[i].x + boxes[i].width / 2, frame.width + 1e-9);
      EXPECT_LE(boxes[i].y + boxes[i].height / 2, frame.height + 1e-9);
      for (const std::size_t k : kept) EXPECT_TRUE(i == k || !overlap(boxes[i], boxes[k])) << round;
    }
  }
}

/// A level square of half width `half` around the z axis.
PictureItem plate(double half, double z) {
  vtkNew<vtkCellArray> cells;
  insert_cell(*cells, std::vector<int>{0, 1, 2, 3});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(
      vtk_points(std::vector<Point3>{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}));
  data->SetPolys(cells);
  return {"plate", data, {}, "blocker"};
}

std::vector<std::string> texts_seen_from_above(const std::vector<PictureItem>& items,
                                               const std::vector<PictureLabel>& labels) {
  const PictureView view{{0, 0, 20}, {0, 0, 0}, {0, 1, 0}};
  std::vector<std::string> texts;
  for (const PlacedLabel& label : placed_labels(labels, items, PictureScene{}, view, frame, 12)) {
    texts.push_back(label.text);
  }
  return texts;
}

TEST(LabelLayout, LeavesOutALabelThatSomethingOpaqueHides) {
  const PictureLabel low{"low", {{0, 0, 0}}, "blocker"};
  EXPECT_THAT(texts_seen_from_above({plate(1, 2), plate(2, 0)}, {low}), IsEmpty());
  PictureItem glass = plate(1, 2);
  glass.look.opacity = 0.5;
  EXPECT_THAT(texts_seen_from_above({glass, plate(2, 0)}, {low}), ElementsAre("low"));
}

TEST(LabelLayout, TakesTheFirstPlaceThatIsSeen) {
  const PictureLabel low{"low", {{0, 0, 0}, {1.8, 0, 0}}, "blocker"};
  EXPECT_THAT(texts_seen_from_above({plate(1, 2), plate(2, 0)}, {low}), ElementsAre("low"));
  const PictureView view{{0, 0, 20}, {0, 0, 0}, {0, 1, 0}};
  const std::vector<PictureItem> items = {plate(1, 2), plate(2, 0)};
  const std::vector<PictureLabel> labels = {low};
  const PlacedLabel placed = placed_labels(labels, items, PictureScene{}, view, frame, 12).front();
  EXPECT_FALSE(placed.is_led);
  EXPECT_NEAR(placed.from_x, 400 + 1.8 / 20 * 300 / std::tan(13 * std::acos(-1.0) / 180), 1e-9);
  EXPECT_NEAR(placed.from_y, 300, 1e-9);
}

TEST(LabelLayout, LeadsALabelThatWasPushedOffItsPlace) {
  const std::vector<PictureLabel> labels(3, PictureLabel{"one", {{0, 0, 0}}, "blocker"});
  const PictureView view{{0, 0, 20}, {0, 0, 0}, {0, 1, 0}};
  const std::vector<PlacedLabel> placed = placed_labels(labels, {}, PictureScene{}, view, frame, 12);
  ASSERT_THAT(placed, SizeIs(3));
  EXPECT_EQ(std::ranges::count(placed, true, &PlacedLabel::is_led), 2);
}

}  // namespace
}  // namespace gnomon::viz
