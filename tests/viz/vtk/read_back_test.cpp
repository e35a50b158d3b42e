#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPoints.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "gnomon/shadow_mesh.h"
#include "gnomon/writer.h"
#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"
#include "tests/viz/vtk/read_back.h"

namespace gnomon {
namespace {

using testing::ElementsAre;

/// The sample result, written and read back by VTK's own readers.
class WrittenShadow : public testing::Test {
 protected:
  void write(const SampleResult& sample, OutputFormat format = OutputFormat::vtm) {
    write_shadow(sample.result(), folder_.path(), {{format}});
    manifest_ = read_json(folder_ / "manifest.json");
    tree_ = format == OutputFormat::vtm ? read_multiblock(folder_ / "shadow.vtm")
                                        : read_partitioned(folder_ / "shadow.vtpc");
  }

  vtkPointSet& block(const std::string& name) { return *tree_.blocks.at(name); }

  /// Every block of the manifest that has cells is in the file, with as many points and cells, and no other is.
  void expect_blocks_of_the_manifest() {
    std::size_t expected = 0;
    for (const auto& listed : manifest_.at("blocks")) {
      if (listed.at("empty")) continue;
      ++expected;
      const std::string name = listed.at("name");
      ASSERT_TRUE(tree_.blocks.contains(name)) << name;
      ASSERT_NE(tree_.blocks[name], nullptr) << name;
      EXPECT_EQ(block(name).GetNumberOfPoints(), listed.at("points").get<vtkIdType>()) << name;
      EXPECT_EQ(block(name).GetNumberOfCells(), listed.at("cells").get<vtkIdType>()) << name;
    }
    EXPECT_EQ(tree_.blocks.size(), expected);
  }

