#include "shading/illumination/halving_mesh.h"

#include <algorithm>
#include <cmath>

namespace gnomon::illumination {
namespace {

Point3 half_way(const Point3& a, const Point3& b) {
  return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
}

std::uint32_t next(int k) {
  return static_cast<std::uint32_t>((k + 1) % 3);
}

}  // namespace

HalvingMesh::HalvingMesh(FirstTriangles first) : points_(std::move(first.points)) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::uint32_t, int>> sides;
  for (std::uint32_t t = 0; t < first.triangles.size(); ++t) {
    const FirstTriangle& triangle = first.triangles[t];
    triangles_.push_back({triangle.corners, triangle.orders, {none, none, none}, triangle.receiver});
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle.corners[static_cast<std::size_t>(k)], b = triangle.corners[next(k)];
      sides[{a, b}] = {t, k};
      const auto other = sides.find({b, a});
      if (other == sides.end()) continue;
      const auto& [u, j] = other->second;
      triangles_[t].beyond[static_cast<std::size_t>(k)] = u;
      triangles_[u].beyond[static_cast<std::size_t>(j)] = t;
    }
  }
}

std::uint32_t HalvingMesh::middle(std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  const auto [found, is_new] = middles_.try_emplace({low, high}, static_cast<std::uint32_t>(points_.size()));
  if (is_new) points_.push_back(half_way(points_[low], points_[high]));
  return found->second;
}

double HalvingMesh::length(std::uint32_t triangle, int edge) const {
  const auto& corners = triangles_[triangle].corners;
  const Point3 &a = points_[corners[static_cast<std::size_t>(edge)]], &b = points_[corners[next(edge)]];
  return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

int HalvingMesh::longest_edge(std::uint32_t triangle) const {
  int longest = 0;
  for (int k = 1; k < 3; ++k) {
    if (length(triangle, k) > length(triangle, longest)) longest = k;
  }
  return longest;
}

int HalvingMesh::edge_towards(std::uint32_t triangle, std::uint32_t other) const {
  const auto& beyond = triangles_[triangle].beyond;
  return static_cast<int>(std::ranges::find(beyond, other) - beyond.begin());
}

/// Keeps the half at the edge's start and appends that at its end; what lies across the edge is left to the caller.
Halving HalvingMesh::split(std::uint32_t triangle, int edge, std::uint32_t middle) {
  const auto k = static_cast<std::size_t>(edge), l = (k + 1) % 3, m = (k + 2) % 3;
  const auto fresh = static_cast<std::uint32_t>(triangles_.size());
  HalvingTriangle other = triangles_[triangle];
  HalvingTriangle& kept = triangles_[triangle];
  kept.corners[l] = middle;
  kept.orders[l] = smooth;
  kept.beyond[l] = fresh;
  other.corners[k] = middle;
  other.orders[m] = smooth;
  other.beyond[m] = triangle;
  if (const std::uint32_t far = other.beyond[l]; far != none) {
    triangles_[far].beyond[static_cast<std::size_t>(edge_towards(far, triangle))] = fresh;
  }
  const Halving halving{triangle, fresh, {kept.corners[k], middle, kept.corners[m]}};
  triangles_.push_back(other);
  return halving;
}

void HalvingMesh::halve(std::uint32_t triangle, int edge, std::vector<Halving>& halved) {
  const auto k = static_cast<std::size_t>(edge);
  const std::uint32_t across = triangles_[triangle].beyond[k];
  const std::uint32_t place = middle(triangles_[triangle].corners[k], triangles_[triangle].corners[next(edge)]);
  const int back = across == none ? 0 : edge_towards(across, triangle);
  halved.push_back(split(triangle, edge, place));
  const std::uint32_t fresh = halved.back().fresh;
  if (across == none) return;
  // The neighbour keeps its half at its edge's start, which is this one's end.
  halved.push_back(split(across, back, place));
  const std::uint32_t fresh_across = halved.back().fresh;
  const auto j = static_cast<std::size_t>(back);
  triangles_[fresh].beyond[k] = across;
  triangles_[across].beyond[j] = fresh;
  triangles_[triangle].beyond[k] = fresh_across;
  triangles_[fresh_across].beyond[j] = triangle;
}

}  // namespace gnomon::illumination
