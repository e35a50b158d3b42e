#include "viz/discontinuity_blocks.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>

#include "geometry/discontinuity/total_area.h"
#include "viz/cell_arrays.h"
#include "viz/vtk_cells.h"

namespace gnomon::viz {
namespace {

/// Texts of events, and which of them each cell bears.
struct EventCells {
  std::vector<std::string> names;
  std::vector<std::int32_t> of_cell;
};

std::string event_text(const DiscontinuityResult& result, const std::string& light, const std::string& receiver,
                       const EventName& name) {
  const auto text = [&](const EventElement& element) {
    return element_text(result, light, receiver, element) + "[" + std::to_string(element.index) + "]";
  };
  const std::string kind(gnomon::name(name.kind));
  if (name.kind == EventKind::coplanar_edges) return "edge " + text(name.vertex) + ", edge " + text(name.edge);
  if (name.kind == EventKind::horizon) return "horizon edge " + text(name.vertex) + ", edge " + text(name.edge);
  if (name.kind != EventKind::vertex_edge) return kind + " " + text(name.edge);
  return "vertex " + text(name.vertex) + ", edge " + text(name.edge);
}

void add_event_array(vtkPolyData& data, const EventCells& events) {
  vtkNew<vtkIntArray> array;
  array->SetName("event");
  for (const std::int32_t event : events.of_cell) array->InsertNextValue(event);
  data.GetCellData()->AddArray(array);
}

void add_fractions(vtkPolyData& data, const std::vector<double>& fractions) {
  if (fractions.empty()) return;
  vtkNew<vtkDoubleArray> array;
  array->SetName("visible_fraction");
  for (const double fraction : fractions) array->InsertNextValue(fraction);
  data.GetPointData()->AddArray(array);
}

std::int32_t blocker_id(const DiscontinuityResult& result, const EventName& name) {
  if (name.edge.of == EventOf::blocker) return static_cast<std::int32_t>(result.blocker_ids[name.edge.element]);
  if (name.vertex.of == EventOf::blocker) return static_cast<std::int32_t>(result.blocker_ids[name.vertex.element]);
  return -1;
}

CellName cell_of(const DiscontinuityResult& result, std::uint32_t light_id, const EventName& name) {
  CellName cell;
  cell.light_id = static_cast<std::int32_t>(light_id);
  cell.blocker_id = blocker_id(result, name);
  cell.edge_index = static_cast<std::int32_t>(name.edge.index);
  cell.vertex_index = name.kind == EventKind::vertex_edge ? static_cast<std::int32_t>(name.vertex.index) : -1;
  if (name.kind != EventKind::border) cell.discontinuity_order = name.order;
  return cell;
}

/// The vertices of all pieces, one after the other, and their visible fractions.
struct SidePoints {
  std::vector<Point3> points;
  std::vector<double> fractions;
};

SidePoints side_points(SideResult side) {
  SidePoints result;
  for (const ReceiverResult& piece : side) {
    const std::vector<Point3> points = piece.mesh.vertices();
    result.points.insert(result.points.end(), points.begin(), points.end());
    result.fractions.insert(result.fractions.end(), piece.visible_fractions.begin(), piece.visible_fractions.end());
  }
  return result;
}

vtkSmartPointer<vtkPolyData> faces(SideResult side, const SidePoints& points) {
  vtkNew<vtkCellArray> cells;
  std::vector<CellName> names;
  vtkIdType first_point = 0;
  std::size_t first_face = 0;
  for (const ReceiverResult& piece : side) {
    for (const ReceiverTriangle& triangle : piece.mesh.triangles()) {
      insert_cell(*cells, triangle.vertices, first_point);
      CellName cell;
      cell.light_id = static_cast<std::int32_t>(piece.light_id);
      cell.facet_id = static_cast<std::int32_t>(first_face + triangle.face);
      cell.region = static_cast<std::uint8_t>(piece.mesh.faces()[triangle.face].region);
      if (cell.region == 0) cell.visible_fraction = 1;
      if (cell.region == 2 || cell.region == 3) cell.visible_fraction = 0;
      names.push_back(cell);
    }
    first_point += static_cast<vtkIdType>(piece.mesh.vertex_count());
    first_face += piece.mesh.faces().size();
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points.points));
  data->SetPolys(cells);
  add_cell_arrays(*data, names);
  add_fractions(*data, points.fractions);
  return data;
}

/// Of several events along an edge the one of lowest order names it.
std::uint32_t leading_name(const ReceiverMesh& mesh, const MeshEdge& edge) {
  return *std::min_element(edge.names.begin(), edge.names.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t n) {
      return std::pair(mesh.names()[n].kind == EventKind::border, mesh.names()[n].order);
    };
    return key(a) < key(b);
  });
}

