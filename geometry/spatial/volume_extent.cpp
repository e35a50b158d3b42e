#include "geometry/spatial/volume_extent.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "geometry/spatial/shadow_polyhedra.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

/// Number of sets with a member that counts.
std::uint32_t number_of_sets(boost::disjoint_sets_with_storage<>& sets, const std::vector<bool>& counts) {
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i]) found.insert(sets.find_set(i));
  }
  return static_cast<std::uint32_t>(found.size());
}

/// The axes across the largest component of the downward plane's normal. All is exact: a facet may be a needle.
std::array<std::uint32_t, 2> lateral_axes(const ExactSpace& space) {
  const Quadruple<ExactReal>& plane = space.exact_plane(ExactSpace::downward);
  const auto square = [&](std::uint32_t i) -> ExactReal { return plane[i] * plane[i]; };
  std::uint32_t largest = 0;
  for (const std::uint32_t i : {1U, 2U}) {
    if (square(i) > square(largest)) largest = i;
  }
  return {(largest + 1) % 3, (largest + 2) % 3};
}

double coordinate(const Point3& p, std::uint32_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// Bounds, wide of the mark, of (b - apex)_axis / (h(apex) - h(b)) over the blocker's corners b, h being the height
/// above the downward plane: the slopes of a pyramid about the shadow of the apex.
std::array<double, 2> slopes(const ExactSpace& space, const Body& blocker, const Point3& apex, std::uint32_t axis,
                             int scale) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  const Interval top = space.height(ExactSpace::downward, apex, scale);
  for (const Point3& corner : blocker.corners) {
    const Interval across = Interval(coordinate(corner, axis)) - Interval(coordinate(apex, axis));
    const Interval slope = across / (top - space.height(ExactSpace::downward, corner, scale));
    low = std::min(low, slope.inf());
    high = std::max(high, slope.sup());
  }
  const double margin = high - low;
  return {low - margin, high + margin};
}

/// A scale at which the height of the apex is neither very small nor very large.
int scale_of(const ExactSpace& space, const Point3& apex) {
  int scale = 0;
  while (scale < 4 && space.height(ExactSpace::downward, apex, scale).sup() < 0x1p-500) ++scale;
  while (scale > -4 && space.height(ExactSpace::downward, apex, scale).sup() > 0x1p500) --scale;
  return scale;
}

/// A polyhedron about the shadow of the apex, without bound in the direction of the shadow: it lies below the downward
/// plane, inside four planes through the apex.
ConvexPolyhedron pyramid(ExactSpace& space, const Body& blocker, const Point3& apex) {
  const std::array<std::uint32_t, 2> axes = lateral_axes(space);
  const int scale = scale_of(space, apex);
  std::array<std::array<PlaneId, 2>, 2> sides;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [low, high] = slopes(space, blocker, apex, axes[i], scale);
    if (!std::isfinite(low) || !std::isfinite(high)) throw PreconditionError("coordinates differ too much in size");
    sides[i] = {space.add_apex_plane(apex, axes[i], -1, low, scale),
                space.add_apex_plane(apex, axes[i], 1, high, scale)};
  }
  std::array<VertexId, 8> v;  // bit 0: side of the first axis, bit 1: of the second, bit 2: at infinity
  for (std::size_t c = 0; c < 8; ++c) {
    const bool far = c & 4;
    v[c] = space.add_meet({sides[0][c & 1], sides[1][c >> 1 & 1], far ? ExactSpace::at_infinity : ExactSpace::downward},
                          far);
  }
  ConvexPolyhedron result;
  result.faces = {{ExactSpace::downward, {v[0], v[1], v[3], v[2]}}, {ExactSpace::at_infinity, {v[4], v[6], v[7], v[5]}},
                  {sides[0][0], {v[0], v[2], v[6], v[4]}},          {sides[0][1], {v[1], v[5], v[7], v[3]}},
                  {sides[1][0], {v[0], v[4], v[5], v[1]}},          {sides[1][1], {v[2], v[3], v[7], v[6]}}};
  if (space.turn(ExactSpace::downward, v[0], v[1], v[3]) < 0) {
    for (auto& face : result.faces) std::reverse(face.loop.begin(), face.loop.end());
  }
  return result;
}

bool reaches_infinity(const ExactSpace& space, const ConvexPolyhedron& polyhedron) {
  return std::any_of(polyhedron.faces.begin(), polyhedron.faces.end(), [&](const auto& face) {
    return std::any_of(face.loop.begin(), face.loop.end(), [&](VertexId v) { return space.is_direction(v); });
  });
}

using PointPair = std::array<std::array<double, 3>, 2>;

PointPair point_pair(const Point3& a, const Point3& b) {
  PointPair pair{{{a.x, a.y, a.z}, {b.x, b.y, b.z}}};
  if (pair[1] < pair[0]) std::swap(pair[0], pair[1]);
  return pair;
}

/// The blocker edges along which the umbra touches the occlusion's boundary.
std::set<PointPair> edges_on_occlusion(const PairHalfSpaces& half_spaces) {
  std::set<PointPair> edges;
  for (const HalfSpace& half_space : half_spaces.occlusion) {
    if (half_space.name.kind != FacetKind::separating_blocker_plane) continue;
    edges.insert(point_pair(half_space.plane[0], half_space.plane[1]));
  }
  return edges;
}

