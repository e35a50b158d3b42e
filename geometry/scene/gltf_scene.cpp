#include "geometry/scene/gltf_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "geometry/scene/gltf_file.h"

namespace gnomon {
namespace {

/// Where a node puts points: the columns of a matrix, the last one its place.
struct Placement {
  std::array<std::array<double, 3>, 4> column{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

  std::array<double, 3> turned(const std::array<double, 3>& v) const {
    std::array<double, 3> result{};
    for (std::size_t k = 0; k < 3; ++k) result[k] = column[0][k] * v[0] + column[1][k] * v[1] + column[2][k] * v[2];
    return result;
  }
  std::array<double, 3> placed(const std::array<double, 3>& p) const {
    std::array<double, 3> result = turned(p);
    for (std::size_t k = 0; k < 3; ++k) result[k] += column[3][k];
    return result;
  }
  /// Negative if it mirrors.
  double determinant() const {
    const auto& [a, b, c, d] = column;
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
};

Placement within(const Placement& parent, const Placement& child) {
  Placement result;
  for (std::size_t k = 0; k < 3; ++k) result.column[k] = parent.turned(child.column[k]);
  result.column[3] = parent.placed(child.column[3]);
  return result;
}

template <std::size_t n>
std::array<double, n> number_list(const JsonNode& node) {
  const std::string expected = "an array of " + std::to_string(n) + " numbers";
  const std::vector<JsonNode> items = node.items(expected);
  if (items.size() != n) node.refuse_value(expected);
  std::array<double, n> result{};
  for (std::size_t k = 0; k < n; ++k) result[k] = items[k].number("a number");
  return result;
}

template <std::size_t n>
std::array<double, n> number_list(const JsonNode& object, std::string_view key,
                                  const std::array<double, n>& otherwise) {
  const auto found = object.optional(key);
  return found ? number_list<n>(*found) : otherwise;
}

double number_or(const JsonNode& object, std::string_view key, double otherwise) {
  const auto found = object.optional(key);
  return found ? found->number("a number") : otherwise;
}

std::string name_of(const JsonNode& object, const std::string& otherwise) {
  const auto found = object.optional("name");
  const std::string name = found ? found->string("a name") : "";
  return name.empty() ? otherwise : name;
}

/// The extension of an object, if it has it.
std::optional<JsonNode> extension(const JsonNode& object, std::string_view name) {
  const auto all = object.optional("extensions");
  return all ? all->optional(name) : std::nullopt;
}

Placement placement_of(const JsonNode& node) {
  Placement result;
  if (const auto matrix = node.optional("matrix")) {
    const std::array<double, 16> m = number_list<16>(*matrix);
    for (std::size_t c = 0; c < 4; ++c) result.column[c] = {m[4 * c], m[4 * c + 1], m[4 * c + 2]};
    return result;
  }
  const auto [x, y, z, w] = number_list<4>(node, "rotation", {0, 0, 0, 1});
  const std::array<double, 3> scale = number_list<3>(node, "scale", {1, 1, 1});
  result.column = {{{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                    {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                    {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
                    number_list<3>(node, "translation", {0, 0, 0})}};
  for (std::size_t c = 0; c < 3; ++c) {
    for (double& value : result.column[c]) value *= scale[c];
  }
  return result;
}

/// The corners of each triangle of a primitive: 4 lists them, 5 is a strip, 6 a fan.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<std::uint32_t>& corners, std::size_t mode) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const std::size_t step = mode == 4 ? 3 : 1;
  for (std::size_t k = 0; k + 2 < corners.size(); k += step) {
    const bool is_odd = mode == 5 && k % 2 == 1;
    const std::uint32_t first = mode == 6 ? corners[0] : corners[k];
    triangles.push_back({first, corners[k + (is_odd ? 2 : 1)], corners[k + (is_odd ? 1 : 2)]});
  }
  return triangles;
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const std::string& source, const std::filesystem::path& folder)
      : file_(bytes, source, folder), is_visited_(file_.list("nodes").size(), false) {}

  GltfScene scene() {
    add_materials();
    for (const std::size_t root : roots()) visit(root);
    for (const char* list : {"animations", "skins"}) {
      const auto found = file_.root().optional(list);
      if (found) count(list, found->items("an array").size());
    }
    for (const auto& [what, times] : passed_over_) {
      result_.soup.doubts.push_back("passed over " + what + " (" + std::to_string(times) + ")");
    }
    return std::move(result_);
  }

 private:
  void count(const std::string& what, std::size_t times = 1) { passed_over_[what] += times; }

  void add_materials() {
    for (const JsonNode& node : file_.list("materials")) {
      result_.soup.materials.push_back(name_of(node, "material " + std::to_string(result_.materials.size())));
      result_.materials.emplace_back(material_of(node));
    }
    result_.soup.materials.emplace_back();
    result_.materials.emplace_back();
  }

  FileMaterial material_of(const JsonNode& node) {
    FileMaterial material;
    std::array<double, 3> emission = number_list<3>(node, "emissiveFactor", {0, 0, 0});
    if (const auto strength = extension(node, "KHR_materials_emissive_strength")) {
      for (double& channel : emission) channel *= number_or(*strength, "emissiveStrength", 1);
    }
    if (std::ranges::any_of(emission, [](double e) { return !(e >= 0) || !std::isfinite(e); })) {
      node.refuse("a negative emission", "numbers from 0 on");
    }
    material.emission = emission;
    if (const auto both = node.optional("doubleSided")) material.emits_both_ways = both->boolean("true or false");
    const auto alpha = node.optional("alphaMode");
    if (alpha && alpha->string("a mode") != "OPAQUE") count("transparency of materials");
    for (const char* texture : {"emissiveTexture", "normalTexture", "occlusionTexture"}) {
      if (node.optional(texture)) count("textures of materials");
    }
    const auto surface = node.optional("pbrMetallicRoughness");
    if (surface) add_reflection(material, *surface);
    return material;
  }

  void add_reflection(FileMaterial& material, const JsonNode& surface) {
    for (const char* texture : {"baseColorTexture", "metallicRoughnessTexture"}) {
      if (surface.optional(texture)) count("textures of materials");
    }
    const std::array<double, 4> base = number_list<4>(surface, "baseColorFactor", {1, 1, 1, 1});
    const double metallic = number_or(surface, "metallicFactor", 1), rough = number_or(surface, "roughnessFactor", 1);
    const auto is_share = [](double x) { return x >= 0 && x <= 1; };
    if (!std::ranges::all_of(base, is_share) || !is_share(metallic) || !is_share(rough)) {
      surface.refuse("a factor that is no share", "numbers from 0 to 1");
    }
    material.diffuse = {base[0] * (1 - metallic), base[1] * (1 - metallic), base[2] * (1 - metallic)};
    if (metallic == 0) return;
    if (rough == 0) return count("specular shares of roughness 0, a mirror's");
    material.specular = {base[0] * metallic, base[1] * metallic, base[2] * metallic};
    const double width = rough * rough;
    material.exponent = 2 / (width * width) - 2;
  }

  /// The nodes of the scene that is shown; without scenes those that are nobody's children.
  std::vector<std::size_t> roots() const {
    std::vector<std::size_t> found;
    const auto& nodes = file_.list("nodes");
    const auto& scenes = file_.list("scenes");
    const auto shown = file_.root().optional("scene");
    if (shown || !scenes.empty()) {
      const JsonNode& scene = shown ? file_.item(*shown, "scenes") : scenes[0];
      if (const auto all = scene.optional("nodes")) {
        for (const JsonNode& index : all->items("an array")) found.push_back(node_index(index));
      }
      return found;
    }
    std::vector<bool> is_child(nodes.size(), false);
    for (const JsonNode& node : nodes) {
      for (const std::size_t child : children_of(node)) is_child[child] = true;
    }
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (!is_child[k]) found.push_back(k);
    }
    if (found.empty() && !nodes.empty()) nodes[0].refuse("nodes that are all below others", "nodes that form trees");
    return found;
  }

  std::size_t node_index(const JsonNode& index) const {
    return whole_number(index, file_.list("nodes").size(), "the index of a node");
  }

  std::vector<std::size_t> children_of(const JsonNode& node) const {
    std::vector<std::size_t> children;
    if (const auto all = node.optional("children")) {
      for (const JsonNode& index : all->items("an array")) children.push_back(node_index(index));
    }
    return children;
  }

  /// A node and all below it. Nodes form trees: each is met once.
  void visit(std::size_t root) {
    std::vector<std::pair<std::size_t, Placement>> waiting{{root, Placement{}}};
    while (!waiting.empty()) {
      const auto [k, parent] = waiting.back();
      waiting.pop_back();
      const JsonNode& node = file_.list("nodes")[k];
      if (is_visited_[k]) node.refuse("a node that is met twice", "nodes that form trees");
      is_visited_[k] = true;
      const Placement here = within(parent, placement_of(node));
      if (const auto mesh = node.optional("mesh")) add_mesh(file_.item(*mesh, "meshes"), here);
      if (const auto light = extension(node, "KHR_lights_punctual")) add_light(*light, here);
      if (const auto camera = node.optional("camera")) add_camera(file_.item(*camera, "cameras"), here);
      if (node.optional("skin")) count("skins of nodes; their meshes stand as they are");
      std::vector<std::size_t> children = children_of(node);
      std::ranges::reverse(children);
      for (const std::size_t child : children) waiting.emplace_back(child, here);
    }
  }

  void add_mesh(const JsonNode& mesh, const Placement& here) {
    for (const JsonNode& primitive : mesh.required("primitives", "an array").items("an array")) {
      const auto given = primitive.optional("mode");
      const std::size_t mode = given ? whole_number(*given, 7, "a mode from 0 to 6") : 4;
      if (mode < 4) {
        count("primitives of points or lines");
      } else {
        add_primitive(primitive, mode, here);
      }
      if (primitive.optional("targets")) count("morph targets");
    }
  }

  void add_primitive(const JsonNode& primitive, std::size_t mode, const Placement& here) {
    const JsonNode attributes = primitive.required("attributes", "an object");
    const JsonNode position = attributes.required("POSITION", "the index of an accessor");
    const std::vector<double> numbers = file_.numbers(position, 3);
    PolygonSoup& soup = result_.soup;
    const auto before = static_cast<std::uint32_t>(soup.vertices.size());
    const std::size_t size = numbers.size() / 3;
    for (std::size_t k = 0; k < size; ++k) {
      const auto [x, y, z] = here.placed({numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]});
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
        position.refuse("vertex " + std::to_string(k) + ", which its node moves beyond doubles", "finite places");
      }
      soup.vertices.push_back({x, y, z});
    }
    const auto index = primitive.optional("indices");
    std::vector<std::uint32_t> corners = index ? file_.indices(*index) : std::vector<std::uint32_t>(size);
    for (std::size_t k = 0; !index && k < size; ++k) corners[k] = static_cast<std::uint32_t>(k);
    for (const std::uint32_t corner : corners) {
      if (corner < size) continue;
      index->refuse("vertex " + std::to_string(corner), "an index below " + std::to_string(size));
    }
    const std::uint32_t material = material_number(primitive);
    const bool is_mirrored = here.determinant() < 0;
    for (auto [a, b, c] : triangles_of(corners, mode)) {
      if (is_mirrored) std::swap(b, c);
      soup.facets.push_back({before + a, before + b, before + c});
      soup.facet_materials.push_back(material);
    }
  }

