#include "viz/pictures/picture_items.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkNew.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/viz/sample_result.h"
#include "viz/pictures/picture_legend.h"
#include "viz/pictures/picture_selection.h"
#include "viz/vtk/cell_arrays.h"
#include "viz/vtk/colour_map.h"
#include "viz/vtk/facet_groups.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

using testing::Contains;
using testing::IsSupersetOf;

/// Three triangles of the floor's plane, lit, in penumbra and in umbra, and lines of the orders 0, 1 and 2.
vtkSmartPointer<vtkPolyData> divided_floor() {
  std::vector<Point3> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> faces;
  std::vector<CellName> names(6);
  for (int i = 0; i < 3; ++i) {
    insert_cell(*lines, std::vector<int>{0, 1}, 3 * i);
    insert_cell(*faces, std::vector<int>{0, 1, 2}, 3 * i);
    points.insert(points.end(), {{i - 2.0, 0, 0}, {i - 1.0, 0, 0}, {i - 1.0, 1, 0}});
    names[static_cast<std::size_t>(i)].discontinuity_order = i;
    names[static_cast<std::size_t>(i) + 3].region = static_cast<std::uint8_t>(i);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points));
  data->SetLines(lines);
  data->SetPolys(faces);
  add_cell_arrays(*data, names);
  return data;
}

/// One triangle of order 1 in space.
vtkSmartPointer<vtkPolyData> surface_of_order_1() {
  vtkNew<vtkCellArray> faces;
  insert_cell(*faces, std::vector<int>{0, 1, 2});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(std::vector<Point3>{{0, 0, 4}, {1, 0, 0}, {0, 1, 0}}));
  data->SetPolys(faces);
  CellName name;
  name.discontinuity_order = 1;
  add_cell_arrays(*data, std::vector<CellName>{name});
  return data;
}

PictureSource sample_source(const SampleResult& sample) {
  return selected(picture_source(sample.result()), {}, LightsShown::first);
}

PictureScene divided_scene() {
  SampleResult sample;
  sample.result().receivers.clear();
  PictureSource source = picture_source(sample.result());
  source.blocks.push_back({{"receivers", "lamp", "floor", "faces"}, "receiver_faces", divided_floor()});
  source.blocks.push_back({{"discontinuities", "lamp", "d1"}, "discontinuities", surface_of_order_1()});
  return picture_scene(selected(source, {}, LightsShown::first));
}

vtkSmartPointer<vtkPolyData> shelf() {
  vtkNew<vtkCellArray> faces;
  insert_cell(*faces, std::vector<int>{0, 1, 2, 3});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(std::vector<Point3>{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}));
  data->SetPolys(faces);
  return data;
}

vtkSmartPointer<vtkPolyData> lit_shelf() {
  auto data = shelf();
  CellName name;
  name.region = 0;
  add_cell_arrays(*data, std::vector<CellName>{name});
  return data;
}

bool shows(const std::vector<PictureItem>& items, const Color& color, bool as_lines) {
  return std::ranges::any_of(items, [&](const PictureItem& item) {
    return item.look.color == color && (item.data->GetNumberOfPolys() == 0) == as_lines;
  });
}

TEST(PictureItems, ShowDividedReceiversByRegionAndOrder) {
  const std::vector<PictureItem> items = picture_items(divided_scene());
  for (const Color& color : {palette.lit, palette.penumbra, palette.umbra}) EXPECT_TRUE(shows(items, color, false));
  for (const Color& color : palette.discontinuities) EXPECT_TRUE(shows(items, color, true));
}

TEST(PictureItems, ShowDiscontinuitySurfacesTranslucentByTheirOrder) {
  const std::vector<PictureItem> items = picture_items(divided_scene());
  const auto surface = std::ranges::find(items, "discontinuities/lamp/d1: D1", &PictureItem::name);
  ASSERT_NE(surface, items.end());
  EXPECT_EQ(surface->look.color, palette.discontinuities[1]);
  EXPECT_LT(surface->look.opacity, 1);
}

TEST(PictureItems, HaveTheColourOfNoRegionWhereAReceiverIsNotDivided) {
  SampleResult sample;
  sample.result().receivers.clear();
  const std::vector<PictureItem> items = picture_items(picture_scene(sample_source(sample)));
  EXPECT_TRUE(shows(items, palette.receiver, false));
  EXPECT_FALSE(shows(items, palette.lit, false));
  EXPECT_FALSE(shows(picture_items(divided_scene()), palette.receiver, false));
}

