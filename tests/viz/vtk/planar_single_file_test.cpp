#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkFieldData.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <map>
#include <string>
#include <utility>

#include "gnomon/writer.h"
#include "tests/viz/planar_sample.h"
#include "tests/viz/temporary_folder.h"
#include "tests/viz/vtk/read_back.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

// Segments of the sample: light, blocker, receiver, four extremal lines.
constexpr int sample_segments = 1 + 1 + 1 + 4;
// What its umbra and penumbra measure in the clip box; the occlusion is both.
constexpr double umbra_area = 8.25;
constexpr double penumbra_area = 4.5;

template <class Reader>
vtkSmartPointer<vtkPolyData> read_with(const fs::path& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Twice the area of a polygon of the plane z = 0, positive where its corners run counterclockwise.
double twice_area(vtkCell& polygon) {
  double sum = 0;
  const vtkIdType size = polygon.GetNumberOfPoints();
  for (vtkIdType i = 0; i < size; ++i) {
    double p[3];
    double q[3];
    polygon.GetPoints()->GetPoint(i, p);
    polygon.GetPoints()->GetPoint((i + 1) % size, q);
    sum += p[0] * q[1] - p[1] * q[0];
  }
  return sum;
}

/// Area of all polygons, and how many segments there are.
std::pair<double, int> area_and_segments(vtkPolyData& data) {
  double area = 0;
  int segments = 0;
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    vtkCell& cell = *data.GetCell(i);
    if (cell.GetCellDimension() == 2) area += twice_area(cell) / 2;
    if (cell.GetCellDimension() == 1) ++segments;
  }
  return {area, segments};
}

class PlanarSingleFile : public testing::Test {
 protected:
  void write(OutputFormat format) { write_shadow(sample_.result(), folder_.path(), {{format}}); }

  TemporaryFolder folder_;
  PlanarSample sample_;
};

TEST_F(PlanarSingleFile, VtpcHoldsTheBlocksOfVtm) {
  write_shadow(sample_.result(), folder_.path(), {{OutputFormat::vtm, OutputFormat::vtpc}});
  const ReadTree tree = read_multiblock(folder_ / "shadow.vtm");
  const ReadTree partitioned = read_partitioned(folder_ / "shadow.vtpc");
  ASSERT_EQ(partitioned.blocks.size(), tree.blocks.size());
  std::multimap<vtkIdType, double> expected;
  std::multimap<vtkIdType, double> found;
  for (const auto& [name, block] : tree.blocks) expected.emplace(block->GetNumberOfCells(), block->GetLength());
  for (const auto& [name, block] : partitioned.blocks) found.emplace(block->GetNumberOfCells(), block->GetLength());
  EXPECT_EQ(found.size(), 7u);
  EXPECT_EQ(found, expected);
}

TEST_F(PlanarSingleFile, VtpHoldsEveryRegionAndLineWithItsBlock) {
  write(OutputFormat::vtp);
  const auto merged = read_with<vtkXMLPolyDataReader>(folder_ / "shadow.vtp");
  const auto [area, segments] = area_and_segments(*merged);
  EXPECT_DOUBLE_EQ(area, 2 * (umbra_area + penumbra_area));
  EXPECT_EQ(segments, sample_segments);
  EXPECT_EQ(merged->GetPoints()->GetDataType(), VTK_DOUBLE);
  auto* names = vtkStringArray::SafeDownCast(merged->GetFieldData()->GetAbstractArray("block_names"));
  ASSERT_NE(names, nullptr);
  vtkDataArray* blocks = merged->GetCellData()->GetArray("block_id");
  std::map<std::string, double> areas;
  for (vtkIdType i = 0; i < merged->GetNumberOfCells(); ++i) {
    if (merged->GetCell(i)->GetCellDimension() < 2) continue;
    areas[names->GetValue(static_cast<vtkIdType>(blocks->GetComponent(i, 0)))] += twice_area(*merged->GetCell(i)) / 2;
  }
  EXPECT_THAT(areas, testing::UnorderedElementsAre(
                         testing::Pair("volumes/tube/wall/occlusion", testing::DoubleEq(umbra_area + penumbra_area)),
                         testing::Pair("volumes/tube/wall/umbra", testing::DoubleEq(umbra_area)),
                         testing::Pair("volumes/tube/wall/penumbra", testing::DoubleEq(penumbra_area))));
}

TEST_F(PlanarSingleFile, ObjHoldsRegionsAsFacesAndLinesAsLinesInGroups) {
  write(OutputFormat::obj);
  const auto [area, segments] = area_and_segments(*read_with<vtkOBJReader>(folder_ / "shadow.obj"));
  EXPECT_NEAR(area, 2 * (umbra_area + penumbra_area), 1e-5);
  EXPECT_EQ(segments, sample_segments);
  const std::string text = file_text(folder_ / "shadow.obj");
  for (const char* group :
       {"g volumes/tube/wall/umbra\nf ", "g scene/blockers/wall\nl ", "g extremal_planes/tube/wall\nl "}) {
    EXPECT_THAT(text, testing::HasSubstr(group));
  }
}

TEST_F(PlanarSingleFile, StlHoldsOneRegionPerFile) {
  write(OutputFormat::stl);
  for (const auto& [name, expected] : {std::pair{"occlusion", umbra_area + penumbra_area},
                                       std::pair{"umbra", umbra_area}, std::pair{"penumbra", penumbra_area}}) {
    const auto region = read_with<vtkSTLReader>(folder_ / ("shadow/volumes/tube/wall/" + std::string(name) + ".stl"));
    EXPECT_NEAR(area_and_segments(*region).first, expected, 1e-5) << name;
  }
}

TEST_F(PlanarSingleFile, GltfHoldsEveryRegionAndLineAsANode) {
  write(OutputFormat::gltf);
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName((folder_ / "shadow.gltf").c_str());
  reader->ApplyDeformationsToGeometryOff();
  reader->Update();
  double area = 0;
  int segments = 0;
  const auto leaf = vtk::TakeSmartPointer(reader->GetOutput()->NewTreeIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem()) {
    const auto found = area_and_segments(*vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject()));
    area += found.first;
    segments += found.second;
  }
  EXPECT_NEAR(area, 2 * (umbra_area + penumbra_area), 1e-5);
  EXPECT_EQ(segments, sample_segments);
  EXPECT_EQ(read_json(folder_ / "shadow.gltf").at("nodes").size(), 8u);
}

}  // namespace
}  // namespace gnomon
