#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene/json_node.h"
#include "gnomon/point.h"

namespace gnomon {

/// One light, blocker or receiver of the file: an object with a name of its own and a shape.
struct SceneElement {
  JsonNode node;
  std::string name;
  std::string title;  ///< `light "lamp"`
  std::string shape;
};

/// The elements of one list, their names checked: not empty, unique, fit to be names of files and blocks.
std::vector<SceneElement> scene_elements(const JsonNode& list_node, std::string_view list);

/// The refusal of a shape that is not known, or not in this list or dimension.
[[noreturn]] void refuse_shape(const SceneElement& element, std::initializer_list<std::string_view> shapes);

/// A strength that may be left out: at least 0, 1 by default.
double strength(const SceneElement& element, std::string_view key);

/// Points of as many coordinates as the dimension says.
Point3 point3(const JsonNode& node);
Point2 point2(const JsonNode& node);

/// The key "vertices": its node, and one node for each vertex.
struct VertexNodes {
  JsonNode list;
  std::vector<JsonNode> items;
};
VertexNodes vertex_nodes(const SceneElement& element);

}  // namespace gnomon
