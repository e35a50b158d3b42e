#pragma once

/// Triangles that halve each other's edges and stay conforming. Private to the libraries.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "shading/illumination/first_triangles.h"

namespace gnomon::illumination {

inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

struct HalvingTriangle {
  std::array<std::uint32_t, 3> corners{};                 ///< counterclockwise seen from the front
  std::array<std::uint8_t, 3> orders{};                   ///< of edge k, from corner k to the next
  std::array<std::uint32_t, 3> beyond{none, none, none};  ///< the triangle across edge k
  std::uint32_t receiver = 0;
};

/// A triangle from corners (a, b, c) became (a, m, c), which keeps its number, and (m, b, c).
struct Halving {
  std::uint32_t kept = 0;
  std::uint32_t fresh = 0;
  std::array<std::uint32_t, 3> line{};  ///< a, m, c
};

class HalvingMesh {
 public:
  explicit HalvingMesh(FirstTriangles first);

  const std::vector<Point3>& points() const { return points_; }
  const std::vector<HalvingTriangle>& triangles() const { return triangles_; }

  /// The number of an edge's middle, which becomes a corner when the edge is halved.
  std::uint32_t middle(std::uint32_t a, std::uint32_t b);
  /// The same, which has been asked for before.
  std::uint32_t known_middle(std::uint32_t a, std::uint32_t b) const { return middles_.at(std::minmax(a, b)); }

  /// The longest edge of a triangle; of equal ones the first.
  int longest_edge(std::uint32_t triangle) const;
  double length(std::uint32_t triangle, int edge) const;

  /// Halves an edge of a triangle, and so the triangle across. What was halved is appended.
  void halve(std::uint32_t triangle, int edge, std::vector<Halving>& halved);

 private:
  Halving split(std::uint32_t triangle, int edge, std::uint32_t middle);
  int edge_towards(std::uint32_t triangle, std::uint32_t other) const;

  std::vector<Point3> points_;
  std::vector<HalvingTriangle> triangles_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

}  // namespace gnomon::illumination
