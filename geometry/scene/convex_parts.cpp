#include "geometry/scene/convex_parts.h"

#include <numeric>
#include <utility>

#include "geometry/scene/convex_partition.h"
#include "geometry/spatial/polygon_checks.h"

namespace gnomon {
namespace {

using Indices = std::vector<std::uint32_t>;

Indices all_indices(std::size_t n) {
  Indices indices(n);
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

std::vector<Point3> points_at(std::span<const Point3> points, const Indices& indices) {
  std::vector<Point3> result;
  result.reserve(indices.size());
  for (const std::uint32_t i : indices) result.push_back(points[i]);
  return result;
}

/// A piece that is convex seen along an axis. Its own rounding may be larger in proportion than that of the polygon it
/// was cut from, so it is not asked whether it would pass for a rounded polygon.
ConvexBlocker convex_piece(std::vector<Point3> points) {
  if (are_coplanar(points)) return ConvexPolygon::from_points(std::move(points));
  return ConvexSolid::hull_of(std::move(points));
}

/// Adds a simple polygon: as it is, named `name`, if it is convex; else its pieces, named `name#0` and so on.
void add_polygon(std::span<const Point3> points, const Indices& loop, const std::string& name,
                 std::vector<ConvexPart>& parts) {
  const std::vector<Point3> polygon = points_at(points, loop);
  if (!ConvexPolygon::defect(polygon)) {
    parts.push_back({name, convex_piece(polygon), loop});
    return;
  }
  std::size_t count = 0;
  for (const Indices& piece : convex_partition(polygon)) {
    parts.push_back({name + '#' + std::to_string(count++), convex_piece(points_at(polygon, piece)), {}});
    for (const std::uint32_t i : piece) parts.back().vertices.push_back(loop[i]);
  }
}

struct PartsOf {
  const std::string& name;

  std::vector<ConvexPart> operator()(const ConvexPolygon& polygon) const {
    return {{name, convex_blocker(polygon), all_indices(polygon.points().size())}};
  }
  std::vector<ConvexPart> operator()(const Polytope& polytope) const {
    return {{name, ConvexSolid::hull_of(polytope.vertices), all_indices(polytope.vertices.size())}};
  }
  std::vector<ConvexPart> operator()(const ConcavePolygon& polygon) const {
    std::vector<ConvexPart> parts;
    add_polygon(polygon.vertices, all_indices(polygon.vertices.size()), name, parts);
    if (parts.size() == 1) parts.front().name = name + "#0";
    return parts;
  }
  std::vector<ConvexPart> operator()(const Mesh& mesh) const {
    std::vector<ConvexPart> parts;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
      add_polygon(mesh.vertices, mesh.facets[f], name + '#' + std::to_string(f), parts);
    }
    return parts;
  }
};

}  // namespace

std::vector<ConvexPart> convex_parts(const SceneBlocker& blocker) {
  return std::visit(PartsOf{blocker.name}, blocker.shape);
}

std::optional<ClosedSurface> enclosed_space(const SceneBlocker& blocker) {
  const Mesh* mesh = std::get_if<Mesh>(&blocker.shape);
  if (!mesh || !mesh->closed) return std::nullopt;
  ClosedSurface surface{mesh->vertices, {}};
  for (const ConvexPart& part : convex_parts(blocker)) {
    const Indices& loop = part.vertices;
    for (std::size_t i = 2; i < loop.size(); ++i) surface.triangles.push_back({loop[0], loop[i - 1], loop[i]});
  }
  return surface;
}

}  // namespace gnomon
