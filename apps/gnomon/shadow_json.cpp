#include "apps/gnomon/shadow_json.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "apps/gnomon/output_file.h"
#include "apps/gnomon/shadow_extents.h"
#include "gnomon/shadow_volume.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

/// An index that names no element of the file (a diagonal of a polygon whose vertices were rounded) is null.
template <class Index>
Json element_json(std::string_view of, const MaybeIndex<Index>& index) {
  return {{"of", of}, {"index", index ? Json(number(*index)) : Json()}};
}

template <class Index>
Json element_json(std::string_view of, Index index) {
  return element_json(of, MaybeIndex<Index>(index));
}

/// An edge of a solid has no index in the file: it is numbered among the solid's edges, and its vertices are told.
Json blocker_edge_json(const ScenePair& pair, MaybeIndex<BlockerEdge> edge) {
  Json json = element_json("blocker", edge);
  const auto* solid = std::get_if<ConvexSolid>(&pair.shadow->blocker());
  if (solid && edge) {
    const ConvexSolid::Edge& ends = solid->edges()[number(*edge)];
    json["vertices"] = {ends.from, ends.to};
  }
  return json;
}

/// The plane as numbers, from the half-space of that name; nothing where the pair has no such volume.
void add_coefficients(Json& json, const FacetName& plane, const ConvexVolume& volume) {
  const auto has_name = [&](const HalfSpace& half_space) { return half_space.name == plane; };
  const auto found = std::ranges::find_if(volume.half_spaces, has_name);
  if (found == volume.half_spaces.end()) return;
  for (const ExactNumber& number : plane_coefficients(*found)) {
    json["coefficients"].push_back(number.nearest);
    json["exact"].push_back(number.exact);
  }
}

template <class Plane>
FacetName facet_name(FacetKind kind, const Plane& plane) {
  return {kind, plane.edge ? std::optional(number(*plane.edge)) : std::nullopt, number(plane.vertex)};
}

Json plane_json(FacetKind kind, const BlockerPlane& plane, const ScenePair& pair, const ShadowVolumes& volumes) {
  const bool is_supporting = kind == FacetKind::supporting_blocker_plane;
  Json json = {{"contact", name(is_supporting ? Contact::supporting : Contact::separating)},
               {"edge", blocker_edge_json(pair, plane.edge)},
               {"vertex", element_json("light", plane.vertex)}};
  const FacetName facet = facet_name(kind, plane);
  add_coefficients(json, facet, is_supporting ? volumes.umbra : volumes.occlusion);
  return json;
}

Json plane_json(const LightPlane& plane, const ShadowVolumes& volumes) {
  Json json = {{"contact", name(Contact::separating)},
               {"edge", element_json("light", plane.edge)},
               {"vertex", element_json("blocker", plane.vertex)}};
  const FacetName facet = facet_name(FacetKind::separating_light_plane, plane);
  add_coefficients(json, facet, volumes.occlusion);
  return json;
}

Json planes_json(const ShadowVolumes& volumes, const ScenePair& pair) {
  Json list = Json::array();
  for (const BlockerPlane& plane : volumes.planes.separating_blocker) {
    list.push_back(plane_json(FacetKind::separating_blocker_plane, plane, pair, volumes));
  }
  for (const LightPlane& plane : volumes.planes.separating_light) list.push_back(plane_json(plane, volumes));
  for (const BlockerPlane& plane : volumes.planes.supporting_blocker) {
    list.push_back(plane_json(FacetKind::supporting_blocker_plane, plane, pair, volumes));
  }
  return list;
}

Json lines_json(const std::vector<planar::ExtremalLine>& lines) {
  Json list = Json::array();
  for (const planar::ExtremalLine& line : lines) {
    list.push_back({{"contact", name(line.contact)},
                    {"blocker_end", number(line.blocker_end)},
                    {"light_end", number(line.light_end)}});
  }
  return list;
}

