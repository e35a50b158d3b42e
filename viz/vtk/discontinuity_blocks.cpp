#include "viz/vtk/discontinuity_blocks.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>

#include "viz/vtk/cell_arrays.h"
#include "viz/vtk/receiver_blocks.h"
#include "viz/vtk/vtk_cells.h"

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
    return element_text(result, light, receiver, element) + "[" + std::to_string(number(element.index)) + "]";
  };
  const std::string kind(gnomon::name(name.kind));
  if (name.kind == EventKind::coplanar_edges) return "edge " + text(name.vertex) + ", edge " + text(name.edge);
  if (name.kind == EventKind::triple_edge) {
    return "edge " + text(name.vertex) + ", edge " + text(name.edge) + ", edge " + text(name.third);
  }
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

std::int32_t blocker_id(const DiscontinuityResult& result, const EventName& name) {
  if (name.edge.of == EventOf::blocker) return static_cast<std::int32_t>(result.blocker_ids[number(name.edge.body)]);
  if (name.vertex.of == EventOf::blocker)
    return static_cast<std::int32_t>(result.blocker_ids[number(name.vertex.body)]);
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

/// Of several events along an edge the one of lowest order names it.
std::uint32_t leading_name(const ReceiverMesh& mesh, const MeshEdge& edge) {
  return *std::min_element(edge.names.begin(), edge.names.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t n) {
      return std::pair(mesh.names()[n].kind == EventKind::border, mesh.names()[n].order);
    };
    return key(a) < key(b);
  });
}

/// Of an edge that is an arc its middle control point and its weight; of others zeros. With its ends they are the arc.
void add_arc_arrays(vtkPolyData& data, SideResult side) {
  vtkNew<vtkDoubleArray> points, weights;
  points->SetName("arc_control_point");
  points->SetNumberOfComponents(3);
  weights->SetName("arc_weight");
  for (const ReceiverResult& piece : side) {
    const std::vector<MeshArc> arcs = piece.mesh.arcs();
    for (const MeshEdge& edge : piece.mesh.edges()) {
      const MeshArc arc = edge.arc == MeshEdge::nowhere ? MeshArc{{}, 0} : arcs[edge.arc];
      points->InsertNextTuple3(arc.points[1].x, arc.points[1].y, arc.points[1].z);
      weights->InsertNextValue(arc.weight);
    }
  }
  data.GetCellData()->AddArray(points);
  data.GetCellData()->AddArray(weights);
}

vtkSmartPointer<vtkPolyData> edges(const DiscontinuityResult& result, SideResult side, const SideDrawing& drawing,
                                   std::vector<std::string>& event_names) {
  vtkNew<vtkCellArray> cells;
  std::vector<CellName> names;
  EventCells events;
  vtkIdType first_point = 0;
  for (std::size_t k = 0; k < side.size(); ++k) {
    const ReceiverResult& piece = side[k];
    const std::size_t first_name = event_names.size();
    for (const EventName& name : piece.mesh.names()) {
      event_names.push_back(event_text(result, piece.light, piece.receiver, name));
    }
    for (std::size_t e = 0; e < piece.mesh.edges().size(); ++e) {
      const MeshEdge& edge = piece.mesh.edges()[e];
      insert_cell(*cells, drawing.pieces[k].lines[e], first_point);
      const std::uint32_t name = leading_name(piece.mesh, edge);
      names.push_back(cell_of(result, piece.light_id, piece.mesh.names()[name]));
      events.of_cell.push_back(static_cast<std::int32_t>(first_name + name));
    }
    first_point += static_cast<vtkIdType>(drawing.pieces[k].points.size());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(drawing.points));
  data->SetLines(cells);
  add_cell_arrays(*data, names);
  add_event_array(*data, events);
  if (drawing.chord_error > 0) add_arc_arrays(*data, side);
  add_point_arrays(*data, drawing);
  return data;
}

ShadowResult frame_of(const DiscontinuityResult& result) {
  return {result.scene, result.clip_box, {}};
}

void append_edges(std::vector<Block>& blocks, const DiscontinuityResult& result, SideResult side,
                  const SideDrawing& drawing) {
  std::vector<std::string> event_names;
  auto lines = edges(result, side, drawing, event_names);
  Fields fields = receiver_fields(frame_of(result), side, drawing);
  fields.push_back({"event_names", std::move(event_names)});
  append_block(blocks,
               {{"receivers", side.front().light, side.front().side, "edges"}, "receiver_edges", fields, lines});
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
  Fields fields = leaf_fields(frame_of(result), false);
  fields.push_back({"light", std::vector<std::string>{light.light}});
  if (!events.names.empty()) fields.push_back({"event_names", events.names});
  append_block(blocks,
               {{"discontinuities", light.light, "d" + std::to_string(order)}, "discontinuities", fields, data});
}

}  // namespace

std::vector<Block> discontinuity_blocks(const DiscontinuityResult& result) {
  std::vector<Block> blocks;
  append_scene_blocks(blocks, frame_of(result));
  for (const SideResult side : sides_of(result.receivers)) {
    const SideDrawing drawing = side_drawing(side);
    append_receiver_faces(blocks, frame_of(result), side, drawing);
    append_edges(blocks, result, side, drawing);
  }
  for (const SurfaceResult& light : result.surfaces) {
    for (const int order : {0, 1, 2}) append_surfaces(blocks, result, light, order);
  }
  return blocks;
}

}  // namespace gnomon::viz

namespace gnomon {

std::string element_text(const DiscontinuityResult& result, const std::string& light, const std::string& receiver,
                         const EventElement& element) {
  if (element.of == EventOf::light) return "light:" + light;
  if (element.of == EventOf::receiver) return "receiver:" + receiver;
  return "blocker:" + result.blockers[number(element.body)];
}

}  // namespace gnomon
