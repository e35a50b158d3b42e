#include "geometry/scene/surface_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

struct ModelName {
  std::string_view name;
  ReflectionModel model;
};

constexpr std::array model_names{ModelName{"phong", ReflectionModel::phong}, ModelName{"blinn", ReflectionModel::blinn},
                                 ModelName{"phong_classic", ReflectionModel::phong_classic},
                                 ModelName{"blinn_classic", ReflectionModel::blinn_classic}};

constexpr double largest_double = std::numeric_limits<double>::max();

std::string range_text(double most) {
  return most < largest_double ? "a number from 0 to " + shortest(most) : "a number of at least 0";
}

double share(const JsonNode& node, double most) {
  const std::string expected = range_text(most);
  const double value = node.number(expected);
  if (!(value >= 0 && value <= most)) node.refuse_value(expected);
  return value;
}

bool is_number(const JsonNode& node) {
  return node.description().starts_with("the number");
}

ReflectionModel reflection_model(const JsonNode& node) {
  std::vector<std::string_view> names;
  for (const ModelName& known : model_names) names.push_back(known.name);
  const std::string expected = "a reflection model among " + listed(names);
  const std::string name = node.string(expected);
  const auto found = std::ranges::find(model_names, name, &ModelName::name);
  if (found == model_names.end()) node.refuse_value(expected);
  return found->model;
}

int exponent(const JsonNode& node) {
  constexpr const char* expected = "a whole number from 0 to 10000";
  const double value = node.number(expected);
  if (!(value >= 0 && value <= 10000) || value != std::floor(value)) node.refuse_value(expected);
  return static_cast<int>(value);
}

bool is_classic(ReflectionModel model) {
  return model == ReflectionModel::phong_classic || model == ReflectionModel::blinn_classic;
}

SceneMaterial read_material(const JsonNode& item) {
  item.require_object("a material: an object with a name");
  const std::string name = item.required("name", "a name (a string)").string("a name (a string)");
  const JsonNode node = item.as_element("material \"" + name + "\"");
  if (name.empty()) node.required("name", "").refuse_value("a name that is not empty");
  node.allow_keys({"name", "model", "ambient", "diffuse", "specular", "exponent"}, "a material");
  Material material;
  if (const auto model = node.optional("model")) material.model = reflection_model(*model);
  if (const auto ambient = node.optional("ambient")) material.ambient = colour(*ambient, 1);
  if (const auto diffuse = node.optional("diffuse")) material.diffuse = colour(*diffuse, 1);
  const double most = is_classic(material.model) ? largest_double : 1;
  if (const auto specular = node.optional("specular")) material.specular = colour(*specular, most);
  if (const auto n = node.optional("exponent")) material.exponent = exponent(*n);
  return {name, material};
}

bool is_called(const std::vector<SceneMaterial>& materials, const std::string& name) {
  return std::ranges::find(materials, name, &SceneMaterial::name) != materials.end();
}

}  // namespace

Rgb colour(const JsonNode& node, double most) {
  if (is_number(node)) {
    const double value = share(node, most);
    return {value, value, value};
  }
  const std::string expected = range_text(most) + ", or an array of three: [red, green, blue]";
  const std::vector<JsonNode> parts = node.items(expected);
  if (parts.size() != 3) node.refuse_value(expected);
  return {share(parts[0], most), share(parts[1], most), share(parts[2], most)};
}

void read_materials(const JsonNode& document, SpaceScene& scene) {
  if (const auto node = document.optional("ambient_radiance")) scene.ambient_radiance = colour(*node, largest_double);
  const auto list = document.optional("materials");
  if (!list) return;
  for (const JsonNode& item : list->items("an array of materials")) {
    SceneMaterial material = read_material(item);
    if (is_called(scene.materials, material.name)) {
      item.refuse("the name \"" + material.name + "\" once more", "a name of its own for each material");
    }
    scene.materials.push_back(std::move(material));
  }
}

std::string material_name(const SceneElement& element, const SpaceScene& scene) {
  const auto node = element.node.optional("material");
  if (!node) return {};
  const std::string expected = "the name of one of the scene's \"materials\"";
  std::string name = node->string(expected);
  if (!is_called(scene.materials, name)) node->refuse_value(expected);
  return name;
}

Rgb light_colour(const SceneElement& element) {
  const auto node = element.node.optional("color");
  return node ? colour(*node, largest_double) : Rgb{1, 1, 1};
}

namespace {

const std::string& name_in_file(const SceneBlocker& blocker) {
  return blocker.name;
}
const std::string& name_in_file(const SceneReceiver& receiver) {
  return receiver.element;
}

template <class Element>
void doubt_creases(const std::vector<Element>& elements, const char* list, std::vector<std::string>& doubts) {
  std::string last;
  for (const Element& e : elements) {
    const bool is_averaged = e.smoothness.normals != VertexNormals::flat && e.smoothness.normals != VertexNormals::file;
    if (e.smoothness.crease == 180 || is_averaged) continue;
    std::string title = element_title(list, name_in_file(e));
    if (title == last) continue;
    doubts.push_back(title +
                     ": its \"crease\" does nothing; it goes with \"normals\" that are \"angle\", \"area\" or "
                     "\"equal\"");
    last = std::move(title);
  }
}

void doubt_ambient_light(const SpaceScene& scene, std::vector<std::string>& doubts) {
  const auto reflects = [](const SceneMaterial& m) { return m.material.ambient != Rgb{}; };
  if (scene.ambient_radiance == Rgb{} || std::ranges::any_of(scene.materials, reflects)) return;
  doubts.push_back("\"ambient_radiance\": no material has an \"ambient\" share, so nothing reflects it");
}

}  // namespace

void doubt_materials(const SpaceScene& scene, std::vector<std::string>& doubts) {
  doubt_ambient_light(scene, doubts);
  doubt_creases(scene.blockers, "blockers", doubts);
  doubt_creases(scene.receivers, "receivers", doubts);
  for (const auto& [name, material] : scene.materials) {
    if (is_classic(material.model)) continue;
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, material.diffuse[k] + material.specular[k]);
    if (most <= 1) continue;
    doubts.push_back("material \"" + name + "\": diffuse and specular together are " + few_digits(most) +
                     "; above 1 a surface may reflect more than arrives");
  }
}

}  // namespace gnomon
