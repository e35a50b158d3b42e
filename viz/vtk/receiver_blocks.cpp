#include "viz/vtk/receiver_blocks.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <utility>

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

/// An array with the numbers of each value; none without values.
template <class Values, class Numbers>
void add_point_array(vtkPointSet& data, const char* name, const Values& values, Numbers numbers) {
  if (values.empty()) return;
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(numbers(values.front()).size()));
  for (const auto& value : values) {
    for (const double number : numbers(value)) array->InsertNextValue(number);
  }
  data.GetPointData()->AddArray(array);
}

}  // namespace

SideDrawing side_drawing(SideResult side) {
  SideDrawing result;
  for (const ReceiverResult& piece : side) {
    MeshDrawing drawing = piece.mesh.drawing();
    result.points.insert(result.points.end(), drawing.points.begin(), drawing.points.end());
    result.chord_error = std::max(result.chord_error, drawing.chord_error);
    result.chords_cross = result.chords_cross || drawing.chords_cross;
    if (!piece.visible_fractions.empty()) {
      result.fractions.insert(result.fractions.end(), piece.visible_fractions.begin(), piece.visible_fractions.end());
      // Arcs bound umbrae, which they belong to.
      result.fractions.resize(result.points.size(), 0);
    }
    result.irradiance.insert(result.irradiance.end(), piece.irradiance.begin(), piece.irradiance.end());
    result.radiance.insert(result.radiance.end(), piece.radiance.begin(), piece.radiance.end());
    result.pieces.push_back(std::move(drawing));
  }
  return result;
}

Fields receiver_fields(const ShadowResult& frame, SideResult side, const SideDrawing& drawing) {
  Fields fields = leaf_fields(frame, false);
  fields.push_back({"light", std::vector<std::string>{side.front().light}});
  fields.push_back({"receiver", std::vector<std::string>{side.front().side}});
  const auto areas = areas_of(side);
  for (std::size_t k = 0; k < areas.size(); ++k) {
    const std::string region(name(static_cast<ReceiverRegion>(k)));
    fields.push_back({region + "_area", std::vector<double>{areas[k].nearest}});
    if (areas[k].exact) fields.push_back({region + "_area_exact", std::vector<std::string>{*areas[k].exact}});
  }
  if (drawing.chord_error > 0) fields.push_back({"chord_error", std::vector<double>{drawing.chord_error}});
  if (drawing.chords_cross) fields.push_back({"chords_cross", std::vector<double>{1}});
  return fields;
}

void add_point_arrays(vtkPointSet& data, const SideDrawing& drawing) {
  add_point_array(data, "visible_fraction", drawing.fractions, [](double f) { return std::array{f}; });
  add_point_array(data, "irradiance", drawing.irradiance, [](const Irradiance& e) { return std::array{e.value}; });
  add_point_array(data, "irradiance_error_bound", drawing.irradiance,
                  [](const Irradiance& e) { return std::array{e.error_bound}; });
  add_point_array(data, "radiance", drawing.radiance, [](const RadianceRgb& r) {
    return std::array{r[0].value, r[1].value, r[2].value};
  });
  add_point_array(data, "radiance_error_bound", drawing.radiance, [](const RadianceRgb& r) {
    return std::array{r[0].error_bound, r[1].error_bound, r[2].error_bound};
  });
}

void append_receiver_faces(std::vector<Block>& blocks, const ShadowResult& frame, SideResult side,
                           const SideDrawing& drawing) {
  vtkNew<vtkCellArray> cells;
  std::vector<CellName> names;
  vtkIdType first_point = 0;
  std::size_t first_face = 0;
  for (std::size_t k = 0; k < side.size(); ++k) {
    for (const ReceiverTriangle& triangle : drawing.pieces[k].triangles) {
      insert_cell(*cells, triangle.vertices, first_point);
      names.push_back(face_cell(side[k], triangle.face, first_face));
    }
    first_point += static_cast<vtkIdType>(drawing.pieces[k].points.size());
    first_face += side[k].mesh.faces().size();
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(drawing.points));
  data->SetPolys(cells);
  add_cell_arrays(*data, names);
  add_point_arrays(*data, drawing);
  append_block(blocks, {{"receivers", side.front().light, side.front().side, "faces"},
                        "receiver_faces",
                        receiver_fields(frame, side, drawing),
                        data});
}

void append_painted_receiver(std::vector<Block>& blocks, const ShadowResult& frame, const PaintedReceiver& painted) {
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : painted.triangles) insert_cell(*cells, triangle);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(painted.points));
  data->SetPolys(cells);
  SideDrawing arrays;
  arrays.irradiance = painted.irradiance;
  add_point_arrays(*data, arrays);
  Fields fields = leaf_fields(frame, false);
  fields.push_back({"light", std::vector<std::string>{painted.light}});
  fields.push_back({"receiver", std::vector<std::string>{painted.side}});
  append_block(blocks, {{"receivers", painted.light, painted.side, "irradiance"}, "receiver_irradiance", fields, data});
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
