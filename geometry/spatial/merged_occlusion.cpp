#include "gnomon/shadow_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <CGAL/determinant.h>

#include "geometry/bodies/boxes.h"
#include "geometry/numbers/rounding.h"
#include "geometry/spatial/exposed_facets.h"
#include "geometry/spatial/pair_polyhedra.h"
#include "geometry/spatial/touching_sheets.h"
#include "geometry/spatial/vertex_rounding.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// The occlusion volume of one part.
struct OcclusionPart {
  std::vector<ExactFacet> facets;
  std::vector<FacetName> names;
};

/// What one part shows of one of its facets.
struct ExposedFacet {
  FacetName name;
  std::uint32_t part;
  std::array<Rational, 4> plane;
  std::vector<Edge> edges;
};

OcclusionPart occlusion_part(const Light& light, const ConvexBlocker& blocker, const Box3& box) {
  const PreparedPair pair = prepared_pair(light, blocker);
  std::optional<PairPolyhedra> polyhedra;
  {
    const CGAL::Protect_FPU_rounding<true> protection;
    polyhedra.emplace(pair, box);
  }
  const ExactSpace& space = polyhedra->planes.space;
  OcclusionPart result;
  for (const auto& face : polyhedra->occlusion.faces) {
    const Quadruple<ExactReal>& plane = space.exact_plane(face.plane);
    ExactFacet facet{{rational(plane[0]), rational(plane[1]), rational(plane[2]), rational(plane[3])}, {}};
    for (const VertexId v : face.loop) facet.loop.push_back(exact_coordinates(space, v));
    result.facets.push_back(std::move(facet));
    result.names.push_back(space.name(face.plane));
  }
  return result;
}

/// Points by their place.
class Places {
 public:
  std::uint32_t index(const ExactVector& point) {
    const auto [entry, is_new] = indices_.try_emplace(point, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(point);
    return entry->second;
  }
  const std::vector<ExactVector>& points() const { return points_; }

 private:
  std::map<ExactVector, std::uint32_t> indices_;
  std::vector<ExactVector> points_;
};

/// A line by its direction, of which the first coordinate that is not zero is 1, and its point where that coordinate
/// is 0.
using Line = std::array<ExactVector, 2>;

Line line_through(const ExactVector& p, const ExactVector& q) {
  std::size_t main = 0;
  while (p[main] == q[main]) ++main;
  Line line;
  for (std::size_t i = 0; i < 3; ++i) line[0][i] = (q[i] - p[i]) / (q[main] - p[main]);
  for (std::size_t i = 0; i < 3; ++i) line[1][i] = p[i] - line[0][i] * p[main];
  return line;
}

/// The ends of edges on every line; on a line their lexicographic order is that along it.
using PointsOnLines = std::map<Line, std::map<ExactVector, std::uint32_t>>;

/// Divides edges where others on the same line end. In a closed surface no edge ends inside another one but there,
/// unless it only touches it.
std::vector<Edge> divided(const std::vector<Edge>& edges, const std::vector<ExactVector>& points,
                          const PointsOnLines& lines) {
  std::vector<Edge> result;
  for (const auto& [a, b] : edges) {
    const auto& on_line = lines.at(line_through(points[a], points[b]));
    const bool forward = points[a] < points[b];
    auto at = on_line.find(points[a]);
    for (std::uint32_t last = a; last != b; last = at->second) {
      forward ? ++at : --at;
      result.push_back({last, at->second});
    }
  }
  return result;
}

ExactTriangles triangulated(const std::vector<ExposedFacet>& facets, const std::vector<ExactVector>& points) {
  PointsOnLines lines;
  for (const ExposedFacet& facet : facets) {
    for (const auto& [a, b] : facet.edges) {
      auto& on_line = lines[line_through(points[a], points[b])];
      on_line.emplace(points[a], a);
      on_line.emplace(points[b], b);
    }
  }
  ExactTriangles result{points, {}};
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    const std::vector<Edge> edges = divided(facets[f].edges, points, lines);
    for (const auto& triangle : region_triangles(facets[f].plane, points, edges)) {
      result.triangles.push_back({triangle, f});
    }
  }
  return result;
}

ExactNumber exact_volume(const ExactTriangles& surface) {
  Rational six_volumes = 0;
  for (const auto& triangle : surface.triangles) {
    const ExactVector& a = surface.points[triangle.vertices[0]];
    const ExactVector& b = surface.points[triangle.vertices[1]];
    const ExactVector& c = surface.points[triangle.vertices[2]];
    six_volumes += CGAL::determinant<Rational>(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]);
  }
  return exact_number(six_volumes / 6);
}

