#include "gnomon/receiver_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;

ConvexPolygon floor_of(double half, double z = 0) {
  return rectangle(-half, -half, half, half, z, Facing::up);
}

ReceiverMesh mesh_of(const Light& light, const Blockers& blockers, const ConvexPolygon& receiver) {
  return receiver_division(light, blockers, std::vector{receiver}).front();
}

std::string exact_area(const ReceiverMesh& mesh, ReceiverRegion region) {
  return mesh.areas()[static_cast<std::size_t>(region)].exact.value_or("irrational");
}

/// The three things every mesh must fulfil; returns how many points were compared.
std::size_t expect_true_mesh(const Light& light, const Blockers& blockers, const ConvexPolygon& receiver,
                             std::size_t points = 200) {
  const ReceiverMesh mesh = mesh_of(light, blockers, receiver);
  EXPECT_TRUE(mesh.areas_add_up());
  const ProbeResult result = compare_with_definition(mesh, receiver, light, blockers, points, 7);
  EXPECT_EQ(result.different, 0U);
  return result.compared - result.unresolved;
}

const Light square_lamp = lamp(rectangle(-1, -1, 1, 1, 2, Facing::down));

TEST(ReceiverMesh, SquareUnderSquareGivesTheAreasOfSimilarTriangles) {
  const ReceiverMesh mesh = mesh_of(square_lamp, {rectangle(-1, -1, 1, 1, 1, Facing::up)}, floor_of(5));
  EXPECT_EQ(exact_area(mesh, ReceiverRegion::umbra), "4");
  EXPECT_EQ(exact_area(mesh, ReceiverRegion::penumbra), "32");
  EXPECT_EQ(exact_area(mesh, ReceiverRegion::lit), "64");
  EXPECT_EQ(mesh.area().exact, "100");
  EXPECT_EQ(mesh.regions().size(), 3U);
}

TEST(ReceiverMesh, TiltedReceiverHasAnIrrationalAreaThatIsRoundedWell) {
  const auto tilted = ConvexPolygon::from_points({{-1, -1, -1}, {1, -1, -1}, {1, 1, 1}, {-1, 1, 1}});
  const ReceiverMesh mesh = mesh_of(square_lamp, {}, tilted);
  EXPECT_FALSE(mesh.area().exact);
  EXPECT_DOUBLE_EQ(mesh.area().nearest, 4 * std::sqrt(2.0));
  EXPECT_EQ(mesh.areas()[0].nearest, mesh.area().nearest);
}

TEST(ReceiverMesh, RegionWithAHoleHasTwoCycles) {
  const ReceiverMesh mesh = mesh_of(square_lamp, {rectangle(-1, -1, 1, 1, 1, Facing::up)}, floor_of(5));
  for (const RegionPolygon& region : mesh.regions()) {
    EXPECT_EQ(region.cycles.size(), region.region == ReceiverRegion::umbra ? 1U : 2U);
  }
}

TEST(ReceiverMesh, WithoutBlockersIsOneFace) {
  const ReceiverMesh mesh = mesh_of(square_lamp, {}, floor_of(5));
  ASSERT_EQ(mesh.faces().size(), 1U);
  EXPECT_EQ(mesh.faces()[0].region, ReceiverRegion::lit);
}

TEST(ReceiverMesh, ReceiverThroughTheLightsPlaneIsUnlitBehindIt) {
  const auto wall = ConvexPolygon::from_points({{2, -1, 4}, {2, 1, 4}, {2, 1, 0}, {2, -1, 0}});
  const ReceiverMesh mesh = mesh_of(square_lamp, {}, wall);
  EXPECT_EQ(exact_area(mesh, ReceiverRegion::unlit), "4");
  EXPECT_EQ(exact_area(mesh, ReceiverRegion::lit), "4");
}

