#include "gnomon/scene.h"

#include <utility>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/scene/convex_partition.h"
#include "geometry/scene/polygon_rings.h"

namespace gnomon {
namespace {

std::vector<Point3> points_at(std::span<const Point3> points, const Ring& indices) {
  return points_of_rings(points, {&indices, 1});
}

/// A piece that is convex seen along an axis. Its own rounding may be larger in proportion than that of the polygon it
/// was cut from, so it is not asked whether it would pass for a rounded polygon.
ConvexBlocker convex_piece(std::vector<Point3> points) {
  if (are_coplanar(points)) return ConvexPolygon::from_points(std::move(points));
  return ConvexSolid::hull_of(std::move(points));
}

ConvexPart part_of(std::span<const Point3> points, std::string name, Ring piece) {
  ConvexBlocker shape = convex_piece(points_at(points, piece));
  return {std::move(name), std::move(shape), std::move(piece)};
}

/// The solid that a convex mesh is; vertices in no facet do not count.
ConvexPart hull_of_facets(const Mesh& mesh, const std::string& name) {
  std::vector<bool> used(mesh.vertices.size());
  for (const Ring& facet : mesh.facets) {
    for (const std::uint32_t i : facet) used[i] = true;
  }
  Ring indices;
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    if (used[i]) indices.push_back(i);
  }
  return {name, ConvexSolid::hull_of(points_at(mesh.vertices, indices)), indices};
}

struct PartsOf {
  const std::string& name;
  PartsFor use;

  std::vector<ConvexPart> operator()(const ConvexPolygon& polygon) const {
    return {{name, convex_blocker(polygon), whole_ring(polygon.points().size())}};
  }
  std::vector<ConvexPart> operator()(const Polytope& polytope) const {
    return {{name, ConvexSolid::hull_of(polytope.vertices), whole_ring(polytope.vertices.size())}};
  }
  std::vector<ConvexPart> operator()(const ConcavePolygon& polygon) const {
    std::vector<ConvexPart> parts;
    for (Ring& piece : convex_pieces(polygon)) {
      parts.push_back(part_of(polygon.vertices, name + '#' + std::to_string(parts.size()), std::move(piece)));
    }
    return parts;
  }
  std::vector<ConvexPart> operator()(const Mesh& mesh) const {
    if (mesh.dents && (*mesh.dents == 0 || use == PartsFor::volumes)) return {hull_of_facets(mesh, name)};
    std::vector<ConvexPart> parts;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
      const std::size_t number = mesh.facet_numbers.empty() ? f : mesh.facet_numbers[f];
      const std::string facet = name + '#' + std::to_string(number);
      std::vector<Ring> pieces = convex_pieces(mesh.vertices, mesh.facets[f]);
      const bool is_whole = pieces.size() == 1 && pieces[0] == mesh.facets[f];
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        parts.push_back(
            part_of(mesh.vertices, is_whole ? facet : facet + '#' + std::to_string(k), std::move(pieces[k])));
      }
    }
    return parts;
  }
};

}  // namespace

std::vector<ConvexPart> convex_parts(const SceneBlocker& blocker, PartsFor use) {
  return std::visit(PartsOf{blocker.name, use}, blocker.shape);
}

std::vector<Ring> convex_pieces(const ConcavePolygon& polygon) {
  std::vector<Ring> rings = polygon.rings;
  if (rings.empty()) rings.push_back(whole_ring(polygon.vertices.size()));
  return convex_partition(polygon.vertices, std::move(rings));
}

std::vector<Ring> convex_pieces(std::span<const Point3> points, const Ring& facet) {
  const std::vector<Point3> polygon = points_at(points, facet);
  if (facet.size() == 3 || !ConvexPolygon::defect(polygon)) return {facet};
  std::vector<Ring> rings = *without_seams(polygon, whole_ring(polygon.size()));
  put_outer_ring_first(polygon, polygon_plane(polygon)->dropped_axis, rings);
  std::vector<Ring> pieces = convex_partition(polygon, std::move(rings));
  for (Ring& piece : pieces) {
    for (std::uint32_t& i : piece) i = facet[i];
  }
  return pieces;
}

std::optional<ClosedSurface> enclosed_space(const SceneBlocker& blocker) {
  const Mesh* mesh = std::get_if<Mesh>(&blocker.shape);
  if (!mesh || !mesh->closed || mesh->dents == 0.0) return std::nullopt;
  ClosedSurface surface{mesh->vertices, {}};
  for (const Ring& facet : mesh->facets) {
    for (const Ring& piece : convex_pieces(mesh->vertices, facet)) {
      for (std::size_t i = 2; i < piece.size(); ++i) surface.triangles.push_back({piece[0], piece[i - 1], piece[i]});
    }
  }
  return surface;
}

SceneBodies scene_bodies(const SpaceScene& scene) {
  SceneBodies bodies;
  for (std::uint32_t b = 0; b < scene.blockers.size(); ++b) {
    for (ConvexPart& part : convex_parts(scene.blockers[b])) {
      bodies.obstacles.blockers.push_back(std::move(part.shape));
      bodies.names.push_back(std::move(part.name));
      bodies.blocker_ids.push_back(b);
    }
    if (auto space = enclosed_space(scene.blockers[b])) bodies.obstacles.enclosures.push_back(std::move(*space));
  }
  return bodies;
}

planar::LightVisibility planar_visibility(const PlaneScene& scene, const PlanarLight& light) {
  std::vector<planar::BlockerSegment> segments;
  for (const PlanarBlocker& blocker : scene.blockers) {
    const auto parts = planar::segments_of_polyline(blocker.vertices);
    segments.insert(segments.end(), parts.begin(), parts.end());
  }
  return planar::LightVisibility(planar::Flatland::from_points(light.vertices, segments));
}

}  // namespace gnomon
