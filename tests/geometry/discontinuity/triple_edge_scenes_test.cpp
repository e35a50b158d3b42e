#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;

ConvexPolygon flat(const std::vector<Point3>& points) {
  return ConvexPolygon::from_points(points);
}

/// A scene whose umbra is known.
struct KnownScene {
  Light light;
  Blockers blockers;
  ConvexPolygon receiver;

  ReceiverMesh mesh() const { return receiver_division(light, blockers, std::vector{receiver}).front(); }
};

double area_of(const ReceiverMesh& mesh, ReceiverRegion region) {
  return mesh.areas()[static_cast<std::size_t>(region)].nearest;
}

std::vector<double> areas_of_umbrae(const ReceiverMesh& mesh) {
  std::vector<double> areas;
  const double stretch = std::sqrt(mesh.data().plane.squared_stretch().convert_to<double>());
  for (const RegionPolygon& region : mesh.regions()) {
    if (region.region != ReceiverRegion::umbra) continue;
    const RationalInterval doubled = doubled_flat_area(mesh.data(), region.cycles, 80).sum();
    areas.push_back(stretch * doubled.high.convert_to<double>() / 2);
  }
  std::sort(areas.rbegin(), areas.rend());
  return areas;
}

void expect_all_resolved(const ReceiverMesh& mesh) {
  EXPECT_EQ(area_of(mesh, ReceiverRegion::unresolved_eee), 0);
  EXPECT_TRUE(mesh.areas_add_up());
}

const Blockers walls_of_hyperbola = {flat({{1, -4, -4}, {1, 4, 4}, {1, -4, 8}}),
                                     flat({{0, -4, 0}, {0, -4, -4}, {0, 4, -4}, {0, 4, 0}})};

const ConvexPolygon ground_of_hyperbola = flat({{-2, 0.5, -1}, {-1, 0.5, -1}, {-1, 1, -1}, {-2, 1, -1}});

TEST(TripleEdges, OfATubeAndTwoWallsBoundAnUmbraByAHyperbola) {
  const KnownScene scene{LinearLight{{2, 0.5, 1}, {2, 1, 2}}, walls_of_hyperbola, ground_of_hyperbola};
  const ReceiverMesh mesh = scene.mesh();
  expect_all_resolved(mesh);
  // x y >= -1
  EXPECT_NEAR(area_of(mesh, ReceiverRegion::umbra), std::numbers::ln2 - 0.5, 1e-15);
  ASSERT_EQ(mesh.arcs().size(), 1U);
  const MeshArc arc = mesh.arcs().front();
  EXPECT_DOUBLE_EQ(arc.weight * arc.weight, 9.0 / 8);
  const auto& [p, q, r] = arc.points;
  EXPECT_DOUBLE_EQ(std::fabs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2, 1.0 / 12);
  const auto named = std::ranges::find(mesh.names(), EventKind::triple_edge, &EventName::kind);
  ASSERT_NE(named, mesh.names().end());
  EXPECT_EQ(named->order, 1);
  EXPECT_EQ(named->extremal, Extremal::umbra);
  EXPECT_EQ(named->vertex.of, EventOf::light);
}

TEST(TripleEdges, OfALampAndTwoWallsBoundTheSameUmbra) {
  Blockers walls = {flat({{1, -8, -8}, {1, 8, 8}, {1, -8, 40}}),
                    flat({{0, -16, 0}, {0, -16, -16}, {0, 16, -16}, {0, 16, 0}})};
  const KnownScene scene{AreaLight{flat({{1.5, 0, 0.5}, {1.5, 0.5, 1.5}, {2, 1, 2}, {2, 0.5, 1}}), true}, walls,
                         ground_of_hyperbola};
  const ReceiverMesh mesh = scene.mesh();
  expect_all_resolved(mesh);
  EXPECT_NEAR(area_of(mesh, ReceiverRegion::umbra), std::numbers::ln2 - 0.5, 1e-15);
  // Beyond the arc f grows with the square of the distance: 0.384 h^2.
  const double h = 0x1p-20;
  const double f = exact_visibility(scene.light, {walls, {}}, {-1.5, 2.0 / 3 + h, -1}).fraction;
  EXPECT_NEAR(f / (h * h), 0.384, 0.001);
}

