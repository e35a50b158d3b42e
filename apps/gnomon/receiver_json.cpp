#include "apps/gnomon/receiver_json.h"

#include <utility>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/radiance_output.h"
#include "geometry/numbers/printed_bound.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon {
namespace {

using MeshJson = nlohmann::ordered_json;

MeshJson areas_json(SideResult side) {
  MeshJson json;
  const auto areas = areas_of(side);
  for (std::size_t k = 0; k < areas.size(); ++k) {
    MeshJson area = {{"double", areas[k].nearest}};
    if (areas[k].exact) area["exact"] = *areas[k].exact;
    json[std::string(name(static_cast<ReceiverRegion>(k)))] = std::move(area);
  }
  return json;
}

/// The vertices along each cycle; the first comes once.
MeshJson cycles_json(const ReceiverMesh& mesh, const std::vector<std::vector<MeshEdgeUse>>& cycles) {
  MeshJson list = MeshJson::array();
  for (const std::vector<MeshEdgeUse>& cycle : cycles) {
    std::vector<std::uint32_t> vertices;
    for (const MeshEdgeUse use : cycle) {
      const MeshEdge& edge = mesh.edges()[use / 2];
      vertices.push_back(use % 2 == 0 ? edge.source : edge.target);
    }
    list.push_back(std::move(vertices));
  }
  return list;
}

/// The edges along each cycle: from each of its vertices to the next.
MeshJson edge_cycles_json(const std::vector<std::vector<MeshEdgeUse>>& cycles) {
  MeshJson list = MeshJson::array();
  for (const std::vector<MeshEdgeUse>& cycle : cycles) {
    std::vector<std::uint32_t> edges;
    for (const MeshEdgeUse use : cycle) edges.push_back(use / 2);
    list.push_back(std::move(edges));
  }
  return list;
}

MeshJson vertices_json(const ReceiverMesh& mesh) {
  MeshJson list = MeshJson::array();
  for (const Point3& p : mesh.vertices()) list.push_back({p.x, p.y, p.z});
  return list;
}

/// Faces of the mesh, or regions of them.
template <class Parts>
MeshJson parts_json(const ReceiverMesh& mesh, const Parts& parts, bool with_edges) {
  MeshJson list = MeshJson::array();
  for (const auto& part : parts) {
    list.push_back({{"region", name(part.region)}, {"cycles", cycles_json(mesh, part.cycles)}});
    if (with_edges) list.back()["edge_cycles"] = edge_cycles_json(part.cycles);
  }
  return list;
}

MeshJson event_json(const DiscontinuityResult& result, const ReceiverResult& receiver, const EventName& event) {
  const auto element = [&](const EventElement& e) {
    return MeshJson{{"of", element_text(result, receiver.light, receiver.receiver, e)}, {"index", number(e.index)}};
  };
  MeshJson json = {{"kind", name(event.kind)}, {"vertex", element(event.vertex)}, {"edge", element(event.edge)}};
  if (event.kind == EventKind::triple_edge) {
    json = {{"kind", name(event.kind)}, {"edges", {element(event.vertex), element(event.edge), element(event.third)}}};
  }
  if (event.kind != EventKind::border) json["order"] = event.order;
  if (event.extremal != Extremal::none) json["extremal"] = name(event.extremal);
  return json;
}

MeshJson edges_json(const ReceiverMesh& mesh) {
  const auto face = [](std::uint32_t index) { return index == MeshEdge::nowhere ? MeshJson() : MeshJson(index); };
  const std::vector<MeshArc> arcs = mesh.arcs();
  MeshJson list = MeshJson::array();
  for (const MeshEdge& edge : mesh.edges()) {
    list.push_back({{"vertices", {edge.source, edge.target}},
                    {"left", face(edge.left)},
                    {"right", face(edge.right)},
                    {"events", edge.names}});
    if (edge.arc == MeshEdge::nowhere) continue;
    const Point3& middle = arcs[edge.arc].points[1];
    list.back()["arc"] = {{"control_point", {middle.x, middle.y, middle.z}}, {"weight", arcs[edge.arc].weight}};
  }
  return list;
}

/// What the vertices receive and reflect.
MeshJson reflection_json(const ReceiverResult& receiver) {
  MeshJson values = MeshJson::array(), bounds = MeshJson::array(), seen = MeshJson::array(), off = MeshJson::array();
  for (std::size_t v = 0; v < receiver.mesh.vertex_count(); ++v) {
    const Irradiance& e = receiver.irradiance[v];
    values.push_back(e.value);
    bounds.push_back(printed_error_bound(e.value, e.error_bound));
    const MeshJson radiance = radiance_json(receiver.radiance[v], "error_bound");
    seen.push_back(radiance["radiance"]);
    off.push_back(radiance["error_bound"]);
  }
  return {
      {"irradiance", values}, {"irradiance_error_bound", bounds}, {"radiance", seen}, {"radiance_error_bound", off}};
}

MeshJson mesh_json(const DiscontinuityResult& result, const ReceiverResult& receiver, const MeshParts& parts) {
  MeshJson json = {{"vertices", vertices_json(receiver.mesh)}};
  if (!receiver.radiance.empty()) json.update(reflection_json(receiver));
  if (parts.faces) json["faces"] = parts_json(receiver.mesh, receiver.mesh.faces(), parts.edges);
  if (parts.polygons) json["polygons"] = parts_json(receiver.mesh, receiver.mesh.regions(), parts.edges);
  if (!parts.edges) return json;
  json["edges"] = edges_json(receiver.mesh);
  json["events"] = MeshJson::array();
  for (const EventName& event : receiver.mesh.names()) json["events"].push_back(event_json(result, receiver, event));
  return json;
}

MeshJson side_json(SideResult side) {
  const SideCounts counts = counts_of(side);
  MeshJson json = {{"name", side.front().side}, {"light", side.front().light}, {"area", counts.area},
                   {"faces", counts.faces},     {"edges", counts.edges},       {"vertices", counts.vertices},
                   {"regions", counts.regions}, {"areas", areas_json(side)}};
  if (side.size() > 1) json["facets"] = side.size();
  return json;
}

void add_meshes(MeshJson& json, const DiscontinuityResult& result, SideResult side, const MeshParts& parts) {
  if (side.size() == 1) {
    json["mesh"] = mesh_json(result, side.front(), parts);
    return;
  }
  json["meshes"] = MeshJson::array();
  for (const ReceiverResult& facet : side) {
    json["meshes"].push_back({{"facet", facet.receiver}});
    json["meshes"].back().update(mesh_json(result, facet, parts));
  }
}

}  // namespace