TEST(ReceiverMesh, BackOfABlockerThatIsAReceiverIsUnlit) {
  const ConvexPolygon top = rectangle(-1, -1, 1, 1, 1, Facing::up), bottom = rectangle(-1, -1, 1, 1, 1, Facing::down);
  EXPECT_EQ(exact_area(mesh_of(square_lamp, {top}, top), ReceiverRegion::lit), "4");
  EXPECT_EQ(exact_area(mesh_of(square_lamp, {top}, bottom), ReceiverRegion::unlit), "4");
}

TEST(ReceiverMesh, EveryFacetOfABoxIsAReceiverWithASide) {
  const ConvexBlocker block = box({-2, -1, 0}, {2, 1, 1});
  const auto side = ConvexPolygon::from_points({{2, -1, 0}, {2, 1, 0}, {2, 1, 1}, {2, -1, 1}});
  // The plane x = 2 leaves all of the light behind it.
  EXPECT_EQ(exact_area(mesh_of(square_lamp, {block}, side), ReceiverRegion::unlit), "2");
  const auto top = rectangle(-2, -1, 2, 1, 1, Facing::up);
  EXPECT_EQ(exact_area(mesh_of(square_lamp, {block}, top), ReceiverRegion::lit), "8");
}

TEST(ReceiverMesh, IsUmbraInsideAClosedMeshThatTheLightTouches) {
  // A box as a shell of six boards, a lamp on the inner side of its lid, a floor that passes through it.
  const ConvexBlocker hall = box({0, 0, 0}, {4, 4, 4});
  ClosedSurface surface;
  Blockers shell;
  const auto& solid = std::get<ConvexSolid>(hall);
  surface.vertices.assign(solid.points().begin(), solid.points().end());
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    std::vector<Point3> corners;
    for (const std::uint32_t v : facet.loop) corners.push_back(solid.points()[v]);
    shell.push_back(ConvexPolygon::from_points(corners));
    for (std::size_t k = 2; k < facet.loop.size(); ++k) {
      surface.triangles.push_back({facet.loop[0], facet.loop[k - 1], facet.loop[k]});
    }
  }
  const Light flush = lamp(rectangle(1, 1, 3, 3, 4, Facing::down));
  const std::vector floor{rectangle(-2, -2, 6, 6, 1, Facing::up)};
  const auto umbra = [&](std::span<const ClosedSurface> enclosures) {
    const ReceiverDivision division(flush, shell, floor, 1, enclosures);
    const ReceiverMesh mesh = division.mesh(0);
    for (const double f : division.visible_fractions(0, mesh)) EXPECT_TRUE(enclosures.empty() || f == 0);
    return mesh.areas()[static_cast<std::size_t>(ReceiverRegion::umbra)].exact;
  };
  EXPECT_EQ(umbra({}), "48");
  EXPECT_EQ(umbra({&surface, 1}), "64");
  const Obstacles obstacles{shell, {surface}};
  EXPECT_EQ(exact_visibility(flush, obstacles, {2, 2, 1}).region, Region::umbra);
}

TEST(ReceiverMeshDegenerate, BlockersOnTheFloor) {
  EXPECT_GT(expect_true_mesh(square_lamp, {box({-1, -1, 0}, {1, 1, 1})}, floor_of(4)), 150U);
  EXPECT_GT(expect_true_mesh(square_lamp, {box({-2, -1, -1}, {1, 1, 1})}, floor_of(4)), 150U);
  const auto upright = ConvexPolygon::from_points({{-1, 0, 0}, {1, 0, 0}, {1, 0, 1}, {-1, 0, 1}});
  EXPECT_GT(expect_true_mesh(square_lamp, {upright}, floor_of(4)), 150U);
  const auto through = ConvexPolygon::from_points({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}});
  EXPECT_GT(expect_true_mesh(square_lamp, {through}, floor_of(4)), 150U);
}

std::size_t contacts_of_order_zero(const ReceiverMesh& mesh) {
  return std::size_t(std::count_if(mesh.edges().begin(), mesh.edges().end(), [&](const MeshEdge& edge) {
    return std::any_of(edge.names.begin(), edge.names.end(), [&](std::uint32_t n) {
      return mesh.names()[n].kind == EventKind::contact && mesh.names()[n].order == 0;
    });
  }));
}

