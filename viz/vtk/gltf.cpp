#include <vtkBase64Utilities.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "viz/vtk/block.h"
#include "viz/vtk/facet_groups.h"
#include "viz/vtk/palette.h"
#include "viz/vtk/surface_files.h"

namespace gnomon::viz {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF buffers are little endian");

// Names and numbers of the glTF 2.0 specification.
constexpr int float_component = 5126;
constexpr int uint32_component = 5125;
constexpr int vertex_buffer = 34962;
constexpr int index_buffer = 34963;
enum Mode { points_mode = 0, lines_mode = 1, triangles_mode = 4 };

/// A glTF document while its buffer grows.
struct Document {
  std::vector<unsigned char> bytes;
  Json views = Json::array();
  Json accessors = Json::array();
};

template <class Value>
std::size_t add_accessor(Document& document, const std::vector<Value>& values, int target, Json accessor) {
  const std::size_t start = document.bytes.size();
  const std::size_t length = values.size() * sizeof(Value);
  document.bytes.resize(start + length);
  std::memcpy(document.bytes.data() + start, values.data(), length);
  document.views.push_back({{"buffer", 0}, {"byteOffset", start}, {"byteLength", length}, {"target", target}});
  accessor["bufferView"] = document.views.size() - 1;
  document.accessors.push_back(std::move(accessor));
  return document.accessors.size() - 1;
}

std::size_t add_positions(Document& document, vtkPolyData& surface, const Point3& centre) {
  std::vector<float> values;
  std::vector<float> low(3, std::numeric_limits<float>::max());
  std::vector<float> high(3, std::numeric_limits<float>::lowest());
  const double origin[] = {centre.x, centre.y, centre.z};
  for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
    double p[3];
    surface.GetPoint(i, p);
    for (std::size_t k = 0; k < 3; ++k) {
      values.push_back(static_cast<float>(p[k] - origin[k]));
      low[k] = std::min(low[k], values.back());
      high[k] = std::max(high[k], values.back());
    }
  }
  return add_accessor(document, values, vertex_buffer,
                      {{"componentType", float_component},
                       {"type", "VEC3"},
                       {"count", values.size() / 3},
                       {"min", low},
                       {"max", high}});
}

/// The cells as points, as segments, or (being convex) as fans of triangles.
std::vector<std::uint32_t> simplices(vtkCellArray* cells, Mode mode) {
  std::vector<std::uint32_t> indices;
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cell->GetCurrentCell(size, points);
    const auto add = [&](vtkIdType i) { indices.push_back(static_cast<std::uint32_t>(points[i])); };
    if (mode == points_mode) add(0);
    for (vtkIdType i = 1; mode == lines_mode && i < size; ++i) add(i - 1), add(i);
    for (vtkIdType i = 2; mode == triangles_mode && i < size; ++i) add(0), add(i - 1), add(i);
  }
  return indices;
}

Json primitives(Document& document, vtkPolyData& surface, const Point3& centre, std::size_t material) {
  Json list = Json::array();
  const std::size_t positions = add_positions(document, surface, centre);
  const auto add = [&](vtkCellArray* cells, Mode mode) {
    const std::vector<std::uint32_t> indices = simplices(cells, mode);
    if (indices.empty()) return;
    const std::size_t accessor =
        add_accessor(document, indices, index_buffer,
                     {{"componentType", uint32_component}, {"type", "SCALAR"}, {"count", indices.size()}});
    list.push_back(
        {{"attributes", {{"POSITION", positions}}}, {"indices", accessor}, {"mode", mode}, {"material", material}});
  };
  add(surface.GetVerts(), points_mode);
  add(surface.GetLines(), lines_mode);
  add(surface.GetPolys(), triangles_mode);
  return list;
}

struct Material {
  const char* name;
  Color color;
  double opacity;
};

constexpr Material materials[] = {{"light", palette.light, 1},
                                  {"blocker", palette.blocker, 1},
                                  {"receiver", palette.receiver, 1},
                                  {"occlusion", palette.occlusion, 0.15},
                                  {"umbra", palette.umbra, 0.7},
                                  {"penumbra", palette.penumbra, 0.35},
                                  {"extremal_planes", palette.edge, 0.1},
                                  {"lit", palette.lit, 1},
                                  {"unlit", palette.unlit, 1},
                                  {"unresolved_eee", palette.unresolved_eee, 1},
                                  {"penumbra on receiver", palette.penumbra, 1},
                                  {"umbra on receiver", palette.umbra, 1},
                                  {"D0", palette.discontinuities[0], 0.6},
                                  {"D1", palette.discontinuities[1], 0.6},
                                  {"D2", palette.discontinuities[2], 0.6},
                                  {"other", palette.edge, 0.5}};