SideCounts counts_of(SideResult side) {
  SideCounts counts;
  std::vector<RegionArea> areas;
  for (const ReceiverResult& piece : side) {
    areas.push_back(piece.mesh.area());
    counts.faces += piece.mesh.faces().size();
    counts.edges += piece.mesh.edges().size();
    counts.vertices += piece.mesh.vertex_count();
    counts.regions += piece.mesh.regions().size();
  }
  counts.area = total_area(areas).nearest;
  return counts;
}

MeshParts mesh_parts(const std::string& list) {
  MeshParts parts;
  if (list.empty()) return parts;
  for (const std::string_view word : comma_separated(list)) {
    if (word != "faces" && word != "edges" && word != "polygons") {
      throw UsageError("--mesh: expected some of faces,edges,polygons, but found '" + std::string(word) + "'");
    }
    (word == "faces" ? parts.faces : word == "edges" ? parts.edges : parts.polygons) = true;
  }
  return parts;
}

nlohmann::ordered_json receivers_json(const DiscontinuityResult& result, const MeshParts& parts) {
  MeshJson document = {{"schema", "gnomon/receivers/1"},
                       {"scene", facts(*result.scene).source},
                       {"length_unit", facts(*result.scene).length_unit},
                       {"area_unit", facts(*result.scene).length_unit + "^2"},
                       {"receivers", MeshJson::array()}};
  for (const SideResult side : sides_of(result.receivers)) {
    document["receivers"].push_back(side_json(side));
    if (parts.any()) add_meshes(document["receivers"].back(), result, side, parts);
  }
  return document;
}

}  // namespace gnomon
