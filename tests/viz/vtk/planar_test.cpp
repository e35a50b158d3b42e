#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <cmath>
#include <string>
#include <vector>

#include "gnomon/writer.h"
#include "tests/viz/planar_sample.h"
#include "tests/viz/temporary_folder.h"
#include "tests/viz/vtk/read_back.h"

namespace gnomon {
namespace {

/// The planar sample, written and read back by VTK's own reader.
class WrittenPlanarShadow : public testing::Test {
 protected:
  WrittenPlanarShadow() {
    write_shadow(PlanarSample().result(), folder_.path());
    manifest_ = read_json(folder_ / "manifest.json");
    tree_ = read_multiblock(folder_ / "shadow.vtm");
  }

  vtkPointSet& block(const std::string& name) { return *tree_.blocks.at(name); }

  std::vector<double> values(const std::string& name, const char* array) {
    vtkDataArray* data = block(name).GetCellData()->GetArray(array);
    std::vector<double> list;
    for (vtkIdType i = 0; i < data->GetNumberOfTuples(); ++i) list.push_back(data->GetComponent(i, 0));
    return list;
  }

  TemporaryFolder folder_;
  nlohmann::json manifest_;
  ReadTree tree_;
};

/// Positive where the corners run counterclockwise.
double polygon_area(vtkCell& polygon) {
  double twice = 0;
  const vtkIdType size = polygon.GetNumberOfPoints();
  for (vtkIdType i = 0; i < size; ++i) {
    double p[3];
    double q[3];
    polygon.GetPoints()->GetPoint(i, p);
    polygon.GetPoints()->GetPoint((i + 1) % size, q);
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return twice / 2;
}

double area(vtkPointSet& polygons) {
  double sum = 0;
  for (vtkIdType i = 0; i < polygons.GetNumberOfCells(); ++i) sum += polygon_area(*polygons.GetCell(i));
  return sum;
}

TEST_F(WrittenPlanarShadow, HasTheNamesOfSpaceWithoutSolids) {
  std::vector<std::string> names;
  for (const auto& [name, data] : tree_.blocks) names.push_back(name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("scene/lights/tube", "scene/blockers/wall", "scene/receivers/floor",
                                                   "volumes/tube/wall/occlusion", "volumes/tube/wall/umbra",
                                                   "volumes/tube/wall/penumbra", "extremal_planes/tube/wall"));
  EXPECT_EQ(manifest_.at("dimension"), 2);
  EXPECT_EQ(manifest_.at("pairs").at(0).at("umbra").at("volume_in_box"), 8.25);
}

TEST_F(WrittenPlanarShadow, HasCounterclockwisePolygonsThatFillTheRegions) {
  for (const std::string region : {"occlusion", "umbra", "penumbra"}) {
    vtkPointSet& polygons = block("volumes/tube/wall/" + region);
    EXPECT_DOUBLE_EQ(area(polygons), std::stod(field_text(polygons.GetFieldData(), "volume_total"))) << region;
    for (vtkIdType i = 0; i < polygons.GetNumberOfCells(); ++i) EXPECT_GT(polygon_area(*polygons.GetCell(i)), 0);
  }
  EXPECT_DOUBLE_EQ(area(block("volumes/tube/wall/umbra")), 8.25);
  EXPECT_DOUBLE_EQ(area(block("volumes/tube/wall/penumbra")), 4.5);
}

TEST_F(WrittenPlanarShadow, NumbersRegions) {
  EXPECT_THAT(values("volumes/tube/wall/umbra", "region"), testing::Each(2));
  EXPECT_THAT(values("volumes/tube/wall/umbra", "visible_fraction"), testing::Each(0));
  EXPECT_THAT(values("volumes/tube/wall/penumbra", "region"), testing::Each(1));
  EXPECT_FALSE(tree_.blocks.at("volumes/tube/wall/occlusion")->GetCellData()->HasArray("region"));
}

TEST_F(WrittenPlanarShadow, NamesTheEndsOfEveryExtremalLine) {
  const std::string lines = "extremal_planes/tube/wall";
  EXPECT_THAT(values(lines, "facet_kind"), testing::ElementsAre(1, 1, 3, 3));
  EXPECT_THAT(values(lines, "edge_index"), testing::ElementsAre(0, 1, 0, 1));
  EXPECT_THAT(values(lines, "vertex_index"), testing::ElementsAre(1, 0, 0, 1));
}

TEST_F(WrittenPlanarShadow, LiesAtHeightZero) {
  for (const auto& [name, data] : tree_.blocks) {
    const double* bounds = data->GetBounds();
    EXPECT_EQ(bounds[4], 0) << name;
    EXPECT_EQ(bounds[5], 0) << name;
  }
}

}  // namespace
}  // namespace gnomon