// glTF colours are linear; this power is close enough to the sRGB curve for a picture.
Json material_json(const Material& material) {
  const auto linear = [](double value) { return std::pow(value, 2.2); };
  const Json color = {linear(material.color[0]), linear(material.color[1]), linear(material.color[2]),
                      material.opacity};
  return {{"name", material.name},
          {"pbrMetallicRoughness", {{"baseColorFactor", color}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}},
          {"alphaMode", material.opacity < 1 ? "BLEND" : "OPAQUE"},
          {"doubleSided", true}};
}

std::size_t material_named(const std::string& name) {
  const auto found = std::ranges::find_if(materials, [&](const Material& material) { return material.name == name; });
  return static_cast<std::size_t>(std::min(found, std::end(materials) - 1) - std::begin(materials));
}

/// Faces and lines whose cells have looks of their own, look by look.
Json divided_primitives(Document& document, vtkPolyData& surface, const Point3& centre) {
  Json list = Json::array();
  const auto add = [&](vtkPolyData& part, const std::string& material) {
    for (Json& primitive : primitives(document, part, centre, material_named(material))) list.push_back(primitive);
  };
  for (const RegionFacets& part : region_facets(surface)) {
    const bool shadow = part.name == "penumbra" || part.name == "umbra";
    add(*part.data, shadow ? part.name + " on receiver" : part.name);
  }
  for (const OrderedFacets& part : ordered_lines(surface)) add(*part.data, part.name);
  return list;
}

Json block_primitives(Document& document, const Block& block, vtkPolyData& surface, const Point3& centre) {
  const std::string& place = block.path.front();
  if (place == "receivers") {
    Json list = divided_primitives(document, surface, centre);
    if (!list.empty()) return list;
  }
  if (place == "discontinuities") {
    Json list = divided_primitives(document, surface, centre);
    for (const OrderedFacets& part : ordered_surfaces(surface)) {
      for (Json& primitive : primitives(document, *part.data, centre, material_named(part.name))) {
        list.push_back(primitive);
      }
    }
    if (!list.empty()) return list;
  }
  const bool by_name = block.kind == "volume" || block.kind == "region";
  const std::string material = block.kind == "boundaries" ? "extremal_planes"
                               : by_name                  ? block.path.back()
                                                          : block.kind;
  return primitives(document, surface, centre, material_named(material));
}

/// Turns a quarter about x what has z up, and makes metres.
Json root_node(const Point3& centre, const ModelFrame& frame) {
  const double s = frame.metres, half = std::sqrt(0.5);
  const Point3 place = frame.is_z_up ? Point3{centre.x, centre.z, -centre.y} : centre;
  Json node = {{"name", "shadow"}, {"translation", {s * place.x, s * place.y, s * place.z}}};
  if (frame.is_z_up) node["rotation"] = {-half, 0.0, 0.0, half};
  if (s != 1) node["scale"] = {s, s, s};
  node["children"] = Json::array();
  return node;
}

std::string data_uri(const std::vector<unsigned char>& bytes) {
  std::string encoded(4 * ((bytes.size() + 2) / 3) + 4, '\0');
  encoded.resize(
      vtkBase64Utilities::Encode(bytes.data(), bytes.size(), reinterpret_cast<unsigned char*>(encoded.data())));
  return "data:application/octet-stream;base64," + encoded;
}

}  // namespace

ModelFrame model_frame(const Box3& clip_box, int dimension, UpAxis up, const std::string& length_unit) {
  const auto unit = length_unit_named(length_unit);
  return {clip_box, dimension == 3 && up == UpAxis::z, unit ? unit->top / unit->bottom : 1};
}

std::string gltf_text(std::span<const Block> blocks, const ModelFrame& frame) {
  const Box3& clip_box = frame.clip_box;
  const Point3 centre{std::midpoint(clip_box.min.x, clip_box.max.x), std::midpoint(clip_box.min.y, clip_box.max.y),
                      std::midpoint(clip_box.min.z, clip_box.max.z)};
  Document document;
  Json nodes = Json::array({root_node(centre, frame)});
  Json meshes = Json::array();
  for (const Block& block : blocks) {
    vtkPolyData* surface = vtkPolyData::SafeDownCast(block.data);
    if (surface == nullptr || block.empty()) continue;
    const std::string name = joined(block.path);
    meshes.push_back({{"name", name}, {"primitives", block_primitives(document, block, *surface, centre)}});
    nodes[0]["children"].push_back(nodes.size());
    nodes.push_back({{"name", name}, {"mesh", meshes.size() - 1}});
  }
  Json json = {{"asset", {{"version", "2.0"}, {"generator", "gnomon " GNOMON_VERSION}}},
               {"scene", 0},
               {"scenes", {{{"nodes", {0}}}}},
               {"nodes", std::move(nodes)},
               {"meshes", std::move(meshes)},
               {"materials", Json::array()},
               {"accessors", std::move(document.accessors)},
               {"bufferViews", std::move(document.views)},
               {"buffers", {{{"byteLength", document.bytes.size()}, {"uri", data_uri(document.bytes)}}}}};
  for (const Material& material : materials) json["materials"].push_back(material_json(material));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gnomon::viz