VolumeMesh rounded(const ExactTriangles& surface) {
  VolumeMesh mesh;
  for (const ExactVector& p : surface.points) {
    mesh.vertices.push_back({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
  }
  for (const auto& triangle : surface.triangles) mesh.triangles.push_back({triangle.vertices, triangle.facet});
  mesh.volume = exact_volume(surface);
  return mesh;
}

std::vector<OcclusionPart> occlusion_parts(const Light& light, std::span<const ConvexBlocker> blockers,
                                           const Box3& box) {
  if (!has_interior(box)) throw PreconditionError("a clip box needs finite bounds with min < max");
  std::vector<OcclusionPart> result;
  for (const ConvexBlocker& blocker : blockers) result.push_back(occlusion_part(light, blocker, box));
  return result;
}

ExposedFacets exposed_facets(const std::vector<OcclusionPart>& parts, const Point3& along) {
  std::vector<std::vector<ExactFacet>> polyhedra;
  for (const OcclusionPart& part : parts) polyhedra.push_back(part.facets);
  return ExposedFacets(polyhedra, along);
}

/// About the way from the light to the parts, by which shadows are long.
Point3 main_direction(const Light& light, std::span<const ConvexBlocker> parts) {
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) return sun->direction;
  const auto middle = [](const Box3& box) {
    return Point3{box.min.x / 2 + box.max.x / 2, box.min.y / 2 + box.max.y / 2, box.min.z / 2 + box.max.z / 2};
  };
  Box3 around = empty_box3();
  for (const ConvexBlocker& part : parts) {
    for (const Point3& p : std::visit([](const auto& shape) { return shape.points(); }, part)) include(around, p);
  }
  const Point3 from = middle(box_around(light_points(light))), to = middle(around);
  return parts.empty() ? Point3{} : Point3{to.x - from.x, to.y - from.y, to.z - from.z};
}

}  // namespace

struct OcclusionMerger::State {
  std::vector<OcclusionPart> parts;
  ExposedFacets exposed;
  std::size_t next = 0;
  std::vector<ExposedFacet> facets;
  Places places;

  State(std::vector<OcclusionPart> all, const Point3& along)
      : parts(std::move(all)), exposed(exposed_facets(parts, along)) {}
};

OcclusionMerger::OcclusionMerger(const Light& light, std::span<const ConvexBlocker> parts, const Box3& box)
    : state_(std::make_unique<State>(occlusion_parts(light, parts, box), main_direction(light, parts))) {}
OcclusionMerger::OcclusionMerger(OcclusionMerger&&) noexcept = default;
OcclusionMerger& OcclusionMerger::operator=(OcclusionMerger&&) noexcept = default;
OcclusionMerger::~OcclusionMerger() = default;

std::size_t OcclusionMerger::remaining() const {
  return state_->parts.size() - state_->next;
}

void OcclusionMerger::advance() {
  if (remaining() == 0) throw PreconditionError("every part has been merged");
  const std::size_t part = state_->next++;
  const OcclusionPart& occlusion = state_->parts[part];
  for (std::size_t f = 0; f < occlusion.facets.size(); ++f) {
    ExposedFacet facet{occlusion.names[f], static_cast<std::uint32_t>(part), occlusion.facets[f].plane, {}};
    for (const auto& [a, b] : state_->exposed.edges(part, f)) {
      const std::uint32_t from = state_->places.index(a);
      facet.edges.push_back({from, state_->places.index(b)});
    }
    if (!facet.edges.empty()) state_->facets.push_back(std::move(facet));
  }
}

MergedOcclusion OcclusionMerger::result() const {
  if (remaining() > 0) throw PreconditionError("parts are still to be merged");
  MergedOcclusion result;
  result.mesh = rounded(with_sheets_apart(triangulated(state_->facets, state_->places.points())));
  for (const ExposedFacet& facet : state_->facets) {
    result.mesh.facets.push_back(facet.name);
    result.mesh.truncated = result.mesh.truncated || facet.name.kind == FacetKind::clip_box;
    result.facet_part.push_back(facet.part);
  }
  return result;
}

MergedOcclusion merged_occlusion(const Light& light, std::span<const ConvexBlocker> parts, const Box3& box) {
  OcclusionMerger merger(light, parts, box);
  while (merger.remaining() > 0) merger.advance();
  return merger.result();
}

}  // namespace gnomon
