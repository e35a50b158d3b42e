#include "geometry/scene/planar_reader.h"

#include <utility>

namespace gnomon {
namespace {

/// Consecutive points that differ.
std::vector<Point2> chain(const VertexNodes& nodes) {
  std::vector<Point2> points;
  for (const JsonNode& item : nodes.items) {
    points.push_back(point2(item));
    if (points.size() < 2 || points.back() != points[points.size() - 2]) continue;
    item.refuse("the point (" + shortest(points.back().x) + ", " + shortest(points.back().y) +
                    "), which repeats vertex " + std::to_string(points.size() - 2),
                "segments with a length");
  }
  return points;
}

std::vector<Point2> segment(const SceneElement& element) {
  const VertexNodes nodes = vertex_nodes(element);
  if (nodes.items.size() != 2) nodes.list.refuse_value("an array of 2 points");
  return chain(nodes);
}

std::vector<Point2> polyline(const SceneElement& element) {
  const VertexNodes nodes = vertex_nodes(element);
  if (nodes.items.size() < 2) nodes.list.refuse_value("an array of at least 2 points");
  return chain(nodes);
}

PlanarLight read_light(const SceneElement& element) {
  if (element.shape == "segment") {
    element.node.allow_keys({"name", "shape", "vertices", "intensity_per_length"}, "a segment light of the plane");
    return {element.name, segment(element), strength(element, "intensity_per_length")};
  }
  if (element.shape != "point") refuse_shape(element, {"segment", "point"});
  element.node.allow_keys({"name", "shape", "position", "intensity"}, "a point light of the plane");
  const Point2 position = point2(element.node.required("position", "a point of 2 coordinates"));
  return {element.name, {position}, strength(element, "intensity")};
}

}  // namespace

std::vector<PlanarLight> read_planar_lights(const std::vector<SceneElement>& elements) {
  std::vector<PlanarLight> lights;
  lights.reserve(elements.size());
  for (const SceneElement& element : elements) lights.push_back(read_light(element));
  return lights;
}

std::vector<PlanarBlocker> read_planar_chains(const std::vector<SceneElement>& elements) {
  std::vector<PlanarBlocker> chains;
  for (const SceneElement& element : elements) {
    if (element.shape != "segment" && element.shape != "polyline") refuse_shape(element, {"segment", "polyline"});
    element.node.allow_keys({"name", "shape", "vertices"}, "a segment or polyline");
    chains.push_back({element.name, element.shape == "segment" ? segment(element) : polyline(element)});
  }
  return chains;
}

}  // namespace gnomon