TEST(ReceiverMeshDegenerate, ContactIsADiscontinuityOfOrderZero) {
  EXPECT_GE(contacts_of_order_zero(mesh_of(square_lamp, {box({-1, -1, 0}, {1, 1, 1})}, floor_of(4))), 4U);
  const ConvexBlocker on_an_edge =
      ConvexSolid::hull_of({{-1, 0, 0}, {1, 0, 0}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}});
  EXPECT_GE(contacts_of_order_zero(mesh_of(square_lamp, {on_an_edge}, floor_of(4))), 1U);
}

TEST(ReceiverMeshDegenerate, JoinedStripsLeaveNothingUnresolved) {
  const Blockers strips{rectangle(-1, -1, 0, 1, 1, Facing::up), rectangle(0, -1, 1, 1, 1, Facing::up)};
  const ReceiverMesh flat = mesh_of(square_lamp, strips, floor_of(5));
  EXPECT_EQ(exact_area(flat, ReceiverRegion::umbra), "4");
  EXPECT_EQ(exact_area(flat, ReceiverRegion::unresolved_eee), "0");
  const Blockers roof{ConvexPolygon::from_points({{-2, -1, 0.5}, {0, -1, 1}, {0, 1, 1}, {-2, 1, 0.5}}),
                      ConvexPolygon::from_points({{0, -1, 1}, {2, -1, 0.5}, {2, 1, 0.5}, {0, 1, 1}})};
  const ReceiverMesh folded = mesh_of(square_lamp, roof, floor_of(5));
  EXPECT_NE(exact_area(folded, ReceiverRegion::umbra), "0");
  EXPECT_EQ(exact_area(folded, ReceiverRegion::unresolved_eee), "0");
  EXPECT_GT(expect_true_mesh(square_lamp, roof, floor_of(5)), 150U);
}

TEST(ReceiverMeshDegenerate, LightAndBlockerShareAnEdge) {
  const Light light = lamp(rectangle(0, 0, 1, 1, 0, Facing::up));
  const auto wall = ConvexPolygon::from_points({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
  const auto receiver = rectangle(-3, -3, 3, 3, 0.0625, Facing::down);
  EXPECT_NE(exact_area(mesh_of(light, {wall}, receiver), ReceiverRegion::umbra), "0");
  EXPECT_GT(expect_true_mesh(light, {wall}, receiver), 150U);
}

TEST(ReceiverMeshDegenerate, FourBoxesTouching) {
  Blockers boxes;
  for (const double x : {-1.0, 0.0}) {
    for (const double y : {-1.0, 0.0}) boxes.push_back(box({x, y, 0}, {x + 1, y + 1, 1}));
  }
  EXPECT_GT(expect_true_mesh(square_lamp, boxes, floor_of(4)), 150U);
}

/// Draws scenes on small integers, so that ties are common.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  double quarter(int low, int high) { return integer(4 * low, 4 * high) / 4.0; }

  ConvexBlocker blocker() {
    const double x = quarter(-2, 2), y = quarter(-2, 2), z = integer(0, 2) / 2.0;
    switch (integer(0, 3)) {
      case 0:
        return rectangle(x, y, x + integer(1, 2), y + integer(1, 2), z + 0.5, Facing::up);
      case 1:
        return box({x, y, z}, {x + 1, y + integer(1, 2), z + 0.5});
      case 2:
        return turned_box(x, y, z, z + 1, integer(1, 4) / 4.0, integer(0, 4) / 4.0);
      default:
        return ConvexPolygon::from_points(
            {{x, y, z}, {x + 1, y + integer(-1, 1), z}, {x + integer(0, 1), y + integer(0, 1) / 2.0, z + 1}});
    }
  }

  Light area_light() {
    const double x = quarter(-1, 1), y = quarter(-1, 1);
    if (integer(0, 1) == 0) return lamp(rectangle(x, y, x + integer(1, 2), y + 1, 3, Facing::down));
    return lamp(ConvexPolygon::from_points({{x, y, 3}, {x, y + 1, 3.5}, {x + 1, y, 3}}));
  }

  Light any_light() {
    switch (integer(0, 3)) {
      case 0:
        return PointLight{{quarter(-2, 2), quarter(-2, 2), 3}};
      case 1:
        return DirectionalLight{{quarter(-2, 2), quarter(-2, 2), -2}};
      case 2:
        return LinearLight{{quarter(-2, 0), quarter(-2, 2), 3}, {quarter(1, 2), quarter(-2, 2), 3}};
      default:
        return area_light();
    }
  }

 private:
  std::mt19937 random_;
};

TEST(ReceiverMeshProperty, FacesHaveTheRegionOfTheDefinition) {
  std::size_t compared = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Draw draw(seed);
    const Light light = draw.any_light();
    Blockers blockers;
    for (int n = draw.integer(1, 3); n > 0; --n) blockers.push_back(draw.blocker());
    SCOPED_TRACE(seed);
    compared += expect_true_mesh(light, blockers, floor_of(4), 260);
  }
  EXPECT_GT(compared, 10000U);
}

