#include "viz/picture_items.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkNew.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/viz/sample_result.h"
#include "viz/cell_arrays.h"
#include "viz/picture_facets.h"
#include "viz/picture_legend.h"
#include "viz/vtk_cells.h"

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

PictureScene divided_scene() {
  const SampleResult sample;
  PictureSource source = picture_source(sample.result());
  source.blocks.push_back({{"receivers", "floor", "lamp"}, "divided_receiver", divided_floor()});
  source.blocks.push_back({{"discontinuities", "lamp", "vertex_0"}, "discontinuity", surface_of_order_1()});
  return picture_scene(source);
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
  const auto surface = std::ranges::find(items, "discontinuities/lamp/vertex_0: D1", &PictureItem::name);
  ASSERT_NE(surface, items.end());
  EXPECT_EQ(surface->look.color, palette.discontinuities[1]);
  EXPECT_LT(surface->look.opacity, 1);
}

TEST(PictureItems, PaintNoShadowOverADividedReceiver) {
  EXPECT_TRUE(divided_scene().shadows.empty());
  EXPECT_FALSE(picture_scene(picture_source(SampleResult().result())).shadows.empty());
}

TEST(PictureItems, AreExplainedByTheLegend) {
  std::vector<std::string> texts;
  for (const LegendEntry& entry : legend_entries(divided_scene())) texts.push_back(entry.text);
  EXPECT_THAT(texts, IsSupersetOf({"lit on receiver", "penumbra on receiver", "umbra on receiver"}));
  for (const std::string order : {"D0", "D1", "D2"}) EXPECT_THAT(texts, Contains(testing::StartsWith(order + ": ")));
}

TEST(PictureItems, OfAVolumeHaveANameForEveryCell) {
  const SampleResult sample;
  const PictureScene scene = picture_scene(picture_source(sample.result()));
  for (const PictureItem& item : picture_items(scene)) {
    if (item.cell_names.empty()) continue;
    EXPECT_EQ(static_cast<vtkIdType>(item.cell_names.size()), item.data->GetNumberOfCells());
    EXPECT_EQ(std::ranges::count(item.cell_names, ""), 0) << item.name;
  }
}

TEST(PictureLabels, NameLightsBlockersAndReceiversWhileTheyAreFew) {
  PictureScene scene = picture_scene(picture_source(SampleResult().result()));
  std::vector<std::string> texts;
  for (const PictureLabel& label : picture_labels(scene, {0, 0, 1})) texts.push_back(label.text);
  EXPECT_THAT(texts, IsSupersetOf({"lamp", "table", "floor"}));
  scene.blockers.assign(9, scene.blockers.front());
  for (const PictureLabel& label : picture_labels(scene, {0, 0, 1})) EXPECT_NE(label.text, "table");
}

}  // namespace
}  // namespace gnomon::viz
