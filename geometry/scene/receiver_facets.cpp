#include "geometry/scene/receiver_facets.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/scene/convex_partition.h"
#include "gnomon/blocker.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

using Loop = std::vector<std::uint32_t>;

/// A piece, and what its name has behind the receiver's.
struct Piece {
  std::string suffix;
  std::vector<Point3> points;
  std::vector<Point3> normals = {};  ///< of a mesh file, one a point; none
};

std::vector<Point3> points_of_loop(std::span<const Point3> points, const Loop& loop) {
  std::vector<Point3> result;
  result.reserve(loop.size());
  for (const std::uint32_t i : loop) result.push_back(points[i]);
  return result;
}

/// The file's normals at a loop of a facet; none if there are none, or one of them is zero.
std::vector<Point3> normals_of_loop(const Mesh& mesh, std::size_t facet, const Loop& loop) {
  if (mesh.corner_normals.empty()) return {};
  const std::vector<std::uint32_t>& ring = mesh.facets[facet];
  std::vector<Point3> normals;
  for (const std::uint32_t i : loop) {
    const Point3& n = mesh.corner_normals[facet][std::size_t(std::ranges::find(ring, i) - ring.begin())];
    if (n == Point3{}) return {};
    normals.push_back(n);
  }
  return normals;
}

/// Adds a polygon; one that is not exactly flat as triangles.
void add_convex(std::vector<Point3> points, const std::string& suffix, std::vector<Piece>& pieces,
                std::vector<Point3> normals = {}) {
  if (are_coplanar(points) && !ConvexPolygon::defect(points)) {
    pieces.push_back({suffix, std::move(points), std::move(normals)});
    return;
  }
  std::size_t count = 0;
  for (std::size_t k = 2; k < points.size(); ++k) {
    const std::vector<Point3> triangle = {points[0], points[k - 1], points[k]};
    if (ConvexPolygon::defect(triangle)) continue;
    pieces.push_back({suffix + '#' + std::to_string(count++), triangle});
    if (!normals.empty()) pieces.back().normals = {normals[0], normals[k - 1], normals[k]};
  }
}

struct PiecesOf {
  std::vector<Piece> operator()(const ConvexPolygon& polygon) const {
    return {{"", {polygon.points().begin(), polygon.points().end()}}};
  }
  std::vector<Piece> operator()(const Polytope& polytope) const {
    std::vector<Piece> pieces;
    const ConvexSolid solid = ConvexSolid::hull_of(polytope.vertices);
    for (const ConvexSolid::Facet& facet : solid.facets()) {
      add_convex(points_of_loop(solid.points(), facet.loop), '#' + std::to_string(pieces.size()), pieces);
    }
    return pieces;
  }
  std::vector<Piece> operator()(const ConcavePolygon& polygon) const {
    std::vector<Piece> pieces;
    for (const Ring& ring : convex_pieces(polygon)) {
      add_convex(points_of_loop(polygon.vertices, ring), '#' + std::to_string(pieces.size()), pieces);
    }
    return pieces;
  }
  std::vector<Piece> operator()(const Mesh& mesh) const {
    std::vector<Piece> pieces;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
      const std::string facet = '#' + std::to_string(mesh.facet_numbers.empty() ? f : mesh.facet_numbers[f]);
      const std::vector<Ring> rings = convex_pieces(mesh.vertices, mesh.facets[f]);
      for (std::size_t k = 0; k < rings.size(); ++k) {
        const std::string suffix = rings.size() == 1 ? facet : facet + '#' + std::to_string(k);
        add_convex(points_of_loop(mesh.vertices, rings[k]), suffix, pieces, normals_of_loop(mesh, f, rings[k]));
      }
    }
    return pieces;
  }
};

/// Turned round, beginning with the same vertex.
std::vector<Point3> turned(std::vector<Point3> points) {
  std::reverse(points.begin() + 1, points.end());
  return points;
}

std::vector<ReceiverGroup> groups_of(std::span<const SceneReceiver> facets, std::string SceneReceiver::*key) {
  std::vector<ReceiverGroup> groups;
  for (std::size_t first = 0; first < facets.size();) {
    std::size_t last = first;
    while (last < facets.size() && facets[last].*key == facets[first].*key) ++last;
    groups.push_back(facets.subspan(first, last - first));
    first = last;
  }
  return groups;
}

}  // namespace

std::vector<ReceiverGroup> receiver_elements(std::span<const SceneReceiver> facets) {
  return groups_of(facets, &SceneReceiver::element);
}

std::vector<ReceiverGroup> receiver_sides(std::span<const SceneReceiver> facets) {
  return groups_of(facets, &SceneReceiver::side);
}

std::vector<SceneReceiver> receiver_facets(const std::string& name, const BlockerShape& shape, ReceiverSides sides) {
  const std::vector<Piece> pieces = std::visit(PiecesOf{}, shape);
  std::vector<SceneReceiver> facets;
  const std::string front = sides == ReceiverSides::both ? name + "/front" : name;
  for (const Piece& piece : pieces) {
    facets.push_back({front + piece.suffix, ConvexPolygon::from_points(piece.points), front, name});
    facets.back().file_normals = piece.normals;
  }
  if (sides == ReceiverSides::front) return facets;
  const std::string back = name + "/back";
  for (const Piece& piece : pieces) {
    facets.push_back({back + piece.suffix, ConvexPolygon::from_points(turned(piece.points)), back, name});
  }
  return facets;
}

}  // namespace gnomon