/// A tilted quadrangle of which the last corner is rounded, and a triangle in its plane that holds it.
std::array<ConvexPolygon, 2> rounded_in_flat(Draw& draw) {
  const Point3 p{-3, -3, draw.quarter(-1, 1)};
  const Point3 q{3, draw.quarter(-3, -2), draw.quarter(-1, 1)}, r{draw.quarter(-3, -2), 3, draw.quarter(-1, 1)};
  const double s = draw.integer(30, 100) / 99.0, t = draw.integer(30, 100) / 97.0;
  const auto at = [&](double u, double v) {
    return Point3{p.x + u * (q.x - p.x) + v * (r.x - p.x), p.y + u * (q.y - p.y) + v * (r.y - p.y),
                  p.z + u * (q.z - p.z) + v * (r.z - p.z)};
  };
  return {ConvexPolygon::from_points({p, q, at(s + 0.4, t + 0.4), r}),
          ConvexPolygon::from_points({p, at(4, 0), at(0, 4)})};
}

TEST(ReceiverMeshProperty, ARoundedReceiverIsDividedAsPartOfItsPlane) {
  std::size_t compared = 0, rounded = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Draw draw(seed);
    const Light light = draw.any_light();
    Blockers blockers;
    for (int n = draw.integer(1, 3); n > 0; --n) blockers.push_back(draw.blocker());
    const auto [receiver, plane] = rounded_in_flat(draw);
    rounded += receiver.is_flat() ? 0 : 1;
    const ReceiverMesh mesh = mesh_of(light, blockers, receiver), whole = mesh_of(light, blockers, plane);
    EXPECT_TRUE(mesh.areas_add_up()) << seed;
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> number(-3000, 4000);
    for (int n = 0; n < 100; ++n) {
      const ExactVector p = whole.data().plane.spatial({Rational(number(random), 999), Rational(number(random), 997)});
      const auto face = face_at(mesh, p), of_whole = face_at(whole, p);
      if (!face || !of_whole) continue;
      ++compared;
      EXPECT_EQ(mesh.faces()[*face].region, whole.faces()[*of_whole].region) << seed;
    }
  }
  EXPECT_GT(rounded, 40U);
  EXPECT_GT(compared, 2000U);
}

TEST(ReceiverMeshProperty, OneConvexBlockerLeavesNothingUnresolved) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Draw draw(seed);
    const Light light = draw.any_light();
    const ReceiverMesh mesh = mesh_of(light, {draw.blocker()}, floor_of(4));
    EXPECT_EQ(exact_area(mesh, ReceiverRegion::unresolved_eee), "0") << seed;
  }
}

}  // namespace
}  // namespace gnomon