  std::uint32_t material_number(const JsonNode& primitive) const {
    const auto count = static_cast<std::uint32_t>(file_.list("materials").size());
    const auto index = primitive.optional("material");
    return index ? static_cast<std::uint32_t>(whole_number(*index, count, "the index of a material")) : count;
  }

  void add_light(const JsonNode& of_node, const Placement& here) {
    const auto all = extension(file_.root(), "KHR_lights_punctual");
    const std::vector<JsonNode> lights =
        all ? all->required("lights", "an array").items("an array") : std::vector<JsonNode>();
    const JsonNode& light =
        lights[whole_number(of_node.required("light", "an index"), lights.size(), "the index of a light")];
    const std::string type = light.required("type", "a type of lights").string("a type of lights");
    if (type == "spot") return count("spot lights");
    if (type != "point" && type != "directional") light.refuse("the type " + type, "point, directional or spot");
    PunctualLight result;
    result.name = name_of(light, "light " + std::to_string(result_.lights.size()));
    result.is_directional = type == "directional";
    // Directional lights shine along -z of their node.
    const auto [x, y, z] = result.is_directional ? here.turned({0, 0, -1}) : here.column[3];
    result.place = {x, y, z};
    result.intensity = number_list<3>(light, "color", {1, 1, 1});
    for (double& channel : result.intensity) channel *= number_or(light, "intensity", 1);
    result_.lights.push_back(std::move(result));
  }

