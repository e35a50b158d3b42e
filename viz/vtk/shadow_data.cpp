#include "viz/vtk/shadow_data.h"

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "gnomon/names.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

CellName with_facet(CellName cell, const FacetName& facet, std::size_t facet_id) {
  cell.facet_id = static_cast<std::int32_t>(facet_id);
  cell.facet_kind = static_cast<std::uint8_t>(facet.kind);
  if (facet.edge_index) cell.edge_index = static_cast<std::int32_t>(*facet.edge_index);
  if (facet.vertex_index) cell.vertex_index = static_cast<std::int32_t>(*facet.vertex_index);
  return cell;
}

void append(std::vector<Point3>& points, const std::vector<Point3>& more) {
  points.insert(points.end(), more.begin(), more.end());
}

/// The tetrahedra over a convex cell's faces, with its first vertex as their apex. VTK leaves some out where it divides
/// polyhedra by itself, and measures those too small.
std::vector<std::array<std::size_t, 4>> tetrahedra(const VolumeCells::Cell& cell) {
  std::vector<std::array<std::size_t, 4>> result;
  const std::size_t apex = cell.faces.front().front();
  for (const VolumeCells::Face& face : cell.faces) {
    if (std::find(face.begin(), face.end(), apex) != face.end()) continue;
    // A VTK_TETRA's first three points run counterclockwise seen from the fourth.
    for (std::size_t k = 1; k + 1 < face.size(); ++k) result.push_back({face[0], face[k + 1], face[k], apex});
  }
  return result;
}

void add_part_array(vtkDataSet& data, const std::vector<std::int32_t>& parts) {
  vtkNew<vtkIntArray> array;
  array->SetName("part_id");
  for (const std::int32_t part : parts) array->InsertNextValue(part);
  data.GetCellData()->AddArray(array);
}

}  // namespace

CellName volume_cell(const PairResult& pair, std::string_view volume) {
  CellName cell;
  cell.light_id = static_cast<std::int32_t>(pair.light_id);
  cell.blocker_id = static_cast<std::int32_t>(pair.blocker_id);
  if (volume == "umbra" || volume == "umbra_pockets") {
    cell.region = static_cast<std::uint8_t>(Region::umbra);
    cell.visible_fraction = 0;
  } else if (volume == "penumbra") {
    cell.region = static_cast<std::uint8_t>(Region::penumbra);
  }
  return cell;
}

void ShadowSurface::add(const VolumeMesh& mesh, const CellName& common, std::span<const std::uint32_t> facet_blockers) {
  const auto first_point = static_cast<vtkIdType>(points_.size());
  for (const MeshTriangle& triangle : mesh.triangles) {
    insert_cell(*polygons_, triangle.vertices, first_point);
    names_.push_back(with_facet(common, mesh.facets[triangle.facet], facet_count_ + triangle.facet));
    if (!facet_blockers.empty()) names_.back().blocker_id = static_cast<std::int32_t>(facet_blockers[triangle.facet]);
    parts_.push_back(part_count_);
  }
  append(points_, mesh.vertices);
  facet_count_ += mesh.facets.size();
  ++part_count_;
}

void ShadowSurface::add(const std::vector<PlanePolygon>& planes, const CellName& common) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].vertices.empty()) continue;
    std::vector<std::size_t> indices(planes[i].vertices.size());
    std::iota(indices.begin(), indices.end(), points_.size());
    insert_cell(*polygons_, indices);
    append(points_, planes[i].vertices);
    names_.push_back(with_facet(common, planes[i].name, facet_count_ + i));
    parts_.push_back(part_count_);
  }
  facet_count_ += planes.size();
  ++part_count_;
}

vtkSmartPointer<vtkPointSet> ShadowSurface::data() const {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points_));
  data->SetPolys(polygons_);
  add_cell_arrays(*data, names_);
  if (part_count_ > 1) add_part_array(*data, parts_);
  return data;
}

void ShadowSolid::add(const VolumeCells& cells, const CellName& common) {
  for (const VolumeCells::Cell& cell : cells.cells) {
    for (const auto& corners : tetrahedra(cell)) {
      insert_cell(*tetrahedra_, corners, static_cast<vtkIdType>(points_.size()));
      names_.push_back(common);
      parts_.push_back(part_count_);
    }
  }
  append(points_, cells.vertices);
  ++part_count_;
}

vtkSmartPointer<vtkPointSet> ShadowSolid::data() const {
  auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
  data->SetPoints(vtk_points(points_));
  data->SetCells(VTK_TETRA, tetrahedra_);
  add_cell_arrays(*data, names_);
  if (part_count_ > 1) add_part_array(*data, parts_);
  return data;
}

}  // namespace gnomon::viz
