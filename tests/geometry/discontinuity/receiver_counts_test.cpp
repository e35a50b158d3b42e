#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <set>
#include <tuple>

#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;

/// A triangle around (x, y) that no edge of another is parallel to, up to chance.
ConvexPolygon triangle(std::mt19937& random, double x, double y, double z, Facing facing) {
  std::uniform_real_distribution<double> shift(-0.25, 0.25);
  std::vector<Point3> points{{x + shift(random) - 1, y + shift(random) - 1, z + shift(random)},
                             {x + shift(random) + 1, y + shift(random) - 1, z + shift(random)},
                             {x + shift(random), y + shift(random) + 1, z + shift(random)}};
  if (facing == Facing::down) std::swap(points[0], points[1]);
  return ConvexPolygon::from_points(points);
}

/// Exact places on the line through two points where an event's trace ends or passes, with the event.
using CrossedAt = std::set<std::tuple<Rational, Rational, Rational, EventName>>;

CrossedAt crossings(const ReceiverMesh& mesh, const Point3& from, const Point3& to) {
  CrossedAt found;
  const ExactVector a = exact(from), b = exact(to);
  for (const MeshEdge& edge : mesh.edges()) {
    if (edge.left == MeshEdge::nowhere || edge.right == MeshEdge::nowhere) continue;
    for (const std::uint32_t v : {edge.source, edge.target}) {
      const ExactVector p = mesh.data().plane.spatial(mesh.data().point(v));
      if (!is_zero(cross(p - a, b - a))) continue;
      for (const std::uint32_t n : edge.names) found.insert({p.x, p.y, p.z, mesh.names()[n]});
    }
  }
  return found;
}

TEST(ReceiverMeshProperty, TracesMeetExactlyOnTheSharedEdgeOfTwoFacets) {
  std::mt19937 random(11);
  std::size_t met = 0;
  for (int i = 0; i < 6; ++i) {
    const Light light = lamp(triangle(random, 0, 0, 5, Facing::down));
    const Blockers blockers{triangle(random, 0, 0, 2.5, Facing::up), turned_box(0.25, 1.5, 1, 1.75, 0.5, 0.375)};
    // A floor that rises, or falls, behind the line x = 0.
    for (const double rise : {1.0, -0.75}) {
      const std::vector<ConvexPolygon> facets{
          ConvexPolygon::from_points({{-6, -6, 0}, {0, -6, 0}, {0, 6, 0}, {-6, 6, 0}}),
          ConvexPolygon::from_points({{0, -6, 0}, {6, -6, rise}, {6, 6, rise}, {0, 6, 0}})};
      const std::vector<ReceiverMesh> meshes = receiver_division(light, blockers, facets);
      const CrossedAt left = crossings(meshes[0], {0, -6, 0}, {0, 6, 0});
      EXPECT_EQ(left, crossings(meshes[1], {0, -6, 0}, {0, 6, 0}));
      met += left.size();
    }
  }
  EXPECT_GT(met, 100U);
}

TEST(ReceiverCounts, OfSeparateTrianglesAreThoseOfOnePairEach) {
  // A triangular lamp and k x k triangles so far apart that no point sees two of them before the lamp: 3 * 3 events of
  // light vertices and 3 * 3 of light edges each, beside the 4 sides of the floor. Each shadow's traces hang together,
  // so by Euler's formula there are E - V + 1 faces for the border and one more for each shadow.
  for (const int k : {1, 2, 3}) {
    std::mt19937 random(3);
    const Light light = lamp(triangle(random, 4.0 * (k - 1), 4.0 * (k - 1), 40, Facing::down));
    Blockers blockers;
    for (int i = 0; i < k * k; ++i) blockers.push_back(triangle(random, 8.0 * (i % k), 8.0 * (i / k), 2, Facing::up));
    const ConvexPolygon floor = rectangle(-8, -8, 8.0 * k, 8.0 * k, 0, Facing::up);
    const ReceiverMesh mesh = receiver_division(light, blockers, std::vector{floor}).front();
    const auto shadows = static_cast<std::size_t>(k * k);
    EXPECT_EQ(mesh.names().size(), 18 * shadows + 4);
    EXPECT_EQ(mesh.faces().size(), mesh.edges().size() - mesh.vertex_count() + 1 + shadows);
    std::cout << k << " x " << k << " triangles: " << mesh.names().size() << " events, " << mesh.faces().size()
              << " faces, " << mesh.regions().size() << " regions\n";
    EXPECT_EQ(mesh.regions().size(), 1 + 2 * shadows);
  }
}

TEST(ReceiverCounts, OfBoxesStandingApartAreThoseOfOneBoxEach) {
  // From every corner of the triangular lamp one sees of each box the top and the two sides towards it. Of the outline
  // two edges are upright and two belong to the top: 3 * 4 events of light vertices. Its top corners are three: 3 * 3
  // events of light edges. Its other two edges lie on the floor, which 5 facets touch: the lowest and the four sides.
  // Shadows are short and apart, so no event has elements of two boxes. Faces and regions as of triangles.
  for (const int k : {1, 2, 3}) {
    std::mt19937 random(5);
    const Light light = lamp(triangle(random, -20, -16, 40, Facing::down));
    Blockers blockers;
    for (int i = 0; i < k * k; ++i) {
      const double x = 8.0 * (i % k), y = 8.0 * (i / k);
      blockers.push_back(box({x, y, 0}, {x + 2, y + 1.5, 1 + 0.25 * (i % 2)}));
    }
    const ConvexPolygon floor = rectangle(-8, -8, 8.0 * k, 8.0 * k, 0, Facing::up);
    const ReceiverMesh mesh = receiver_division(light, blockers, std::vector{floor}).front();
    const auto shadows = static_cast<std::size_t>(k * k);
    EXPECT_EQ(mesh.names().size(), (3 * 4 + 3 * 3 + 5) * shadows + 4);
    EXPECT_EQ(mesh.faces().size(), mesh.edges().size() - mesh.vertex_count() + 1 + shadows);
    std::cout << k << " x " << k << " boxes: " << mesh.names().size() << " events, " << mesh.faces().size()
              << " faces, " << mesh.regions().size() << " regions\n";
    EXPECT_EQ(mesh.regions().size(), 1 + 2 * shadows);
  }
}

}  // namespace
}  // namespace gnomon