TEST(TripleEdges, OnAHyperboloidOfRevolutionBoundADisc) {
  const Blockers walls = {flat({{12.5, -25, 12.5}, {87.5, -25, 87.5}, {127.5, -65, 87.5}, {52.5, -65, 12.5}}),
                          flat({{20, -16.25, 6.25}, {45, 2.5, 37.5}, {5, -37.5, 37.5}, {-20, -56.25, 6.25}})};
  const KnownScene scene{LinearLight{{17, -31, 25}, {137, -66, 150}}, walls,
                         flat({{15, 0, 0}, {25, 0, 0}, {25, 20, 0}, {15, 20, 0}})};
  const ReceiverMesh mesh = scene.mesh();
  expect_all_resolved(mesh);
  EXPECT_NEAR(area_of(mesh, ReceiverRegion::umbra), 139.779755625504, 1e-12 * 139);
}

TEST(TripleEdges, OfATubeAndTwoTrianglesBoundFourUmbrae) {
  const KnownScene scene{LinearLight{{-5, 0, 10}, {5, 0, 13.45}},
                         {flat({{-5.92, 1.16, 6.09}, {1.18, -0.01, 6.07}, {5.20, 1.22, 4.54}}),
                          flat({{-3.35, 2.25, 5.77}, {-0.50, 2.82, 2.85}, {-5.88, -0.53, 3.40}})},
                         flat({{-30, -30, 0}, {30, -30, 0}, {30, 30, 0}, {-30, 30, 0}})};
  const ReceiverMesh mesh = scene.mesh();
  expect_all_resolved(mesh);
  const std::vector<double> areas = areas_of_umbrae(mesh);
  const std::vector<double> known = {1.98129485585712, 0.656917284686656, 0.256598508521027, 0.211384441954558};
  ASSERT_EQ(areas.size(), known.size());
  for (std::size_t k = 0; k < known.size(); ++k) EXPECT_NEAR(areas[k], known[k], 1e-12 * known[k]) << k;
}

TEST(TripleEdges, BoundTheSameUmbraeOfScaledScenes) {
  const auto umbra = [](int exponent) {
    const auto p = [&](double x, double y, double z) {
      return Point3{std::ldexp(x, exponent), std::ldexp(y, exponent), std::ldexp(z, exponent)};
    };
    const KnownScene scene{LinearLight{p(-5, 0, 10), p(5, 0, 13.45)},
                           {flat({p(-5.92, 1.16, 6.09), p(1.18, -0.01, 6.07), p(5.20, 1.22, 4.54)}),
                            flat({p(-3.35, 2.25, 5.77), p(-0.50, 2.82, 2.85), p(-5.88, -0.53, 3.40)})},
                           flat({p(-30, -30, 0), p(30, -30, 0), p(30, 30, 0), p(-30, 30, 0)})};
    const double area = scene.mesh().areas()[static_cast<std::size_t>(ReceiverRegion::umbra)].nearest;
    return std::ldexp(area, -2 * exponent);
  };
  // Polynomials of lines leave the range of doubles at the greatest: then intervals tell nothing.
  for (const int exponent : {-190, -100, 100, 190}) EXPECT_EQ(umbra(exponent), umbra(0)) << exponent;
}

TEST(TripleEdges, OfEdgesThatCrossBoundAnUmbraByStraightLines) {
  const KnownScene scene{LinearLight{{-1, 0, 4}, {1, 0, 4}},
                         {flat({{0, -2, 1}, {0, 2, 3}, {-6, 0, 2}}), flat({{0, -2, 3}, {0, 2, 1}, {6, 0, 2}})},
                         flat({{-0.25, -0.25, 0}, {0.25, -0.25, 0}, {0.25, 0.25, 0}, {-0.25, 0.25, 0}})};
  const ReceiverMesh mesh = scene.mesh();
  expect_all_resolved(mesh);
  EXPECT_EQ(mesh.areas()[static_cast<std::size_t>(ReceiverRegion::umbra)].exact, "1/8");
}

/// No end of either edge is seen: from x > 0 light passes between the two, from x < 0 each hides what the other leaves.
TEST(TripleEdges, OfTwoLongEdgesInOnePlaneBoundAnUmbraBelowATube) {
  const KnownScene scene{LinearLight{{-1, 0, 4}, {1, 0, 4}},
                         {flat({{0, -40, 1}, {0, 40, 1}, {-60, 0, 1}}), flat({{0, -40, 2}, {0, 40, 2.5}, {60, 0, 2}})},
                         flat({{-0.25, -0.25, 0}, {0.25, -0.25, 0}, {0.25, 0.25, 0}, {-0.25, 0.25, 0}})};
  const ReceiverMesh mesh = scene.mesh();
  expect_all_resolved(mesh);
  EXPECT_EQ(mesh.areas()[static_cast<std::size_t>(ReceiverRegion::umbra)].exact, "1/8");
}

}  // namespace
}  // namespace gnomon
