#include <gmock/gmock.h>
#include <gtest/gtest.h>
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

#include <string>

#include "gnomon/writer.h"
#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"
#include "tests/viz/vtk/read_back.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

// Polygons of the sample: light, table, floor, six hull triangles of the post less one inside, 12 + 12 + 24 triangles
// of volumes, one extremal plane.
/// The last are the triangles of the divided floor.
constexpr vtkIdType sample_cells = 1 + 1 + 1 + 4 + 12 + 12 + 24 + 1 + 64;

template <class Reader>
vtkSmartPointer<vtkPolyData> read_with(const fs::path& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

class SingleFile : public testing::Test {
 protected:
  void write(OutputFormat format) { write_shadow(sample_.result(), folder_.path(), {{format}}); }

  TemporaryFolder folder_;
  SampleResult sample_;
};

TEST_F(SingleFile, VtpHoldsEverySurfaceWithItsBlock) {
  write(OutputFormat::vtp);
  const auto merged = read_with<vtkXMLPolyDataReader>(folder_ / "shadow.vtp");
  EXPECT_EQ(merged->GetNumberOfCells(), sample_cells);
  EXPECT_EQ(merged->GetPoints()->GetDataType(), VTK_DOUBLE);
  auto* names = vtkStringArray::SafeDownCast(merged->GetFieldData()->GetAbstractArray("block_names"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetNumberOfValues(), 9);
  vtkDataArray* blocks = merged->GetCellData()->GetArray("block_id");
  vtkDataArray* regions = merged->GetCellData()->GetArray("region");
  ASSERT_NE(blocks, nullptr);
  ASSERT_NE(regions, nullptr);
  vtkIdType umbra = 0;
  for (vtkIdType i = 0; i < sample_cells; ++i) {
    const std::string name = names->GetValue(static_cast<vtkIdType>(blocks->GetComponent(i, 0)));
    umbra += name == "volumes/lamp/table/umbra" ? 1 : 0;
    if (name == "receivers/lamp/floor/faces") continue;  // lit, penumbra and umbra lie in one block
    EXPECT_EQ(name.ends_with("/umbra"), regions->GetComponent(i, 0) == 2) << name;
  }
  EXPECT_EQ(umbra, 12);
}

TEST_F(SingleFile, ObjHoldsEverySurfaceAsAGroup) {
  write(OutputFormat::obj);
  EXPECT_EQ(read_with<vtkOBJReader>(folder_ / "shadow.obj")->GetNumberOfCells(), sample_cells);
  const std::string text = file_text(folder_ / "shadow.obj");
  for (const char* group :
       {"g volumes/lamp/table/umbra\n", "g scene/blockers/post\n", "g extremal_planes/lamp/table\n"}) {
    EXPECT_THAT(text, testing::HasSubstr(group));
  }
}

TEST_F(SingleFile, StlHoldsOneClosedSurfacePerFile) {
  write(OutputFormat::stl);
  for (const auto& [name, volume] :
       {std::pair{"occlusion", 59.25}, std::pair{"umbra", 23.25}, std::pair{"penumbra", 36.0}}) {
    const auto surface = read_with<vtkSTLReader>(folder_ / ("shadow/volumes/lamp/table/" + std::string(name) + ".stl"));
    EXPECT_TRUE(is_closed_surface(*surface)) << name;
    EXPECT_NEAR(enclosed_volume(*surface), volume, 1e-4) << name;
  }
  EXPECT_FALSE(fs::exists(folder_ / "view.py"));
}

TEST_F(SingleFile, GltfHoldsEverySurfaceAsANode) {
  write(OutputFormat::gltf);
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName((folder_ / "shadow.gltf").c_str());
  reader->ApplyDeformationsToGeometryOff();
  reader->Update();
  vtkIdType triangles = 0;
  const auto leaf = vtk::TakeSmartPointer(reader->GetOutput()->NewTreeIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem()) {
    triangles += vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject())->GetNumberOfCells();
  }
  // Five quadrangles are two triangles each.
  EXPECT_EQ(triangles, sample_cells + 4);
  const auto json = read_json(folder_ / "shadow.gltf");
  EXPECT_EQ(json.at("nodes").size(), 10u);
  // In glTF y is up; a quarter turn about x puts z there.
  EXPECT_EQ(json.at("nodes")[0].at("translation")[1], 2.0);
  EXPECT_EQ(json.at("nodes")[0].at("rotation"), nlohmann::json({-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}));
  EXPECT_FALSE(json.at("nodes")[0].contains("scale"));
  EXPECT_EQ(json.at("accessors")[0].at("min").size(), 3u);
}

TEST_F(SingleFile, SeveralFormatsShareOneManifest) {
  write_shadow(sample_.result(), folder_.path(),
               {{OutputFormat::stl, OutputFormat::vtm, OutputFormat::vtpc, OutputFormat::gltf}});
  const auto manifest = read_json(folder_ / "manifest.json");
  EXPECT_EQ(manifest.at("roots"), nlohmann::json({"shadow.vtm", "shadow.vtpc", "shadow.gltf"}));
  for (const std::string file : manifest.at("files")) EXPECT_TRUE(fs::exists(folder_ / file)) << file;
  EXPECT_EQ(read_partitioned(folder_ / "shadow.vtpc").blocks.size(),
            read_multiblock(folder_ / "shadow.vtm").blocks.size());
}

}  // namespace
}  // namespace gnomon
