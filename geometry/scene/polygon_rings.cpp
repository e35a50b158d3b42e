#include "geometry/scene/polygon_rings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/kernel.h"

namespace gnomon {
namespace {

/// Where the edges that are left lead, from each vertex.
using Ways = std::map<std::uint32_t, std::set<std::uint32_t>>;

/// The ring with every vertex called by the lowest index of its coordinates.
Ring with_lowest_names(std::span<const Point3> points, const Ring& ring) {
  const auto less = [](const Point3& p, const Point3& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); };
  std::map<Point3, std::uint32_t, decltype(less)> lowest(less);
  for (const std::uint32_t i : ring) {
    const auto [entry, is_new] = lowest.try_emplace(points[i], i);
    if (!is_new) entry->second = std::min(entry->second, i);
  }
  Ring named;
  named.reserve(ring.size());
  for (const std::uint32_t i : ring) named.push_back(lowest.at(points[i]));
  return named;
}

bool is_between(double value, double a, double b) {
  return std::min(a, b) <= value && value <= std::max(a, b);
}

/// Strictly inside of the segment from a to b; boxes settle nearly all.
bool lies_inside_edge(const Point3& p, const Point3& a, const Point3& b) {
  if (!is_between(p.x, a.x, b.x) || !is_between(p.y, a.y, b.y) || !is_between(p.z, a.z, b.z)) return false;
  return p != a && p != b && CGAL::collinear(to_cgal(a), to_cgal(p), to_cgal(b));
}

/// The ring with further vertices where its edges run through others of its vertices: a seam may be walked one way in
/// one step, the other way in several.
Ring with_touched_vertices(std::span<const Point3> points, const Ring& ring) {
  const std::set<std::uint32_t> vertices(ring.begin(), ring.end());
  Ring result;
  if (vertices.size() == ring.size()) return ring;  // no seam
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point3& from = points[ring[i]];
    const Point3& to = points[ring[i + 1 == ring.size() ? 0 : i + 1]];
    Ring inside;
    for (const std::uint32_t v : vertices) {
      if (lies_inside_edge(points[v], from, to)) inside.push_back(v);
    }
    const auto place = [&](std::uint32_t v) { return std::tie(points[v].x, points[v].y, points[v].z); };
    std::ranges::sort(inside, {}, place);
    if (std::tie(to.x, to.y, to.z) < std::tie(from.x, from.y, from.z)) std::ranges::reverse(inside);
    result.push_back(ring[i]);
    result.insert(result.end(), inside.begin(), inside.end());
  }
  return result;
}

/// Nothing if an edge runs one way more than once oftener than the other way.
std::optional<Ways> single_edges(const Ring& ring) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> upwards;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::uint32_t from = ring[i];
    const std::uint32_t to = ring[i + 1 == ring.size() ? 0 : i + 1];
    upwards[std::minmax(from, to)] += from < to ? 1 : -1;
  }
  Ways ways;
  for (const auto& [edge, times] : upwards) {
    if (times < -1 || times > 1) return std::nullopt;
    if (times == 1) ways[edge.first].insert(edge.second);
    if (times == -1) ways[edge.second].insert(edge.first);
  }
  return ways;
}

/// Takes the ring through the lowest vertex out of the edges. Nothing if it meets a vertex with two ways on.
std::optional<Ring> next_ring(Ways& ways) {
  Ring ring;
  for (std::uint32_t vertex = ways.begin()->first; ring.empty() || vertex != ring.front();) {
    const auto way = ways.find(vertex);
    if (way->second.size() != 1) return std::nullopt;
    ring.push_back(vertex);
    vertex = *way->second.begin();
    ways.erase(way);
  }
  return ring;
}

}  // namespace

Ring whole_ring(std::size_t n) {
  Ring ring(n);
  std::iota(ring.begin(), ring.end(), 0u);
  return ring;
}

Ring without_repeats(std::span<const Point3> points, const Ring& ring) {
  Ring kept;
  for (const std::uint32_t i : ring) {
    if (kept.empty() || points[kept.back()] != points[i]) kept.push_back(i);
  }
  while (kept.size() > 1 && points[kept.front()] == points[kept.back()]) kept.pop_back();
  return kept;
}

std::optional<std::vector<Ring>> without_seams(std::span<const Point3> points, const Ring& ring) {
  std::optional<Ways> ways = single_edges(with_touched_vertices(points, with_lowest_names(points, ring)));
  if (!ways) return std::nullopt;
  std::vector<Ring> rings;
  while (!ways->empty()) {
    std::optional<Ring> next = next_ring(*ways);
    if (!next) return std::nullopt;
    rings.push_back(std::move(*next));
  }
  return rings;
}

void put_outer_ring_first(std::span<const Point3> points, int dropped_axis, std::vector<Ring>& rings) {
  const auto lowest = [&](const Ring& ring) {
    std::pair<double, double> least{HUGE_VAL, HUGE_VAL};
    for (const std::uint32_t i : ring) {
      const Point2 p = projected(points[i], dropped_axis);
      least = std::min(least, {p.x, p.y});
    }
    return least;
  };
  const auto outer = std::ranges::min_element(rings, {}, lowest);
  if (outer != rings.end()) std::rotate(rings.begin(), outer, outer + 1);
}

std::vector<Point3> points_of_rings(std::span<const Point3> points, std::span<const Ring> rings) {
  std::vector<Point3> result;
  for (const Ring& ring : rings) {
    for (const std::uint32_t i : ring) result.push_back(points[i]);
  }
  return result;
}

}  // namespace gnomon
