#include "geometry/spatial/touching_sheets.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "gnomon/errors.h"

namespace gnomon {
namespace {

using Triangle = ExactTriangles::Triangle;
using Edge = std::array<std::uint32_t, 2>;

/// The use of an edge by a triangle: from its corner i to the next one. Corners are numbered 3 * triangle + i.
struct CornerUse {
  std::size_t start;
  std::size_t end;
  std::size_t opposite;
  bool forward;  ///< from the lower to the higher vertex
};

/// Joins the corners of two triangles along an edge that they use in opposite directions.
void join(boost::disjoint_sets_with_storage<>& fans, const CornerUse& a, const CornerUse& b) {
  fans.union_set(a.start, b.end);
  fans.union_set(a.end, b.start);
}

std::uint32_t vertex(const ExactTriangles& surface, std::size_t corner) {
  return surface.triangles[corner / 3].vertices[corner % 3];
}

std::map<Edge, std::vector<CornerUse>> corner_uses(const ExactTriangles& surface) {
  std::map<Edge, std::vector<CornerUse>> uses;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const CornerUse use{3 * t + i, 3 * t + (i + 1) % 3, 3 * t + (i + 2) % 3, false};
      const std::uint32_t a = vertex(surface, use.start);
      const std::uint32_t b = vertex(surface, use.end);
      uses[{std::min(a, b), std::max(a, b)}].push_back({use.start, use.end, use.opposite, a < b});
    }
  }
  return uses;
}

/// A direction across an edge, in a frame round the edge; its angle runs from 0 up to a full turn.
struct Across {
  Rational x;
  Rational y;
  CornerUse use;

  bool in_second_half() const { return y < 0 || (y == 0 && x < 0); }
  friend bool operator<(const Across& a, const Across& b) {
    if (a.in_second_half() != b.in_second_half()) return b.in_second_half();
    return a.x * b.y - a.y * b.x > 0;
  }
};

/// The triangles round an edge, counterclockwise seen from its higher vertex.
std::vector<Across> sorted_around(const ExactTriangles& surface, const Edge& edge, const std::vector<CornerUse>& uses) {
  const ExactVector& origin = surface.points[edge[0]];
  const ExactVector axis = surface.points[edge[1]] - origin;
  const auto arm = [&](const CornerUse& use) { return surface.points[vertex(surface, use.opposite)] - origin; };
  const ExactVector v = cross(axis, arm(uses.front()));
  const ExactVector u = cross(v, axis);
  std::vector<Across> around;
  // u and v differ in length, which stretches angles but keeps their order.
  for (const CornerUse& use : uses) around.push_back({dot(arm(use), u), dot(arm(use), v), use});
  std::sort(around.begin(), around.end());
  return around;
}

using UsePair = std::pair<CornerUse, CornerUse>;

/// Pairs of triangles with the volume between them. From one that runs forward the volume lies clockwise.
std::vector<UsePair> joined_by_volume(const ExactTriangles& surface, const Edge& edge,
                                      const std::vector<CornerUse>& uses) {
  if (uses.size() == 2 && uses[0].forward != uses[1].forward) return {{uses[0], uses[1]}};
  const std::vector<Across> around = sorted_around(surface, edge, uses);
  std::vector<UsePair> pairs;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const CornerUse& use = around[i].use;
    const CornerUse& before = around[(i + around.size() - 1) % around.size()].use;
    if (use.forward == before.forward) throw PreconditionError("triangles are no boundary of a volume");
    if (use.forward) pairs.emplace_back(use, before);
  }
  return pairs;
}