void add_shadow(Json& json, const ShadowResult& result, std::size_t pair, const ScenePair& scene_pair) {
  const bool planar = std::holds_alternative<PlaneScene>(*result.scene);
  if (planar) {
    json["lines"] = lines_json(result.planar_pairs[pair].regions.lines);
  } else {
    json["planes"] = planes_json(result.pairs[pair].volumes, scene_pair);
  }
  for (const ShadowExtent& extent : shadow_extents(result, pair)) {
    json[std::string(extent.name)] = {{"empty", extent.facts.empty},
                                      {"bounded", extent.facts.bounded},
                                      {"components", extent.facts.components},
                                      {"volume_in_box", extent.size_in_box}};
  }
  if (!planar && result.pairs[pair].is_solid) {
    json["umbra"]["pockets"] = result.pairs[pair].volumes.umbra_pockets;
  }
}

/// What a light's partition says of one region.
Json region_json(const PlanarLightResult& light, Region region) {
  const ExactNumber& area = light.in_box.area(region);
  return {{"components", light.partition.count(region)}, {"area_in_box", area.nearest}, {"exact", area.exact}};
}

/// Every light behind all of its blockers together.
Json lights_json(const ShadowResult& result) {
  Json list = Json::array();
  for (const PlanarLightResult& light : result.planar_lights) {
    Json json = {{"light", light.light}, {"blockers", light.blockers}};
    for (const Region region : {Region::lit, Region::penumbra, Region::umbra}) {
      json[std::string(name(region))] = region_json(light, region);
    }
    json["boundary_edges"] = light.partition.edges().size();
    list.push_back(std::move(json));
  }
  return list;
}

/// Every blocker of several parts, or all of them together, whose occlusion volumes are one.
Json merged_json(const ShadowResult& result) {
  Json list = Json::array();
  for (const MergedResult& merged : result.merged) {
    const VolumeMesh& mesh = merged.occlusion.mesh;
    list.push_back({{"light", merged.light},
                    {"blocker", merged.blocker},
                    {"parts", merged.part_names.size()},
                    {"facets", mesh.facets.size()},
                    {"triangles", mesh.triangles.size()},
                    {"volume_in_box", mesh.volume.nearest},
                    {"exact", mesh.volume.exact}});
  }
  return list;
}

}  // namespace

Json pair_json(const ScenePair& pair) {
  Json json = {{"light", pair.light}, {"blocker", pair.blocker}};
  if (!pair.part_vertices.empty()) json["blocker_vertices"] = pair.part_vertices;
  json["position"] = name(pair.position);
  json["supported"] = pair.supported();
  if (!pair.supported()) json["reason"] = pair.reason;
  return json;
}

Json box_json(const Box3& box, int dimension) {
  if (dimension == 2) return Json::array({box.min.x, box.min.y, box.max.x, box.max.y});
  return Json::array({box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z});
}

Json shadow_json(const ShadowResult& result, const std::vector<ScenePair>& pairs) {
  const SceneFacts& scene = facts(*result.scene);
  const int dimensions = dimension(*result.scene);
  Json document = {{"schema", "gnomon/shadow/1"}, {"scene", scene.source}, {"length_unit", scene.length_unit}};
  document[dimensions == 2 ? "area_unit" : "volume_unit"] = scene.length_unit + '^' + std::to_string(dimensions);
  document["clip_box"] = box_json(result.clip_box, dimensions);
  document["pairs"] = Json::array();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Json pair = pair_json(pairs[i]);
    if (pairs[i].supported()) add_shadow(pair, result, i, pairs[i]);
    document["pairs"].push_back(std::move(pair));
  }
  if (!result.planar_lights.empty()) document["lights"] = lights_json(result);
  if (!result.merged.empty()) document["merged"] = merged_json(result);
  return document;
}

void write_json(const Json& document, const std::string& file) {
  // A file name need not be UTF-8; JSON must be.
  const std::string text = document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (file == "-") {
    std::cout << text;
  } else {
    write_output_file(file, text);
  }
}

}  // namespace gnomon