TEST(PictureItems, PaintRegionsOnTheFrontOfAReceiverAndNoneOnItsBack) {
  SampleResult sample;
  sample.result().receivers.clear();
  PictureSource source = sample_source(sample);
  // A shelf in the middle of the scene, which has something on both sides.
  source.blocks.push_back({{"scene", "receivers", "shelf"}, "receiver", shelf()});
  source.blocks.push_back({{"receivers", "lamp", "shelf", "faces"}, "receiver_faces", lit_shelf()});
  for (const PictureItem& item : picture_items(picture_scene(source))) {
    if (item.name == "lit on shelf") {
      EXPECT_GT(item.front->normal.z, 0.9);
    }
    if (item.name == "back of shelf") {
      EXPECT_LT(item.front->normal.z, -0.9);
    }
  }
  EXPECT_TRUE(shows(picture_items(picture_scene(source)), palette.lit, false));
}

/// The floor of divided_scene with the irradiance 0, 30 and 60 at its corners, and without a number.
PictureScene painted_scene(const std::string& other_light = "") {
  SampleResult sample;
  sample.result().receivers.clear();
  sample.result().painted.push_back(
      {0, "lamp", "floor", {{-2, 0, 0}, {0, 0, 0}, {0, 2, 0}}, {{0, 0}, {30, 0}, {60, 0}}, {{0, 1, 2}}});
  PictureSource source = picture_source(sample.result());
  source.blocks.push_back({{"receivers", "lamp", "floor", "faces"}, "receiver_faces", divided_floor()});
  if (!other_light.empty()) {
    source.blocks.push_back({{"scene", "lights", other_light}, "light", shelf()});
    sample.result().painted.front() = {
        1, other_light, "floor", {{-2, 0, 0}, {0, 0, 0}, {0, 2, 0}}, {{1, 0}, {1, 0}, {7, 0}}, {{0, 1, 2}}};
    for (const PictureBlock& block : picture_source(sample.result()).blocks) {
      if (block.kind == "receiver_irradiance") source.blocks.push_back(block);
    }
  }
  return picture_scene(selected(source, {}, LightsShown::all_in_turn));
}

TEST(PictureItems, PaintIrradianceInThePlaceOfRegionsPointByPoint) {
  const std::vector<PictureItem> items = picture_items(painted_scene());
  const auto painted = std::ranges::find(items, "irradiance on floor", &PictureItem::name);
  ASSERT_NE(painted, items.end());
  EXPECT_EQ(painted->point_colors, (std::vector<Color>{colour_of_share(0), colour_of_share(0.5), colour_of_share(1)}));
  EXPECT_EQ(painted->layer, "irradiance");
  EXPECT_FALSE(shows(items, palette.receiver, false)) << "and not in the colour of none";
  for (const PictureItem& item : items) EXPECT_THAT(item.name, testing::Not(testing::HasSubstr("umbra on")));
}

TEST(PictureItems, HaveAScaleWithAUnitForTheIrradianceOfEachLight) {
  std::vector<std::string> texts, of_other;
  for (const LegendEntry& entry : legend_entries(painted_scene("spare"))) {
    if (entry.layer == "irradiance") (entry.light == "lamp" ? texts : of_other).push_back(entry.text);
  }
  EXPECT_THAT(texts, testing::ElementsAre("irradiance 60 W/m²", "50 W/m²", "40 W/m²", "30 W/m²", "20 W/m²", "10 W/m²",
                                          "0 W/m²"));
  EXPECT_EQ(of_other.front(), "irradiance 7 W/m²");
  EXPECT_EQ(of_other.size(), 8U);
}

TEST(PictureSelection, TakesTheFirstLightThatHasResultsAndOnAPageAllOfThem) {
  const SampleResult sample;
  PictureSource source = picture_source(sample.result());
  source.blocks.insert(source.blocks.begin(), {{"scene", "lights", "spare"}, "light", shelf()});
  source.blocks.push_back({{"scene", "lights", "other"}, "light", shelf()});
  source.blocks.push_back({{"discontinuities", "other", "d1"}, "discontinuities", surface_of_order_1()});
  using Names = std::vector<std::string>;
  EXPECT_EQ(selected(source, {}, LightsShown::first).lights, Names{"lamp"});
  EXPECT_EQ(selected(source, {}, LightsShown::all_in_turn).lights, (Names{"lamp", "other"}));
  const PictureSource other = selected(source, {.light = "other"}, LightsShown::first);
  EXPECT_EQ(other.light_count, 3);
  for (const PictureBlock& block : other.blocks) {
    EXPECT_EQ(std::ranges::count(block.path, "lamp") + std::ranges::count(block.path, "spare"), 0) << block.path[0];
  }
}