/// Gives every fan a vertex of its own.
void split_vertices(ExactTriangles& surface, boost::disjoint_sets_with_storage<>& fans) {
  std::vector<bool> is_taken(surface.points.size());
  std::map<std::size_t, std::uint32_t> vertex_of_fan;
  for (std::size_t corner = 0; corner < 3 * surface.triangles.size(); ++corner) {
    std::uint32_t& v = surface.triangles[corner / 3].vertices[corner % 3];
    const auto [entry, is_new] = vertex_of_fan.try_emplace(fans.find_set(corner), v);
    if (is_new && is_taken[v]) {
      entry->second = static_cast<std::uint32_t>(surface.points.size());
      const ExactVector copy = surface.points[v];
      surface.points.push_back(copy);
    }
    if (is_new) is_taken[v] = true;
    v = entry->second;
  }
}

/// For the edge that starts at each corner the vertex at its middle, if it is divided.
using Middles = std::map<std::size_t, std::uint32_t>;

Middles middles_of_shared_edges(ExactTriangles& surface, const std::vector<UsePair>& pairs) {
  std::map<Edge, std::vector<const UsePair*>> sheets;
  for (const UsePair& pair : pairs) {
    const std::uint32_t a = vertex(surface, pair.first.start);
    const std::uint32_t b = vertex(surface, pair.first.end);
    sheets[{std::min(a, b), std::max(a, b)}].push_back(&pair);
  }
  Middles middles;
  for (const auto& [edge, list] : sheets) {
    for (std::size_t i = 0; i < list.size() && list.size() > 1; ++i) {
      const ExactVector& a = surface.points[edge[0]];
      const ExactVector& b = surface.points[edge[1]];
      const ExactVector middle{Rational((a[0] + b[0]) / 2), Rational((a[1] + b[1]) / 2), Rational((a[2] + b[2]) / 2)};
      middles[list[i]->first.start] = middles[list[i]->second.start] =
          static_cast<std::uint32_t>(surface.points.size());
      surface.points.push_back(middle);
    }
  }
  return middles;
}

/// Appends a triangle with middles in its edges: corners beside a middle are cut off, the rest is a fan.
void divide(const Triangle& triangle, const std::array<std::optional<std::uint32_t>, 3>& middles,
            std::vector<Triangle>& result) {
  std::vector<std::uint32_t> rest;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& before = middles[(i + 2) % 3];
    const auto& after = middles[i];
    const std::uint32_t v = triangle.vertices[i];
    if (before && after) {
      result.push_back({{*before, v, *after}, triangle.facet});
    } else {
      rest.push_back(v);
    }
    if (after) rest.push_back(*after);
  }
  // A fan from a middle has no straight corner, if any middle is left.
  const auto has_middle = [&](std::uint32_t v) {
    return std::find(middles.begin(), middles.end(), std::optional(v)) != middles.end();
  };
  const auto start = std::find_if(rest.begin(), rest.end(), has_middle);
  if (start != rest.end()) std::rotate(rest.begin(), start, rest.end());
  for (std::size_t i = 1; i + 1 < rest.size(); ++i) {
    result.push_back({{rest[0], rest[i], rest[i + 1]}, triangle.facet});
  }
}

void divide_shared_edges(ExactTriangles& surface, const std::vector<UsePair>& pairs) {
  const Middles middles = middles_of_shared_edges(surface, pairs);
  if (middles.empty()) return;
  std::vector<Triangle> result;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    std::array<std::optional<std::uint32_t>, 3> inside;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto middle = middles.find(3 * t + i);
      if (middle != middles.end()) inside[i] = middle->second;
    }
    divide(surface.triangles[t], inside, result);
  }
  surface.triangles = std::move(result);
}

}  // namespace

ExactTriangles with_sheets_apart(ExactTriangles surface) {
  boost::disjoint_sets_with_storage<> fans(3 * surface.triangles.size());
  std::vector<UsePair> pairs;
  for (const auto& [edge, uses] : corner_uses(surface)) {
    for (const UsePair& pair : joined_by_volume(surface, edge, uses)) {
      join(fans, pair.first, pair.second);
      pairs.push_back(pair);
    }
  }
  split_vertices(surface, fans);
  divide_shared_edges(surface, pairs);
  return surface;
}

}  // namespace gnomon