  /// Cameras look along -z of their node, with y up.
  void add_camera(const JsonNode& camera, const Placement& here) {
    const auto perspective = camera.optional("perspective");
    const auto along = [&](const std::array<double, 3>& v) {
      const auto [x, y, z] = here.turned(v);
      return Point3{x, y, z};
    };
    const Point3 ahead = along({0, 0, -1}), up = along({0, 1, 0});
    if (!perspective || result_.camera || ahead == Point3{} || up == Point3{}) {
      return count("cameras but the first one in perspective");
    }
    FileCamera found;
    const auto [x, y, z] = here.column[3];
    found.eye = {x, y, z};
    found.look_at = {x + ahead.x, y + ahead.y, z + ahead.z};
    found.up = up;
    const JsonNode angle = perspective->required("yfov", "an angle");
    found.vertical_angle = angle.number("an angle") * 180 / std::numbers::pi;
    if (!(found.vertical_angle > 0 && found.vertical_angle < 180)) angle.refuse_value("an angle between 0 and pi");
    found.aspect = number_or(*perspective, "aspectRatio", 4.0 / 3);
    if (!(found.aspect > 0)) perspective->refuse("an aspect ratio that is not above 0", "width over height");
    result_.camera = found;
  }

  GltfFile file_;
  std::vector<bool> is_visited_;
  GltfScene result_;
  std::map<std::string, std::size_t> passed_over_;
};

}  // namespace

GltfScene gltf_scene(std::string_view bytes, const std::string& source, const std::filesystem::path& folder) {
  return GltfReader(bytes, source, folder).scene();
}

}  // namespace gnomon
