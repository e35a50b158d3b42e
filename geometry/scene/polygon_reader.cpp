#include "geometry/scene/polygon_reader.h"

#include <utility>

#include "geometry/scene/convex_partition.h"
#include "geometry/scene/polygon_examination.h"

namespace gnomon {
namespace {

/// The rings of an element with the places of their vertices in the file.
struct RingNodes {
  JsonNode list;
  std::vector<JsonNode> vertices;
  std::vector<Point3> points;
  Ring boundary;
  std::vector<Ring> holes;

  [[noreturn]] void refuse(const PolygonRefusal& refusal) const {
    (refusal.vertex ? vertices[*refusal.vertex] : list).refuse(refusal.found, refusal.expected);
  }
};

/// Reads one ring, and leaves out what repeats its neighbour.
Ring read_ring(const JsonNode& list, const SceneElement& element, RingNodes& nodes, SpaceScene& scene) {
  const std::vector<JsonNode> items = list.items("an array of points");
  std::vector<Point3> points;
  points.reserve(items.size());
  for (const JsonNode& item : items) points.push_back(point3(item));
  Ring ring;
  for (const std::uint32_t i : without_repeats(points, whole_ring(points.size()))) {
    ring.push_back(static_cast<std::uint32_t>(nodes.points.size()));
    nodes.points.push_back(points[i]);
    nodes.vertices.push_back(items[i]);
  }
  const std::size_t left_out = points.size() - ring.size();
  const bool is_closed = points.size() > 1 && points.front() == points.back();
  if (left_out == 1 && is_closed) {
    scene.doubts.push_back(element.title +
                           ": its last vertex repeats the first and is left out; rings close themselves");
  } else if (left_out > 0) {
    scene.doubts.push_back(element.title + ": " + counted_words(left_out, "vertex") +
                           " repeating a neighbour left out; vertices are numbered without");
  }
  return ring;
}

RingNodes read_rings(const SceneElement& element, SpaceScene& scene) {
  RingNodes nodes{element.node.required("vertices", "an array of points"), {}, {}, {}, {}};
  nodes.boundary = read_ring(nodes.list, element, nodes, scene);
  const std::optional<JsonNode> holes = element.node.optional("holes");
  if (!holes) return nodes;
  for (const JsonNode& hole : holes->items("an array of rings, each an array of points")) {
    nodes.holes.push_back(read_ring(hole, element, nodes, scene));
    if (nodes.holes.back().size() < 3) hole.refuse("a hole of fewer than 3 different vertices", "at least 3");
  }
  return nodes;
}

std::string deviation_text(double deviation, const SpaceScene& scene) {
  return ": its vertices are not exactly coplanar; they deviate from a plane by up to " + few_digits(deviation) + " " +
         scene.length_unit;
}

enum class TakenAs { one_polygon, pieces };

void doubt_flatness(const SceneElement& element, const PolygonPlane& plane, TakenAs taken, SpaceScene& scene) {
  const std::string text = element.title + deviation_text(plane.deviation, scene);
  if (plane.flatness == Flatness::rounded) {
    const bool is_receiver = element.title.starts_with("receiver ") && taken == TakenAs::one_polygon;
    const bool is_light = element.title.starts_with("light ");
    scene.doubts.push_back(text + ", within the limit of 1e-9 of its diameter, and count as rounded" +
                           (is_receiver ? "; it is divided as if they lay in that plane" : "") +
                           (is_light ? "; receivers are not divided by it, write it as triangles for that" : ""));
  } else if (plane.flatness == Flatness::bent) {
    scene.doubts.push_back(text + "; it is bent, and taken as triangles, " + element.name + "#0 and so on");
  }
}

/// Refuses what is no polygon, and a boundary that is not convex where it has to be.
void require_polygon(const RingNodes& nodes, const PolygonExamination& polygon, ConcaveRing concave) {
  if (concave == ConcaveRing::refused && nodes.holes.empty()) {
    const std::optional<PolygonDefect> defect = ConvexPolygon::defect(nodes.points);
    if (defect && defect->kind >= PolygonDefect::Kind::not_convex) {
      nodes.refuse(convexity_refusal(nodes.points, *defect));
    }
  }
  if (polygon.refusal) nodes.refuse(*polygon.refusal);
  if (concave != ConcaveRing::refused || polygon.is_convex) return;
  nodes.list.refuse("an outer boundary that is not convex",
                    "a convex polygon, its vertices in order around it, or the shape \"concave_polygon\"");
}

}  // namespace

PolygonShape read_polygon(const SceneElement& element, ConcaveRing concave, SpaceScene& scene) {
  RingNodes nodes = read_rings(element, scene);
  if (concave != ConcaveRing::accepted && nodes.holes.empty() && !ConvexPolygon::defect(nodes.points)) {
    ConvexPolygon polygon = ConvexPolygon::from_points(std::move(nodes.points));
    if (!polygon.is_flat())
      doubt_flatness(element, {.deviation = polygon.deviation(), .flatness = Flatness::rounded}, TakenAs::one_polygon,
                     scene);
    return polygon;
  }
  PolygonExamination polygon = examined_polygon(nodes.points, nodes.boundary, nodes.holes);
  require_polygon(nodes, polygon, concave);
  if (polygon.rings.size() == 1 && polygon.rings[0].size() < nodes.boundary.size()) {
    scene.doubts.push_back(element.title + ": its boundary runs along an edge and back, which bounds nothing");
  }
  doubt_flatness(element, polygon.plane, TakenAs::pieces, scene);
  return ConcavePolygon{std::move(nodes.points), std::move(polygon.rings), element.shape};
}

std::vector<NamedPolygon> polygon_parts(const std::string& name, PolygonShape shape) {
  if (auto* convex = std::get_if<ConvexPolygon>(&shape)) return {{name, std::move(*convex)}};
  const auto& polygon = std::get<ConcavePolygon>(shape);
  std::vector<NamedPolygon> parts;
  const auto add = [&](const Ring& ring) {
    std::vector<Point3> points = points_of_rings(polygon.vertices, {&ring, 1});
    parts.push_back({name + '#' + std::to_string(parts.size()), ConvexPolygon::from_points(std::move(points))});
  };
  for (const Ring& piece : convex_partition(polygon.vertices, polygon.rings)) {
    if (are_coplanar(points_of_rings(polygon.vertices, {&piece, 1}))) {
      add(piece);
      continue;
    }
    for (std::size_t i = 2; i < piece.size(); ++i) {
      const Ring triangle{piece[0], piece[i - 1], piece[i]};
      if (polygon_plane(points_of_rings(polygon.vertices, {&triangle, 1}))) add(triangle);
    }
  }
  return parts;
}

std::string counted_words(std::size_t count, const std::string& noun) {
  if (count == 1) return "1 " + noun;
  return std::to_string(count) + ' ' + (noun.ends_with("ex") ? noun.substr(0, noun.size() - 2) + "ices" : noun + 's');
}

}  // namespace gnomon
