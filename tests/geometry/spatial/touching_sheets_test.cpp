#include "geometry/spatial/touching_sheets.h"

#include <CGAL/determinant.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

#include "apps/proof/laws/draw.h"
#include "gnomon/errors.h"

// Unions of unit cubes touch themselves in every way: along edges, round them, at vertices.

namespace gnomon {
namespace {

using Cube = std::array<int, 3>;
using Cubes = std::set<Cube>;

class SurfaceOfCubes {
 public:
  explicit SurfaceOfCubes(const Cubes& cubes) {
    for (const Cube& cube : cubes) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
          Cube neighbour = cube;
          neighbour[axis] += side == 1 ? 1 : -1;
          if (!cubes.count(neighbour)) add_square(cube, axis, side);
        }
      }
    }
  }
  const ExactTriangles& triangles() const { return triangles_; }

 private:
  void add_square(Cube corner, std::size_t axis, int side) {
    corner[axis] += side;
    const std::size_t u = (axis + (side == 1 ? 1 : 2)) % 3;
    const std::size_t v = (axis + (side == 1 ? 2 : 1)) % 3;
    std::array<std::uint32_t, 4> loop;
    for (std::size_t k = 0; k < 4; ++k) {
      Cube p = corner;
      p[u] += k == 1 || k == 2;
      p[v] += k >= 2;
      loop[k] = index(p);
    }
    triangles_.triangles.push_back({{loop[0], loop[1], loop[2]}, 0});
    triangles_.triangles.push_back({{loop[0], loop[2], loop[3]}, 0});
  }
  std::uint32_t index(const Cube& p) {
    const auto [entry, is_new] = indices_.try_emplace(p, static_cast<std::uint32_t>(indices_.size()));
    if (is_new) triangles_.points.push_back({Rational(p[0]), Rational(p[1]), Rational(p[2])});
    return entry->second;
  }

  ExactTriangles triangles_;
  std::map<Cube, std::uint32_t> indices_;
};

Rational volume(const ExactTriangles& surface) {
  Rational six_volumes = 0;
  for (const auto& [v, facet] : surface.triangles) {
    const auto& [a, b, c] = std::array{surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]};
    six_volumes += CGAL::determinant<Rational>(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]);
  }
  return six_volumes / 6;
}

using DirectedEdges = std::map<std::array<std::uint32_t, 2>, int>;

DirectedEdges directed_edges(const ExactTriangles& surface) {
  DirectedEdges edges;
  for (const auto& [v, facet] : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{v[i], v[(i + 1) % 3]}];
  }
  return edges;
}

bool every_edge_is_in_two_triangles(const ExactTriangles& surface) {
  const DirectedEdges edges = directed_edges(surface);
  for (const auto& [edge, count] : edges) {
    if (count != 1 || !edges.count({edge[1], edge[0]})) return false;
  }
  return true;
}

RC_GTEST_PROP(TouchingSheetsProperty, EveryEdgeOfAnyUnionOfCubesIsInTwoTrianglesAndTheVolumeIsKept, ()) {
  const Cubes cubes = *rc::gen::exec([] {
    Cubes drawn;
    const int count = laws::draw(1, 20);
    for (int i = 0; i < count; ++i) drawn.insert({laws::draw(0, 2), laws::draw(0, 2), laws::draw(0, 2)});
    return drawn;
  });
  const SurfaceOfCubes surface(cubes);
  const ExactTriangles apart = with_sheets_apart(surface.triangles());
  RC_TAG(apart.points.size() > surface.triangles().points.size() ? "touches itself" : "touches nothing");
  RC_ASSERT(every_edge_is_in_two_triangles(apart));
  RC_ASSERT(volume(apart) == Rational(cubes.size()));
}

TEST(TouchingSheetsDegenerate, CubesThatShareAnEdgeAloneGetEndsOfTheirOwn) {
  const SurfaceOfCubes surface({{0, 0, 0}, {1, 1, 0}});
  const ExactTriangles apart = with_sheets_apart(surface.triangles());
  EXPECT_TRUE(every_edge_is_in_two_triangles(apart));
  EXPECT_EQ(surface.triangles().points.size(), 14u);
  EXPECT_EQ(apart.points.size(), 16u);
}

TEST(TouchingSheetsDegenerate, AnEdgeWhoseEndsAreInOneFanIsDividedForEachSheet) {
  Cubes cubes = {{0, 0, 1}, {1, 1, 1}};
  for (const int z : {0, 2}) {
    for (const int x : {0, 1}) {
      for (const int y : {0, 1}) cubes.insert({x, y, z});
    }
  }
  const SurfaceOfCubes surface(cubes);
  EXPECT_FALSE(every_edge_is_in_two_triangles(surface.triangles()));
  const ExactTriangles apart = with_sheets_apart(surface.triangles());
  EXPECT_TRUE(every_edge_is_in_two_triangles(apart));
  EXPECT_EQ(apart.points.size(), surface.triangles().points.size() + 2);
  EXPECT_EQ(volume(apart), 10);
}

TEST(TouchingSheets, RefusesTrianglesThatBoundNoVolume) {
  ExactTriangles open = SurfaceOfCubes({{0, 0, 0}}).triangles();
  open.triangles.pop_back();
  EXPECT_THROW(with_sheets_apart(open), PreconditionError);
}

}  // namespace
}  // namespace gnomon
