#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "gnomon/writer.h"
#include "viz/vtk/block_file.h"
#include "viz/vtk/field_data.h"
#include "viz/vtk/staged_folder.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon {
namespace {

vtkDoubleArray& added_array(vtkPolyData& data, const char* name) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  data.GetCellData()->AddArray(array);
  return *array;
}

}  // namespace

void write_view_surfaces(std::span<const SurfaceRow> rows, const Scene& scene, const std::filesystem::path& directory) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> ids;
  ids->SetName("surface_id");
  data->GetCellData()->AddArray(ids);
  vtkDoubleArray &sums = added_array(*data, "row_sum"), &residuals = added_array(*data, "residual"),
                 &bounds = added_array(*data, "row_sum_bound");
  std::vector<std::string> names;
  for (const SurfaceRow& row : rows) {
    for (const ConvexPolygon& piece : *row.shape) {
      cells->InsertNextCell(static_cast<int>(piece.points().size()));
      for (const Point3& p : piece.points()) cells->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
      ids->InsertNextValue(static_cast<int>(names.size()));
      sums.InsertNextValue(row.sum);
      residuals.InsertNextValue(1 - row.sum);
      bounds.InsertNextValue(row.sum_bound);
    }
    names.push_back(row.name);
  }
  data->SetPoints(points);
  data->SetPolys(cells);
  viz::add_field_data(*data->GetFieldData(), {{"producer", std::vector<std::string>{"gnomon"}},
                                              {"version", std::vector<std::string>{GNOMON_VERSION}},
                                              {"scene", std::vector<std::string>{facts(scene).source}},
                                              {"length_unit", std::vector<std::string>{facts(scene).length_unit}},
                                              {"surface_names", names}});
  viz::StagedFolder folder(directory);
  viz::write_data(*data, folder.add("view_factors.vtp"));
  folder.publish();
}

}  // namespace gnomon
