#include "gnomon/blocker.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometry/bodies/hull_triangles.h"
#include "geometry/numbers/kernel.h"
#include "geometry/numbers/orientation.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

using CornerLoop = std::vector<std::uint32_t>;

bool are_finite(std::span<const Point3> points) {
  const auto finite = [](const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  return std::all_of(points.begin(), points.end(), finite);
}

/// Indices of points that differ, the first of every set of equal ones, ascending.
std::vector<std::uint32_t> distinct_points(std::span<const Point3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::tie(points[i].x, points[i].y, points[i].z); };
  std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return key(i) < key(j); });
  order.erase(std::unique(order.begin(), order.end(), [&](auto i, auto j) { return key(i) == key(j); }), order.end());
  std::sort(order.begin(), order.end());
  return order;
}

/// The triangles of the hull, by indices into `points`.
std::vector<HullTriangle> triangles_of(std::span<const Point3> points) {
  const std::vector<std::uint32_t> indices = distinct_points(points);
  std::vector<Point3> distinct;
  distinct.reserve(indices.size());
  for (const std::uint32_t i : indices) distinct.push_back(points[i]);
  std::vector<HullTriangle> triangles = hull_triangles(distinct);
  for (HullTriangle& triangle : triangles) {
    for (std::uint32_t& corner : triangle) corner = indices[corner];
  }
  return triangles;
}

/// One side of an edge, and the triangle or facet that lies there.
struct HalfEdge {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t face;
};

/// Makes the two half-edges of each edge neighbours, the one that runs upwards first.
void pair_up(std::vector<HalfEdge>& halves) {
  const auto key = [](const HalfEdge& h) { return std::tuple(std::min(h.from, h.to), std::max(h.from, h.to), h.from); };
  std::sort(halves.begin(), halves.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

std::vector<HalfEdge> paired_half_edges(const std::vector<HullTriangle>& triangles) {
  std::vector<HalfEdge> result;
  result.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) result.push_back({from, to, t});
  }
  pair_up(result);
  return result;
}

bool are_coplanar(std::span<const Point3> points, const HullTriangle& s, const HullTriangle& t) {
  const auto is_corner_of_s = [&](std::uint32_t i) { return std::find(s.begin(), s.end(), i) != s.end(); };
  const std::uint32_t other = *std::find_if_not(t.begin(), t.end(), is_corner_of_s);
  return exact_orientation(points[s[0]], points[s[1]], points[s[2]], points[other]) == 0;
}

/// The half-edges between facets, ordered by facet and then by where they start; `face` is the facet's group.
std::vector<HalfEdge> facet_half_edges(std::span<const Point3> points, const std::vector<HullTriangle>& triangles) {
  const std::vector<HalfEdge> halves = paired_half_edges(triangles);
  boost::disjoint_sets_with_storage<> groups(triangles.size());
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    const std::uint32_t s = halves[i].face, t = halves[i + 1].face;
    if (are_coplanar(points, triangles[s], triangles[t])) groups.union_set(s, t);
  }
  std::vector<HalfEdge> result;
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    const auto s = static_cast<std::uint32_t>(groups.find_set(halves[i].face));
    const auto t = static_cast<std::uint32_t>(groups.find_set(halves[i + 1].face));
    if (s == t) continue;
    result.push_back({halves[i].from, halves[i].to, s});
    result.push_back({halves[i + 1].from, halves[i + 1].to, t});
  }
  const auto key = [](const HalfEdge& h) { return std::pair(h.face, h.from); };
  std::sort(result.begin(), result.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return result;
}

/// The loop made of half-edges ordered by where they start, without the vertices between collinear ones.
CornerLoop strict_loop(std::span<const Point3> points, std::span<const HalfEdge> halves) {
  CornerLoop all;
  for (std::uint32_t at = halves.front().from; all.empty() || at != all.front();) {
    all.push_back(at);
    at = std::lower_bound(halves.begin(), halves.end(), at, [](const auto& h, auto from) { return h.from < from; })->to;
  }
  CornerLoop strict;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Point3& before = points[all[i == 0 ? all.size() - 1 : i - 1]];
    const Point3& after = points[all[i + 1 == all.size() ? 0 : i + 1]];
    if (!CGAL::collinear(to_cgal(before), to_cgal(points[all[i]]), to_cgal(after))) strict.push_back(all[i]);
  }
  std::rotate(strict.begin(), std::min_element(strict.begin(), strict.end()), strict.end());
  return strict;
}

std::vector<ConvexSolid::Facet> merged_facets(std::span<const Point3> points,
                                              const std::vector<HullTriangle>& triangles) {
  const std::vector<HalfEdge> halves = facet_half_edges(points, triangles);
  std::vector<ConvexSolid::Facet> facets;
  for (auto first = halves.begin(); first != halves.end();) {
    const auto last = std::find_if(first, halves.end(), [&](const auto& h) { return h.face != first->face; });
    facets.push_back({strict_loop(points, {first, last})});
    first = last;
  }
  std::sort(facets.begin(), facets.end(), [](const auto& a, const auto& b) { return a.loop < b.loop; });
  return facets;
}

std::vector<ConvexSolid::Edge> edges_of(std::span<const ConvexSolid::Facet> facets) {
  std::vector<HalfEdge> halves;
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    const CornerLoop& loop = facets[f].loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      halves.push_back({loop[i], loop[i + 1 == loop.size() ? 0 : i + 1], f});
    }
  }
  pair_up(halves);
  std::vector<ConvexSolid::Edge> edges;
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    edges.push_back({halves[i].from, halves[i].to, halves[i].face, halves[i + 1].face});
  }
  return edges;
}

}  // namespace

ConvexSolid ConvexSolid::hull_of(std::vector<Point3> points) {
  if (points.size() < 4) throw PreconditionError("fewer than 4 points are no solid");
  if (!are_finite(points)) throw PreconditionError("a coordinate is not finite");
  const std::vector<HullTriangle> triangles = triangles_of(points);
  if (triangles.empty()) throw PreconditionError("the points of a solid lie in one plane");
  ConvexSolid solid;
  solid.points_ = std::move(points);
  solid.facets_ = merged_facets(solid.points_, triangles);
  solid.edges_ = edges_of(solid.facets_);
  for (const Facet& facet : solid.facets_) {
    solid.corners_.insert(solid.corners_.end(), facet.loop.begin(), facet.loop.end());
  }
  std::sort(solid.corners_.begin(), solid.corners_.end());
  solid.corners_.erase(std::unique(solid.corners_.begin(), solid.corners_.end()), solid.corners_.end());
  return solid;
}

}  // namespace gnomon