TEST(PictureSelection, LeavesOutVolumesOfPartsUnlessTheyAreAskedFor) {
  const SampleResult sample;
  PictureSource source = picture_source(sample.result());
  source.blocks.push_back({{"volumes", "lamp", "vase#1", "umbra"}, "volume", shelf()});
  const auto has_part = [](const PictureSource& shown) {
    return std::ranges::any_of(shown.blocks, [](const PictureBlock& block) { return block.path.at(2) == "vase#1"; });
  };
  EXPECT_FALSE(has_part(selected(source, {}, LightsShown::first)));
  EXPECT_TRUE(has_part(selected(source, {.part_volumes = Shown::yes}, LightsShown::first)));
}

TEST(PictureItems, AreExplainedByTheLegend) {
  std::vector<std::string> texts;
  for (const LegendEntry& entry : legend_entries(divided_scene())) texts.push_back(entry.text);
  EXPECT_THAT(texts, IsSupersetOf({"lit on receiver", "penumbra on receiver", "umbra on receiver"}));
  for (const std::string order : {"D0", "D1", "D2"}) EXPECT_THAT(texts, Contains(testing::StartsWith(order + ": ")));
}

TEST(PictureItems, OfAVolumeHaveANameForEveryCell) {
  const SampleResult sample;
  const PictureScene scene = picture_scene(sample_source(sample));
  for (const PictureItem& item : picture_items(scene)) {
    if (item.cell_names.empty()) continue;
    EXPECT_EQ(static_cast<vtkIdType>(item.cell_names.size()), item.data->GetNumberOfCells());
    EXPECT_EQ(std::ranges::count(item.cell_names, ""), 0) << item.name;
  }
}

TEST(PictureLabels, NameLightsBlockersAndReceiversWhileTheyAreFew) {
  const SampleResult sample;
  PictureScene scene = picture_scene(sample_source(sample));
  std::vector<std::string> texts;
  for (const PictureLabel& label : picture_labels(scene, {9, 9, 9})) texts.push_back(label.text);
  EXPECT_THAT(texts, IsSupersetOf({"lamp", "table", "floor"}));
  scene.blockers.assign(9, scene.blockers.front());
  for (const PictureLabel& label : picture_labels(scene, {9, 9, 9})) EXPECT_NE(label.text, "table");
}

TEST(PictureLabels, OfAPointStandsOverTheBallThatIsDrawnForItAndInFrontOfIt) {
  const SampleResult sample;
  PictureScene scene = picture_scene(sample_source(sample));
  const Point3 bulb{0, 0, 4}, viewer{20, 0, 4};
  vtkNew<vtkCellArray> point;
  insert_cell(*point, std::vector<int>{0});
  scene.lights.front().data = vtkSmartPointer<vtkPolyData>::New();
  scene.lights.front().data->SetPoints(vtk_points(std::vector<Point3>{bulb}));
  scene.lights.front().data->SetVerts(point);
  const PictureLabel label = picture_labels(scene, viewer).front();
  ASSERT_EQ(label.text, "lamp");
  ASSERT_EQ(label.places.size(), 1U);
  const Point3 way = label.places.front() - bulb;
  const double radius = ball_radius * scene.size;
  EXPECT_GT(way.x, radius);
  EXPECT_LT(way.x, 2 * radius);
  EXPECT_GT(way.z, 2 * radius);
  EXPECT_LT(way.z, 4 * radius);
}

TEST(PictureLabels, StandOnTheirOwnElements) {
  const SampleResult sample;
  for (const PictureLabel& label : picture_labels(picture_scene(sample_source(sample)), {9, 9, 9})) {
    const double height = label.text == "lamp" ? 4 : label.text == "table" ? 2 : 0;
    for (const Point3& place : label.places) {
      EXPECT_TRUE(label.text == "post" || place.z == height) << label.text;
    }
  }
}

}  // namespace
}  // namespace gnomon::viz
