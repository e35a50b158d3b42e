#include "viz/vtk/receiver_blocks.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "gnomon/receiver_mesh.h"
#include "viz/vtk/cell_arrays.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

CellName face_cell(const ReceiverResult& piece, std::size_t face, std::size_t first_face) {
  CellName cell;
  cell.light_id = static_cast<std::int32_t>(piece.light_id);
  cell.facet_id = static_cast<std::int32_t>(first_face + face);
  const ReceiverRegion region = piece.mesh.faces()[face].region;
  cell.region = static_cast<std::uint8_t>(region);
  if (region == ReceiverRegion::lit) cell.visible_fraction = 1;
  if (region == ReceiverRegion::umbra || region == ReceiverRegion::unlit) cell.visible_fraction = 0;
  return cell;
}

}  // namespace

SidePoints side_points(SideResult side) {
  SidePoints result;
  for (const ReceiverResult& piece : side) {
    const std::vector<Point3> points = piece.mesh.vertices();
    result.points.insert(result.points.end(), points.begin(), points.end());
    result.fractions.insert(result.fractions.end(), piece.visible_fractions.begin(), piece.visible_fractions.end());
  }
  return result;
}

Fields receiver_fields(const ShadowResult& frame, SideResult side) {
  Fields fields = leaf_fields(frame, false);
  fields.push_back({"light", std::vector<std::string>{side.front().light}});
  fields.push_back({"receiver", std::vector<std::string>{side.front().side}});
  const auto areas = areas_of(side);
  for (std::size_t k = 0; k < areas.size(); ++k) {
    const std::string region(name(static_cast<ReceiverRegion>(k)));
    fields.push_back({region + "_area", std::vector<double>{areas[k].nearest}});
    if (areas[k].exact) fields.push_back({region + "_area_exact", std::vector<std::string>{*areas[k].exact}});
  }
  return fields;
}

void add_vertex_fractions(vtkPointSet& data, const SidePoints& points) {
  if (points.fractions.empty()) return;
  vtkNew<vtkDoubleArray> array;
  array->SetName("visible_fraction");
  for (const double fraction : points.fractions) array->InsertNextValue(fraction);
  data.GetPointData()->AddArray(array);
}

void append_receiver_faces(std::vector<Block>& blocks, const ShadowResult& frame, SideResult side) {
  vtkNew<vtkCellArray> cells;
  std::vector<CellName> names;
  vtkIdType first_point = 0;
  std::size_t first_face = 0;
  for (const ReceiverResult& piece : side) {
    for (const ReceiverTriangle& triangle : piece.mesh.triangles()) {
      insert_cell(*cells, triangle.vertices, first_point);
      names.push_back(face_cell(piece, triangle.face, first_face));
    }
    first_point += static_cast<vtkIdType>(piece.mesh.vertex_count());
    first_face += piece.mesh.faces().size();
  }
  const SidePoints points = side_points(side);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points.points));
  data->SetPolys(cells);
  add_cell_arrays(*data, names);
  add_vertex_fractions(*data, points);
  append_block(blocks, {{"receivers", side.front().light, side.front().side, "faces"},
                        "receiver_faces",
                        receiver_fields(frame, side),
                        data});
}

}  // namespace gnomon::viz

namespace gnomon {

std::vector<SideResult> sides_of(std::span<const ReceiverResult> receivers) {
  std::vector<SideResult> sides;
  for (std::size_t first = 0; first < receivers.size();) {
    std::size_t last = first;
    while (last < receivers.size() && receivers[last].side == receivers[first].side &&
           receivers[last].light_id == receivers[first].light_id) {
      ++last;
    }
    sides.push_back(receivers.subspan(first, last - first));
    first = last;
  }
  return sides;
}

std::array<RegionArea, receiver_region_count> areas_of(SideResult side) {
  std::array<std::vector<RegionArea>, receiver_region_count> of_pieces;
  for (const ReceiverResult& piece : side) {
    const auto areas = piece.mesh.areas();
    for (std::size_t k = 0; k < areas.size(); ++k) of_pieces[k].push_back(areas[k]);
  }
  std::array<RegionArea, receiver_region_count> sums;
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = total_area(of_pieces[k]);
  return sums;
}

}  // namespace gnomon
