#include "gnomon/writer.h"

#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "viz/vtk/field_data.h"
#include "viz/vtk/quiet_vtk.h"
#include "viz/vtk/staged_folder.h"
#include "viz/vtk/xml.h"

namespace gnomon {
namespace {

template <class Array, class Values>
void add_array(vtkImageData& data, const std::string& name, const Values& values, int components = 1) {
  if (values.empty()) return;
  vtkNew<Array> array;
  array->SetName(viz::xml_escaped(name).c_str());  // VTK writes names as they are
  array->SetNumberOfComponents(components);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data.GetPointData()->AddArray(array);
}

void write_image(vtkImageData& data, const viz::StagedFile& file) {
  const viz::QuietVtk quiet;
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(&data);
  writer->SetFileName(file.temporary.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  const bool done = writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
  if (!done || !quiet.words().empty()) {
    throw std::runtime_error("cannot write " + file.target.string() + ": " + quiet.words());
  }
}

double start(double low, double high, std::uint32_t count) {
  return count == 1 ? low + (high - low) / 2 : low;
}

double step(double low, double high, std::uint32_t count) {
  return count == 1 ? high - low : (high - low) / (count - 1);
}

/// Steps are smallest, beside a double's digits, at the end that is farther from zero.
bool has_distinct_places(double origin, double spacing, std::uint32_t count) {
  const double last = origin + static_cast<double>(count - 1) * spacing;
  if (!std::isfinite(origin) || !std::isfinite(last) || !std::isfinite(spacing)) return false;
  if (count == 1) return true;  // and in the plane no spacing along z
  return origin + spacing > origin && last > origin + static_cast<double>(count - 2) * spacing;
}

}  // namespace

PointGrid PointGrid::in_box(const std::array<std::uint32_t, 3>& shape, const Box3& box) {
  const Point3& a = box.min;
  const Point3& b = box.max;
  return {shape,
          {start(a.x, b.x, shape[0]), start(a.y, b.y, shape[1]), start(a.z, b.z, shape[2])},
          {step(a.x, b.x, shape[0]), step(a.y, b.y, shape[1]), step(a.z, b.z, shape[2])}};
}

bool PointGrid::has_distinct_points() const {
  return has_distinct_places(origin.x, spacing.x, shape[0]) && has_distinct_places(origin.y, spacing.y, shape[1]) &&
         has_distinct_places(origin.z, spacing.z, shape[2]);
}

Point3 PointGrid::point(std::size_t index) const {
  const auto i = static_cast<double>(index % shape[0]);
  const auto j = static_cast<double>(index / shape[0] % shape[1]);
  const std::size_t layer = index / shape[0] / shape[1];
  const auto k = static_cast<double>(layer);
  return {origin.x + i * spacing.x, origin.y + j * spacing.y, origin.z + k * spacing.z};
}

void write_grid(const PointGrid& grid, std::span<const GridValues> values, const Scene& scene,
                const std::filesystem::path& file, const GridRadiance& radiance) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(static_cast<int>(grid.shape[0]), static_cast<int>(grid.shape[1]),
                      static_cast<int>(grid.shape[2]));
  data->SetOrigin(grid.origin.x, grid.origin.y, grid.origin.z);
  data->SetSpacing(grid.spacing.x, grid.spacing.y, grid.spacing.z);
  for (const GridValues& light : values) {
    add_array<vtkUnsignedCharArray>(*data, "region" + light.suffix, light.region);
    add_array<vtkDoubleArray>(*data, "visible_fraction" + light.suffix, light.visible_fraction);
    add_array<vtkDoubleArray>(*data, "error_bound" + light.suffix, light.error_bound);
    add_array<vtkDoubleArray>(*data, "irradiance" + light.suffix, light.irradiance);
    add_array<vtkDoubleArray>(*data, "irradiance_error_bound" + light.suffix, light.irradiance_error_bound);
  }
  add_array<vtkDoubleArray>(*data, "radiance", radiance.radiance, 3);
  add_array<vtkDoubleArray>(*data, "radiance_error_bound", radiance.error_bound, 3);
  viz::add_field_data(*data->GetFieldData(), {{"producer", std::vector<std::string>{"gnomon"}},
                                              {"version", std::vector<std::string>{GNOMON_VERSION}},
                                              {"scene", std::vector<std::string>{facts(scene).source}},
                                              {"length_unit", std::vector<std::string>{facts(scene).length_unit}}});
  viz::StagedFolder folder(file.parent_path());
  write_image(*data, folder.add(file.filename().string()));
  folder.publish();
}

}  // namespace gnomon
