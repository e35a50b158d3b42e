#include "viz/vtk/facet_groups.h"

#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <utility>

namespace gnomon::viz {
namespace {

enum class Cells { faces, lines };

bool is_one_of(int cell_type, Cells cells) {
  const bool line = cell_type == VTK_LINE || cell_type == VTK_POLY_LINE;
  const bool face = cell_type == VTK_TRIANGLE || cell_type == VTK_QUAD || cell_type == VTK_POLYGON;
  return cells == Cells::lines ? line : face;
}

/// The cells of that sort that have the value in an array.
vtkSmartPointer<vtkPolyData> cells_with(vtkPolyData& data, Cells sort, const char* array, int value) {
  vtkDataArray* values = data.GetCellData()->GetArray(array);
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(data.GetPoints());
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; values != nullptr && i < data.GetNumberOfCells(); ++i) {
    if (!is_one_of(data.GetCellType(i), sort) || values->GetComponent(i, 0) != value) continue;
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    data.GetCellPoints(i, size, points);
    cells->InsertNextCell(size, points);
  }
  sort == Cells::lines ? part->SetLines(cells) : part->SetPolys(cells);
  return part;
}

std::vector<OrderedFacets> ordered(vtkPolyData& data, Cells sort) {
  std::vector<OrderedFacets> list;
  for (int order = 0; order < 3; ++order) {
    auto part = cells_with(data, sort, "discontinuity_order", order);
    if (part->GetNumberOfCells() == 0) continue;
    list.push_back({"D" + std::to_string(order), palette.discontinuities[static_cast<std::size_t>(order)], part});
  }
  return list;
}

}  // namespace

std::vector<RegionFacets> region_facets(vtkPolyData& surface) {
  const std::vector<std::pair<std::string, Color>> regions = {{"lit", palette.lit},
                                                              {"penumbra", palette.penumbra},
                                                              {"umbra", palette.umbra},
                                                              {"unlit", palette.unlit},
                                                              {"unresolved_eee", palette.unresolved_eee}};
  std::vector<RegionFacets> list;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    auto part = cells_with(surface, Cells::faces, "region", static_cast<int>(i));
    if (part->GetNumberOfCells() > 0) list.push_back({static_cast<int>(i), regions[i].first, regions[i].second, part});
  }
  return list;
}

std::vector<OrderedFacets> ordered_surfaces(vtkPolyData& surface) {
  return ordered(surface, Cells::faces);
}

std::vector<OrderedFacets> ordered_lines(vtkPolyData& surface) {
  return ordered(surface, Cells::lines);
}

}  // namespace gnomon::viz
