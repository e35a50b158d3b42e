#include "viz/picture_facets.h"

#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <utility>

#include "gnomon/shadow_volume.h"

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

std::string index_text(const PictureBlock& block, const char* array, vtkIdType cell) {
  vtkDataArray* values = block.data->GetCellData()->GetArray(array);
  return values == nullptr ? "?" : std::to_string(static_cast<int>(values->GetComponent(cell, 0)));
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

std::string plane_name(const PictureBlock& volume, vtkIdType cell) {
  vtkDataArray* kinds = volume.data->GetCellData()->GetArray("facet_kind");
  if (kinds == nullptr || volume.path.size() < 3) return {};
  const std::string& light = volume.path[1];
  const std::string& blocker = volume.path[2];
  const std::string edge = "edge " + index_text(volume, "edge_index", cell) + " of ";
  const std::string vertex = ", vertex " + index_text(volume, "vertex_index", cell) + " of ";
  switch (static_cast<FacetKind>(kinds->GetComponent(cell, 0))) {
    case FacetKind::blocker_face:
      return "face of " + blocker;
    case FacetKind::separating_blocker_plane:
      return "separating plane: " + edge + blocker + vertex + light;
    case FacetKind::separating_light_plane:
      return "separating plane: " + edge + light + vertex + blocker;
    case FacetKind::supporting_blocker_plane:
      return "supporting plane: " + edge + blocker + vertex + light;
    case FacetKind::clip_box:
      return "clip box";
    case FacetKind::light_plane:
      return "plane of " + light;
  }
  return {};
}

}  // namespace gnomon::viz