vtkSmartPointer<vtkPolyData> edges(const DiscontinuityResult& result, SideResult side, const SidePoints& points,
                                   std::vector<std::string>& event_names) {
  vtkNew<vtkCellArray> cells;
  std::vector<CellName> names;
  EventCells events;
  vtkIdType first_point = 0;
  for (const ReceiverResult& piece : side) {
    const std::size_t first_name = event_names.size();
    for (const EventName& name : piece.mesh.names()) {
      event_names.push_back(event_text(result, piece.light, piece.receiver, name));
    }
    for (const MeshEdge& edge : piece.mesh.edges()) {
      insert_cell(*cells, std::array{edge.source, edge.target}, first_point);
      const std::uint32_t name = leading_name(piece.mesh, edge);
      names.push_back(cell_of(result, piece.light_id, piece.mesh.names()[name]));
      events.of_cell.push_back(static_cast<std::int32_t>(first_name + name));
    }
    first_point += static_cast<vtkIdType>(piece.mesh.vertex_count());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points.points));
  data->SetLines(cells);
  add_cell_arrays(*data, names);
  add_event_array(*data, events);
  add_fractions(*data, points.fractions);
  return data;
}

Fields basic_fields(const DiscontinuityResult& result) {
  return leaf_fields(ShadowResult{result.scene, result.clip_box, {}}, false);
}

Fields receiver_fields(const DiscontinuityResult& result, SideResult side) {
  Fields fields = basic_fields(result);
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

void append_receiver(std::vector<Block>& blocks, const DiscontinuityResult& result, SideResult side) {
  const SidePoints points = side_points(side);
  const Fields fields = receiver_fields(result, side);
  const std::string& light = side.front().light;
  const std::string& receiver = side.front().side;
  append_block(blocks, {{"receivers", light, receiver, "faces"}, "receiver_faces", fields, faces(side, points)});
  std::vector<std::string> event_names;
  auto lines = edges(result, side, points, event_names);
  Fields edge_fields = fields;
  edge_fields.push_back({"event_names", std::move(event_names)});
  append_block(blocks, {{"receivers", light, receiver, "edges"}, "receiver_edges", edge_fields, lines});
}

void append_surfaces(std::vector<Block>& blocks, const DiscontinuityResult& result, const SurfaceResult& light,
                     int order) {
  vtkNew<vtkCellArray> cells;
  std::vector<CellName> names;
  std::vector<Point3> points;
  EventCells events;
  for (const DiscontinuitySurface& surface : light.surfaces) {
    if (surface.name.order != order) continue;
    for (const auto& polygon : surface.polygons) {
      std::vector<std::size_t> ids;
      for (const Point3& p : polygon) {
        ids.push_back(points.size());
        points.push_back(p);
      }
      insert_cell(*cells, ids);
      names.push_back(cell_of(result, light.light_id, surface.name));
      events.of_cell.push_back(static_cast<std::int32_t>(events.names.size()));
    }
    events.names.push_back(event_text(result, light.light, "", surface.name));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points));
  data->SetPolys(cells);
  add_cell_arrays(*data, names);
  add_event_array(*data, events);
  Fields fields = basic_fields(result);
  fields.push_back({"light", std::vector<std::string>{light.light}});
  if (!events.names.empty()) fields.push_back({"event_names", events.names});
  append_block(blocks,
               {{"discontinuities", light.light, "d" + std::to_string(order)}, "discontinuities", fields, data});
}

}  // namespace

std::vector<Block> discontinuity_blocks(const DiscontinuityResult& result) {
  std::vector<Block> blocks;
  append_scene_blocks(blocks, ShadowResult{result.scene, result.clip_box, {}});
  for (const SideResult side : sides_of(result.receivers)) append_receiver(blocks, result, side);
  for (const SurfaceResult& light : result.surfaces) {
    for (const int order : {0, 1, 2}) append_surfaces(blocks, result, light, order);
  }
  return blocks;
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

std::string element_text(const DiscontinuityResult& result, const std::string& light, const std::string& receiver,
                         const EventElement& element) {
  if (element.of == EventOf::light) return "light:" + light;
  if (element.of == EventOf::receiver) return "receiver:" + receiver;
  return "blocker:" + result.blockers[element.element];
}

}  // namespace gnomon
