#include "geometry/scene/scene_elements.h"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "geometry/scene/json_text.h"

namespace gnomon {
namespace {

/// Names become names of files and of blocks inside files. The longest is what file systems take, less room for an
/// extension and a part number.
constexpr std::size_t longest_name = 200;

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7f;
}

std::string checked_name(const JsonNode& node) {
  std::string name = node.string("a name (a string)");
  if (name.empty()) node.refuse("an empty name", "a name");
  if (name == "." || name == "..") node.refuse_value("a name other than \".\" and \"..\"");
  if (name.find_first_of("/\\#") != std::string::npos || std::any_of(name.begin(), name.end(), is_control)) {
    node.refuse_value("a name without '/', '\\', '#' and control characters");
  }
  if (name.size() > longest_name) {
    node.refuse("a name of " + std::to_string(name.size()) + " bytes", "at most " + std::to_string(longest_name));
  }
  return name;
}

template <std::size_t Dimension>
std::array<double, Dimension> coordinates(const JsonNode& node) {
  const std::string expected = "a point of " + std::to_string(Dimension) + " coordinates";
  const std::vector<JsonNode> items = node.items(expected);
  if (items.size() != Dimension) node.refuse_value(expected);
  std::array<double, Dimension> result;
  for (std::size_t i = 0; i < Dimension; ++i) result[i] = items[i].number("a coordinate (a number)");
  return result;
}

}  // namespace

std::vector<SceneElement> scene_elements(const JsonNode& list_node, std::string_view list) {
  std::vector<SceneElement> elements;
  std::unordered_set<std::string> names;
  for (const JsonNode& item : list_node.items("an array of " + std::string(list))) {
    item.require_object("an object with name and shape");
    const JsonNode name_node = item.required("name", "a name (a string)");
    const std::string name = checked_name(name_node);
    const std::string title = element_title(list, name);
    if (!names.insert(name).second) {
      name_node.as_element(title).refuse("a name that an earlier element of " + std::string(list) + " has",
                                         "a name of its own");
    }
    const JsonNode node = item.as_element(title);
    elements.push_back({node, name, title, node.required("shape", "a shape (a string)").string("a shape (a string)")});
  }
  return elements;
}

void refuse_shape(const SceneElement& element, std::initializer_list<std::string_view> shapes) {
  element.node.required("shape", "").refuse_value("a shape among " + listed(shapes));
}

double strength(const SceneElement& element, std::string_view key) {
  const std::optional<JsonNode> node = element.node.optional(key);
  if (!node) return 1;
  const double value = node->number("a number, 0 or more");
  if (value < 0) node->refuse_value("a number, 0 or more");
  return value;
}

Point3 point3(const JsonNode& node) {
  const auto [x, y, z] = coordinates<3>(node);
  return {x, y, z};
}

Point2 point2(const JsonNode& node) {
  const auto [x, y] = coordinates<2>(node);
  return {x, y};
}

VertexNodes vertex_nodes(const SceneElement& element) {
  const JsonNode list = element.node.required("vertices", "an array of points");
  return {list, list.items("an array of points")};
}

}  // namespace gnomon