  TemporaryFolder folder_;
  nlohmann::json manifest_;
  ReadTree tree_;
};

double cell_value(vtkPointSet& block, const char* array, vtkIdType cell) {
  return block.GetCellData()->GetArray(array)->GetComponent(cell, 0);
}

TEST_F(WrittenShadow, HoldsTheBlocksOfItsManifest) {
  write(SampleResult());
  expect_blocks_of_the_manifest();
  EXPECT_EQ(tree_.blocks.size(), 11u);
  for (const char* name : {"scene/lights/lamp", "scene/blockers/table", "scene/blockers/post", "scene/receivers/floor",
                           "volumes/lamp/table/occlusion", "volumes/lamp/table/umbra", "volumes/lamp/table/penumbra",
                           "solids/lamp/table/umbra", "solids/lamp/table/penumbra", "extremal_planes/lamp/table",
                           "receivers/lamp/floor/faces"}) {
    EXPECT_TRUE(tree_.blocks.contains(name)) << name;
  }
}

TEST_F(WrittenShadow, HoldsTheSameBlocksAsAPartitionedCollection) {
  write(SampleResult(), OutputFormat::vtpc);
  expect_blocks_of_the_manifest();
  EXPECT_EQ(field_text(tree_.fields, "scene"), "sample.scene.json");
}

TEST_F(WrittenShadow, OfAllBlockersTogetherTellsTheBlockerOfEveryFacet) {
  SampleResult sample;
  MergedResult all{0, 0, "lamp", std::string(MergedResult::all_blockers), {}, {"table", "post"}, {0, 1}};
  const Light sun = DirectionalLight{{0, 0, -1}};
  const auto square = [](double x) {
    return ConvexBlocker(ConvexPolygon::from_points({{x, 0, 1}, {x + 1, 0, 1}, {x + 1, 1, 1}, {x, 1, 1}}));
  };
  const std::vector<ConvexBlocker> parts{square(0), square(3)};
  all.occlusion = merged_occlusion(sun, parts, {{-9, -9, 0}, {9, 9, 9}});
  sample.result().merged.push_back(all);
  write(sample);
  expect_blocks_of_the_manifest();
  vtkPointSet& merged = block("volumes/lamp/all#blockers/occlusion_merged");
  EXPECT_TRUE(is_closed_surface(merged));
  EXPECT_NEAR(enclosed_volume(merged), 2, 1e-12);
  std::map<int, int> cells;
  for (vtkIdType c = 0; c < merged.GetNumberOfCells(); ++c) {
    const int blocker = static_cast<int>(cell_value(merged, "blocker_id", c));
    EXPECT_EQ(blocker, merged.GetCell(c)->GetPoints()->GetPoint(0)[0] > 2 ? 1 : 0);
    ++cells[blocker];
  }
  EXPECT_THAT(cells, ElementsAre(testing::Pair(0, 12), testing::Pair(1, 12)));
}

TEST_F(WrittenShadow, ListsEmptyBlocksInTheManifestOnly) {
  SampleResult sample;
  remove_umbra(sample.result());
  write(sample);
  expect_blocks_of_the_manifest();
  EXPECT_FALSE(tree_.blocks.contains("volumes/lamp/table/umbra"));
  int empty = 0;
  for (const auto& listed : manifest_.at("blocks")) {
    if (!listed.at("empty")) continue;
    ++empty;
    EXPECT_TRUE(listed.at("file").is_null());
    EXPECT_EQ(listed.at("cells"), 0);
    EXPECT_EQ(listed.at("path").back(), "umbra");
  }
  EXPECT_EQ(empty, 2);
}

TEST_F(WrittenShadow, GivesEveryBlockThoseCellArraysThatSayAnything) {
  write(SampleResult());
  using Names = std::vector<std::string>;
  const auto arrays_of = [&](const std::string& name) {
    vtkCellData& arrays = *block(name).GetCellData();
    Names names;
    for (int i = 0; i < arrays.GetNumberOfArrays(); ++i) names.emplace_back(arrays.GetArrayName(i));
    return names;
  };
  const Names all = {"region",     "light_id",     "blocker_id",          "facet_id",        "facet_kind",
                     "edge_index", "vertex_index", "discontinuity_order", "visible_fraction"};
  const Names of_volume(all.begin(), all.begin() + 7);
  EXPECT_EQ(arrays_of("scene/lights/lamp"), (Names{"light_id", "facet_id"}));
  EXPECT_EQ(arrays_of("volumes/lamp/table/penumbra"), of_volume);
  EXPECT_EQ(arrays_of("receivers/lamp/floor/faces"), (Names{"region", "light_id", "facet_id", "visible_fraction"}));
  Names described;
  for (const auto& array : manifest_.at("cell_arrays")) described.push_back(array.at("name"));
  EXPECT_EQ(described, all);
  for (const auto& listed : manifest_.at("blocks")) {
    if (listed.at("empty")) continue;
    EXPECT_EQ(listed.at("cell_arrays").get<Names>(), arrays_of(listed.at("name")));
  }
}

TEST_F(WrittenShadow, WritesNoCellArrayThatHoldsNothing) {
  write(SampleResult());
  std::map<std::string, std::string> none;
  for (const auto& array : manifest_.at("cell_arrays")) none[array.at("name")] = array.at("none");
  for (const auto& [name, data] : tree_.blocks) {
    for (int i = 0; i < data->GetCellData()->GetNumberOfArrays(); ++i) {
      vtkDataArray* array = data->GetCellData()->GetArray(i);
      bool says_something = false;
      for (vtkIdType cell = 0; cell < array->GetNumberOfTuples(); ++cell) {
        const double value = array->GetComponent(cell, 0);
        says_something |= !std::isnan(value) && value != std::stod(none.at(array->GetName()));
      }
      EXPECT_TRUE(says_something) << array->GetName() << " of " << name;
    }
  }
}

TEST_F(WrittenShadow, NumbersRegionsAndFacetsAsDocumented) {
  write(SampleResult());
  EXPECT_EQ(cell_value(block("volumes/lamp/table/umbra"), "region", 0), 2);
  EXPECT_EQ(cell_value(block("volumes/lamp/table/umbra"), "visible_fraction", 0), 0);
  EXPECT_EQ(cell_value(block("volumes/lamp/table/penumbra"), "region", 0), 1);
  vtkPointSet& umbra = block("volumes/lamp/table/umbra");
  // Triangles 6 and 7 make up the side through the blocker's edge 1, which is the fourth facet.
  EXPECT_EQ(cell_value(umbra, "facet_id", 6), 3);
  EXPECT_EQ(cell_value(umbra, "facet_kind", 6), 3);
  EXPECT_EQ(cell_value(umbra, "edge_index", 7), 1);
  EXPECT_EQ(cell_value(umbra, "vertex_index", 7), 0);
  EXPECT_EQ(cell_value(block("scene/lights/lamp"), "light_id", 0), 0);
  EXPECT_EQ(cell_value(block("scene/blockers/post"), "blocker_id", 0), 1);
}

TEST_F(WrittenShadow, ReadsBackTheSameDoubles) {
  SampleResult sample;
  const double odd = std::nextafter(1.0 / 3, 1);
  const double tiny = std::numeric_limits<double>::denorm_min();
  sample.result().pairs[0].meshes.umbra.vertices[0] = {odd, -tiny, 1e300};
  sample.result().clip_box.min = {odd, -1e300, tiny};
  write(sample);
  double point[3];
  block("volumes/lamp/table/umbra").GetPoint(0, point);
  EXPECT_THAT(point, ElementsAre(odd, -tiny, 1e300));
  for (const auto& [name, data] : tree_.blocks) EXPECT_EQ(data->GetPoints()->GetDataType(), VTK_DOUBLE) << name;
  vtkDataArray* box = tree_.fields->GetArray("clip_box");
  ASSERT_EQ(box->GetNumberOfValues(), 6);
  EXPECT_EQ(box->GetComponent(0, 0), odd);
  EXPECT_EQ(box->GetComponent(1, 0), -1e300);
  EXPECT_EQ(box->GetComponent(2, 0), tiny);
}

TEST_F(WrittenShadow, HasClosedSurfacesWithOutwardNormals) {
  write(SampleResult());
  const std::map<std::string, double> volumes = {{"occlusion", 59.25}, {"umbra", 23.25}, {"penumbra", 36}};
  for (const auto& [name, volume] : volumes) {
    vtkPointSet& surface = block("volumes/lamp/table/" + name);
    EXPECT_TRUE(is_closed_surface(surface)) << name;
    EXPECT_DOUBLE_EQ(enclosed_volume(surface), volume) << name;
    EXPECT_DOUBLE_EQ(surface.GetFieldData()->GetArray("volume_total")->GetComponent(0, 0), volume) << name;
  }
  EXPECT_TRUE(is_closed_surface(block("scene/blockers/post")));
  EXPECT_GT(enclosed_volume(block("scene/blockers/post")), 0);
}

TEST_F(WrittenShadow, HasTetrahedraThatFillTheVolumes) {
  write(SampleResult());
  for (const auto& [name, volume] : {std::tuple{"umbra", 23.25}, std::tuple{"penumbra", 36.0}}) {
    vtkPointSet& solid = block(std::string("solids/lamp/table/") + name);
    for (vtkIdType i = 0; i < solid.GetNumberOfCells(); ++i) EXPECT_EQ(solid.GetCellType(i), VTK_TETRA);
    EXPECT_DOUBLE_EQ(filled_volume(solid), volume);
  }
}

TEST_F(WrittenShadow, SaysWhereItComesFromOnRootAndLeaves) {
  write(SampleResult());
  std::vector<vtkFieldData*> all = {tree_.fields};
  for (const auto& [name, data] : tree_.blocks) all.push_back(data->GetFieldData());
  for (vtkFieldData* fields : all) {
    EXPECT_EQ(field_text(fields, "producer"), "gnomon");
    EXPECT_NE(field_text(fields, "version"), "none");
    EXPECT_EQ(field_text(fields, "scene"), "sample.scene.json");
    EXPECT_EQ(field_text(fields, "length_unit"), "m");
    ASSERT_NE(fields->GetArray("clip_box"), nullptr);
    EXPECT_EQ(fields->GetArray("clip_box")->GetNumberOfValues(), 6);
    EXPECT_EQ(fields->GetAbstractArray("volume"), nullptr);
  }
  EXPECT_EQ(field_text(tree_.fields, "unbounded"), "1");
  EXPECT_EQ(field_text(tree_.fields, "umbra_volume_exact"), "93/4");
  EXPECT_EQ(field_text(block("volumes/lamp/table/umbra").GetFieldData(), "unbounded"), "1");
  EXPECT_EQ(field_text(block("volumes/lamp/table/umbra").GetFieldData(), "volume_exact"), "93/4");
  EXPECT_EQ(field_text(block("scene/receivers/floor").GetFieldData(), "unbounded"), "0");
}

TEST_F(WrittenShadow, NamesPairsThatAreNotSupported) {
  write(SampleResult());
  const auto& pairs = manifest_.at("pairs");
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_TRUE(pairs[0].at("supported"));
  EXPECT_EQ(pairs[0].at("position"), "standard");
  EXPECT_EQ(pairs[0].at("umbra").at("volume_in_box_exact"), "93/4");
  EXPECT_FALSE(pairs[1].at("supported"));
  EXPECT_EQ(pairs[1].at("blocker"), "post");
}

TEST_F(WrittenShadow, KeepsNamesThatAreNoFileNames) {
  const std::string light = "../a/b \"c\" <d> & ü";
  const std::string blocker(300, '%');
  write(SampleResult(light, blocker));
  expect_blocks_of_the_manifest();
  EXPECT_TRUE(tree_.blocks.contains("volumes/" + light + "/" + blocker + "/umbra"));
  for (const auto& listed : manifest_.at("blocks")) {
    const std::string file = listed.at("file");
    EXPECT_TRUE(file.starts_with("shadow/"));
    EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / file)) << file;
    EXPECT_EQ(file.find("/.."), std::string::npos);
  }
}

}  // namespace
}  // namespace gnomon
