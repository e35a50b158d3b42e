#include "geometry/scene/written_mesh.h"

#include <cmath>

namespace gnomon {
namespace {

std::uint32_t vertex_index(const JsonNode& node, std::size_t count) {
  const std::string expected = "the index of a vertex, from 0 to " + std::to_string(count - 1);
  const double index = node.number(expected);
  if (!(index >= 0 && index < static_cast<double>(count)) || index != std::floor(index)) node.refuse_value(expected);
  return static_cast<std::uint32_t>(index);
}

}  // namespace

PolygonSoup written_soup(const SceneElement& element) {
  const VertexNodes nodes = vertex_nodes(element);
  if (nodes.items.empty()) nodes.list.refuse_value("an array of at least 3 points");
  PolygonSoup soup;
  for (const JsonNode& point : nodes.items) soup.vertices.push_back(point3(point));
  const std::string expected = "an array of facets, lists of indices of vertices";
  for (const JsonNode& facet : element.node.required("facets", expected).items(expected)) {
    soup.facets.emplace_back();
    for (const JsonNode& index : facet.items("a list of indices of vertices")) {
      soup.facets.back().push_back(vertex_index(index, soup.vertices.size()));
    }
  }
  return soup;
}

}  // namespace gnomon
