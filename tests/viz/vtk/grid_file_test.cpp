#include "gnomon/writer.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <array>
#include <limits>
#include <stdexcept>

#include "tests/viz/temporary_folder.h"

namespace gnomon {
namespace {

TEST(GridFile, ReadsBackPointForPointWithItsValues) {
  const TemporaryFolder folder;
  const PointGrid grid = PointGrid::in_box({3, 2, 1}, {{0, 0, 0}, {1, 0.3, 2}});
  const GridValues values{"_lamp", {0, 1, 2, 3, 0, 1}, {1, .5, 0, 0, 1, .25}, {0, 1e-15, 0, 0, 0, 1e-14}};
  const std::filesystem::path file = folder.path() / "grid.vti";
  write_grid(grid, {&values, 1}, Scene{}, file);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 6);
  for (int i = 0; i < 6; ++i) {
    const double* p = data->GetPoint(i);
    const auto k = static_cast<std::size_t>(i);
    EXPECT_EQ((Point3{p[0], p[1], p[2]}), grid.point(k));
    EXPECT_EQ(data->GetPointData()->GetArray("region_lamp")->GetTuple1(i), values.region[k]);
    EXPECT_EQ(data->GetPointData()->GetArray("visible_fraction_lamp")->GetTuple1(i), values.visible_fraction[k]);
    EXPECT_EQ(data->GetPointData()->GetArray("error_bound_lamp")->GetTuple1(i), values.error_bound[k]);
  }
  EXPECT_EQ(grid.point(5), (Point3{1, 0.3, 1}));
}

TEST(GridFile, HoldsIrradianceLightByLightAndRadianceAsVectors) {
  const TemporaryFolder folder;
  const PointGrid grid = PointGrid::in_box({2, 1, 1}, {{0, 0, 0}, {1, 1, 1}});
  const GridValues values{"_lamp", {0, 1}, {1, .5}, {0, 0}, {3, 4}, {1e-15, 2e-15}};
  const std::filesystem::path file = folder.path() / "grid.vti";
  write_grid(grid, {&values, 1}, Scene{}, file, {{1, 2, 3, 4, 5, 6}, {.1, .2, .3, .4, .5, .6}});
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPointData* data = reader->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetArray("irradiance_lamp")->GetTuple1(1), 4);
  EXPECT_EQ(data->GetArray("irradiance_error_bound_lamp")->GetTuple1(1), 2e-15);
  ASSERT_EQ(data->GetArray("radiance")->GetNumberOfComponents(), 3);
  EXPECT_EQ(data->GetArray("radiance")->GetComponent(1, 2), 6);
  EXPECT_EQ(data->GetArray("radiance_error_bound")->GetComponent(1, 0), .4);
}

TEST(GridFile, KnowsGridsWhosePointsFallTogetherOrOverflow) {
  const double large = 1e308, tiny = std::numeric_limits<double>::denorm_min();
  const auto distinct = [](std::array<std::uint32_t, 3> shape, const Box3& box) {
    return PointGrid::in_box(shape, box).has_distinct_points();
  };
  EXPECT_TRUE(distinct({3, 3, 3}, {{-1, -1, -1}, {1, 1, 1}}));
  EXPECT_TRUE(distinct({3, 3, 1}, {{-1, -1, 0}, {1, 1, 0}}));
  EXPECT_TRUE(distinct({2, 2, 2}, {{0, 0, 0}, {tiny, 1e-300, large}}));
  EXPECT_FALSE(distinct({3, 3, 3}, {{-large, -large, -large}, {large, large, large}}));
  EXPECT_FALSE(distinct({1, 1, 1}, {{-large, 0, 0}, {large, 1, 1}}));
  EXPECT_FALSE(distinct({3, 2, 2}, {{0, 0, 0}, {tiny, 1, 1}}));
  EXPECT_FALSE(distinct({2, 100, 2}, {{0, 1e16, 0}, {1, 1e16 + 4, 1}}));
  EXPECT_FALSE(distinct({2, 2, 2}, {{0, 0, 0}, {1, 1, 0}}));
}

TEST(GridFile, NamesTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  const PointGrid grid = PointGrid::in_box({1, 1, 1}, {{0, 0, 0}, {1, 1, 1}});
  std::filesystem::create_directory(folder.path() / "taken.vti");
  EXPECT_THROW(write_grid(grid, {}, Scene{}, folder.path() / "taken.vti"), std::runtime_error);
}

}  // namespace
}  // namespace gnomon