/// Connected pieces of the umbra's boundary inside the occlusion: faces in no plane of the occlusion, joined at edges
/// that are neither on its boundary (only one of the blocker's edges can be) nor at infinity.
std::uint32_t pieces_inside_occlusion(const ShadowPlanes& planes, const PairHalfSpaces& half_spaces,
                                      const ConvexPolyhedron& umbra) {
  const ExactSpace& space = planes.space;
  const std::set<PlaneId> outer(planes.occlusion.begin(), planes.occlusion.end());
  const std::set<PointPair> outer_edges = edges_on_occlusion(half_spaces);
  const auto is_no_joint = [&](VertexId a, VertexId b) {
    if (space.is_direction(a) && space.is_direction(b)) return true;
    const std::uint32_t i = space.vertex_definition(a).input;
    const std::uint32_t j = space.vertex_definition(b).input;
    if (i == VertexDefinition::none || j == VertexDefinition::none) return false;
    return outer_edges.count(point_pair(space.input(i).first, space.input(j).first)) != 0;
  };
  boost::disjoint_sets_with_storage<> groups(umbra.faces.size());
  std::vector<bool> counts;
  std::map<std::array<VertexId, 2>, std::size_t> edges;
  for (std::size_t f = 0; f < umbra.faces.size(); ++f) {
    counts.push_back(umbra.faces[f].plane != ExactSpace::at_infinity && !outer.count(umbra.faces[f].plane));
    if (!counts[f]) continue;
    const Loop& loop = umbra.faces[f].loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const VertexId a = loop[i];
      const VertexId b = loop[(i + 1) % loop.size()];
      const auto other = edges.find({b, a});
      if (other != edges.end() && !is_no_joint(a, b)) groups.union_set(f, other->second);
      edges[{a, b}] = f;
    }
  }
  return number_of_sets(groups, counts);
}

/// For each corner of the blocker: it is strictly inside the light's planes that bound the umbra.
std::vector<bool> corners_in_front(const BodyPair& pair, const PairHalfSpaces& half_spaces) {
  std::vector<bool> result(pair.blocker.corners.size(), true);
  for (const HalfSpace& half_space : half_spaces.umbra) {
    if (half_space.name.kind != FacetKind::light_plane) continue;
    const auto& [a, b, c] = half_space.plane;
    for (std::size_t k = 0; k < result.size(); ++k) {
      result[k] = result[k] && pair.orientation(a, b, c, pair.blocker.corners[k]) < 0;
    }
  }
  return result;
}

/// Connected pieces of a solid's boundary inside the umbra: facets in none of its planes, joined at edges; of both what
/// lies in front of the light.
std::uint32_t umbra_pockets(const BodyPair& pair, const PairHalfSpaces& half_spaces) {
  if (pair.blocker.flat) return 0;
  const std::vector<bool> in_front = corners_in_front(pair, half_spaces);
  std::vector<bool> counts;
  for (const Body::Facet& facet : pair.blocker.facets) {
    counts.push_back(std::any_of(facet.loop.begin(), facet.loop.end(), [&](std::uint32_t k) { return in_front[k]; }));
  }
  for (const HalfSpace& half_space : half_spaces.umbra) {
    if (half_space.name.kind == FacetKind::blocker_face) {
      counts[half_space.name.vertex_index.value()] = false;
    }
  }
  boost::disjoint_sets_with_storage<> groups(counts.size());
  for (const Body::Edge& edge : pair.blocker.edges) {
    if (!counts[edge.left] || !counts[edge.right]) continue;
    if (in_front[edge.from] || in_front[edge.to]) groups.union_set(edge.left, edge.right);
  }
  return number_of_sets(groups, counts);
}

/// A corner of the light outside the blocker, and a facet it sees.
struct Viewpoint {
  std::uint32_t corner;
  std::uint32_t facet;
};

std::optional<Viewpoint> viewpoint(const BodyPair& pair) {
  for (std::uint32_t j = 0; j < pair.light.corners.size(); ++j) {
    if (const auto facet = facet_seen(pair, j)) return Viewpoint{j, *facet};
  }
  return std::nullopt;
}

/// The umbra and the penumbra where the umbra has an interior and a light of several points a corner outside the
/// blocker.
void measure_umbra(const BodyPair& pair, const PairHalfSpaces& half_spaces, const Viewpoint& view,
                   VolumeExtents& extents) {
  const CGAL::Protect_FPU_rounding<true> protection;
  const Body& blocker = pair.blocker;
  ShadowPlanes planes(half_spaces, facet_half_space(pair, view.facet));
  const ConvexPolyhedron about = pyramid(planes.space, blocker, pair.light.corners[view.corner]);
  const ConvexPolyhedron umbra = part_inside(planes.space, about, planes.umbra);
  extents.umbra.bounded = !reaches_infinity(planes.space, umbra);
  if (pair.light.corners.size() > 1) {
    extents.penumbra.components = pieces_inside_occlusion(planes, half_spaces, umbra);
  }
}

}  // namespace

std::optional<std::uint32_t> facet_seen(const BodyPair& pair, std::uint32_t j) {
  for (std::uint32_t f = 0; f < pair.blocker.facets.size(); ++f) {
    if (pair.facet_side(f, j) > 0) return f;
  }
  return std::nullopt;
}

VolumeExtents volume_extents(const BodyPair& pair, const PairHalfSpaces& half_spaces) {
  VolumeExtents extents;
  if (half_spaces.occlusion_empty) return extents;
  extents.occlusion = {false, false, 1};
  const std::optional<Viewpoint> view = viewpoint(pair);
  if (!half_spaces.umbra_empty) {
    extents.umbra = {false, false, 1};
    extents.umbra_pockets = umbra_pockets(pair, half_spaces);
    if (view && !pair.light.at_infinity) measure_umbra(pair, half_spaces, *view, extents);
  } else {
    extents.penumbra.components = pair.blocker.flat && pair.light_sides(0).cross() ? 2 : 1;
  }
  extents.penumbra.empty = extents.penumbra.components == 0;
  extents.penumbra.bounded = extents.penumbra.empty;
  return extents;
}

}  // namespace gnomon
