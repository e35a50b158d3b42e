#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "tests/geometry/discontinuity/mesh_cases.h"
#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;

const ConvexPolygon ground = rectangle(-0.25, -0.25, 0.25, 0.25, 0, Facing::up);
const Light long_lamp = lamp(rectangle(-1, -4, 1, 4, 3, Facing::down));

/// Boards on both sides of x = 0, the one on the right above: points to the right see through, those to the left do
/// not.
Blockers boards(double half_length) {
  return {rectangle(0, -half_length, 8, half_length, 2, Facing::up),
          rectangle(-8, -half_length, 0, half_length, 1, Facing::up)};
}

/// Adds boards that leave only |y| < 1/8 open at a height.
Blockers covered(Blockers blockers, double z) {
  blockers.push_back(rectangle(-9, 0.125, 9, 30, z, Facing::up));
  blockers.push_back(rectangle(-9, -30, 9, -0.125, z, Facing::up));
  return blockers;
}

ReceiverMesh mesh_of(const Light& light, const Blockers& blockers) {
  return receiver_division(light, blockers, std::vector{ground}).front();
}

/// The length of the line x = 0 that bears a name which `is_meant` holds for.
template <class Predicate>
double length_on_axis(const ReceiverMesh& mesh, const Predicate& is_meant) {
  const std::vector<Point3> points = mesh.vertices();
  double length = 0;
  for (const MeshEdge& edge : mesh.edges()) {
    const Point3 &p = points[edge.source], &q = points[edge.target];
    if (p.x != 0 || q.x != 0) continue;
    if (std::any_of(edge.names.begin(), edge.names.end(), [&](auto n) { return is_meant(mesh.names()[n]); })) {
      length += std::abs(q.y - p.y);
    }
  }
  return length;
}

/// Whether an event is that of the coplanar edges at x = 0 of blockers 0 and 1.
bool is_of_boards(const EventName& name) {
  const auto is_edge = [](const EventElement& e, std::uint32_t board) {
    return e.of == EventOf::blocker && number(e.body) == board && number(e.index) == (board == 0 ? 3U : 1U);
  };
  return name.kind == EventKind::coplanar_edges && name.order == 1 && is_edge(name.vertex, 0) && is_edge(name.edge, 1);
}

void expect_regions(const ReceiverMesh& mesh, ReceiverRegion left, ReceiverRegion right) {
  for (const double y : {-0.2, -0.01, 0.1}) {
    const auto at_left = face_at(mesh, exact(Point3{-0.0078125, y, 0}));
    const auto at_right = face_at(mesh, exact(Point3{0.0078125, y, 0}));
    ASSERT_TRUE(at_left && at_right);
    EXPECT_EQ(mesh.faces()[*at_left].region, left);
    EXPECT_EQ(mesh.faces()[*at_right].region, right);
  }
}

void expect_definition(const ReceiverMesh& mesh, const Light& light, const Blockers& blockers) {
  EXPECT_TRUE(mesh.areas_add_up());
  const ProbeResult result = compare_with_definition(mesh, ground, light, blockers, 200, 11);
  EXPECT_EQ(result.different, 0U);
  EXPECT_GT(result.compared - result.unresolved, 100U);
}

void expect_slit(const Blockers& blockers) {
  const ReceiverMesh mesh = mesh_of(long_lamp, blockers);
  EXPECT_EQ(length_on_axis(mesh, is_of_boards), 0.5);
  expect_regions(mesh, ReceiverRegion::umbra, ReceiverRegion::penumbra);
  expect_definition(mesh, long_lamp, blockers);
}

TEST(CoplanarPairs, OfBlockersAreTracedWhereTheyOverlapAllAcrossTheLight) {
  expect_slit(boards(40));
}

TEST(CoplanarPairs, OfMeetingLinesAreTracedAllAcrossTheLight) {
  Blockers blockers = boards(40);
  blockers[0] = ConvexPolygon::from_points({{0, -40, 1.75}, {8, -40, 1.75}, {8, 40, 2.25}, {0, 40, 2.25}});
  expect_slit(blockers);
}

TEST(CoplanarPairs, OfBlockersAreTracedWhereOthersHideAllFourEnds) {
  for (const double z : {0.5, 1.0, 1.5, 2.0, 2.5}) {
    SCOPED_TRACE(z);
    expect_slit(covered(boards(1.5), z));
  }
}

TEST(CoplanarPairs, OfBlockersAreTracedWhereTheirPlanePassesThroughVerticesOfTheLight) {
  const Light kite = lamp(ConvexPolygon::from_points({{0, -4, 3}, {-1, 0, 3}, {0, 4, 3}, {1, 0, 3}}));
  for (const double z : {0.5, 1.5, 2.5}) {
    SCOPED_TRACE(z);
    const Blockers blockers = covered(boards(1.5), z);
    const ReceiverMesh mesh = mesh_of(kite, blockers);
    EXPECT_EQ(length_on_axis(mesh, is_of_boards), 0.5);
    EXPECT_EQ(compare_with_definition(mesh, ground, kite, blockers, 200, 11).different, 0U);
  }
}

TEST(CoplanarPairs, OfBlockersEndWhereOthersLeaveNoGapBeforeThem) {
  Blockers blockers = covered(boards(1.5), 0.5);
  blockers.back() = box({-9, -30, 2.25}, {9, -0.125, 2.375});
  const ReceiverMesh mesh = mesh_of(long_lamp, blockers);
  // Beyond y = 23/120 the line from the board's edge at z = 1/2 to the box's edge at z = 19/8 passes.
  EXPECT_DOUBLE_EQ(length_on_axis(mesh, is_of_boards), 0.25 + 23.0 / 120);
  EXPECT_EQ(compare_with_definition(mesh, ground, long_lamp, blockers, 200, 11).different, 0U);
}

/// A board that ends at x = 0 where the light does, its ends hidden: penumbra meets umbra along all of x = 0.
template <class Predicate>
void expect_traced_with_light(const Light& light, const Predicate& is_meant) {
  for (const double z : {0.5, 1.0, 2.5}) {
    SCOPED_TRACE(z);
    const Blockers blockers = covered({rectangle(0, -1.5, 8, 1.5, 1, Facing::up)}, z);
    const ReceiverMesh mesh = mesh_of(light, blockers);
    EXPECT_EQ(length_on_axis(mesh, is_meant), 0.5);
    expect_regions(mesh, ReceiverRegion::penumbra, ReceiverRegion::umbra);
    expect_definition(mesh, light, blockers);
  }
}

TEST(CoplanarPairs, OfLightAndBlockerAreTracedWhereOthersHideAllFourEnds) {
  expect_traced_with_light(lamp(rectangle(0, -4, 2, 4, 3, Facing::down)), [](const EventName& name) {
    return name.kind == EventKind::coplanar_edges && name.order == 1 && name.vertex.of == EventOf::light &&
           name.edge == EventElement{EventOf::blocker, EventBody{0}, EventIndex{3}} && name.extremal == Extremal::umbra;
  });
}

TEST(CoplanarPairs, OfALinearLightAndABlockerHaveOrderZero) {
  expect_traced_with_light(LinearLight{{0, -4, 3}, {0, 4, 3}}, [](const EventName& name) {
    return name.kind == EventKind::coplanar_edges && name.order == 0 && name.vertex.of == EventOf::light &&
           name.edge == EventElement{EventOf::blocker, EventBody{0}, EventIndex{3}};
  });
}

TEST(CoplanarPairs, OfAFacetsPlaneAreTracedWhereOthersHideItsCorners) {
  const Blockers wall{ConvexPolygon::from_points({{0, -1.5, 1}, {0, 1.5, 1}, {0, 1.5, 2}, {0, -1.5, 2}})};
  for (const double z : {0.5, 2.5}) {
    const ReceiverMesh mesh = mesh_of(long_lamp, covered(wall, z));
    EXPECT_EQ(
        length_on_axis(mesh,
                       [](const EventName& name) { return name.kind == EventKind::coplanar_plane && name.order == 1; }),
        0.5);
  }
}

/// The region of a floor point under a window on the floor, x = 0, y from -1 to 1, z from 0 to 2, that shines along +x.
ReceiverRegion region_before_window(const Blockers& blockers, double x, double y) {
  const Light window = lamp(ConvexPolygon::from_points({{0, -1, 0}, {0, 1, 0}, {0, 1, 2}, {0, -1, 2}}));
  const ConvexPolygon floor = rectangle(1, -2, 4, 2, 0, Facing::up);
  const ReceiverMesh mesh = receiver_division(window, blockers, std::vector{floor}).front();
  EXPECT_EQ(compare_with_definition(mesh, floor, window, blockers, 200, 3).different, 0U);
  return mesh.faces()[face_at(mesh, exact(Point3{x, y, 0})).value()].region;
}

TEST(CoplanarPairs, OfAWingAndTheSideOfAWindowAreTracedFromTheCornerWhereTheyMeet) {
  // From the upper corner, or through it from above, or through the side, to the floor, and away from the window.
  const Blockers wings[] = {{ConvexPolygon::from_points({{0, 1, 2}, {1, 1, 0}, {1, 3, 0}})},
                            {ConvexPolygon::from_points({{-1, 1, 4}, {1, 1, 0}, {1, 3, 0}})},
                            {ConvexPolygon::from_points({{-1, 1, 2}, {1, 1, 0}, {1, 3, 0}})}};
  for (const Blockers& wing : wings) {
    EXPECT_EQ(region_before_window(wing, 2.3, 0.9), ReceiverRegion::lit);
    EXPECT_EQ(region_before_window(wing, 2.3, 1.1), ReceiverRegion::penumbra);
  }
}

TEST(CoplanarPairs, OfAFinsPlaneAndAWindowAreTracedFromWhereTheyMeet) {
  // From the window's edge, from its inside, through it, or through its edge to the floor: in front of some of it from
  // everywhere else.
  const Blockers fins[] = {{ConvexPolygon::from_points({{0, 0, 2}, {0.5, 0, 0}, {1, 0, 0}})},
                           {ConvexPolygon::from_points({{0, 0, 1}, {0.5, 0, 0}, {1, 0, 0}})},
                           {ConvexPolygon::from_points({{-1, 0, 2}, {0.5, 0, 0}, {1, 0, 0}})},
                           {ConvexPolygon::from_points({{-1, 0, 6}, {0.5, 0, 0}, {1, 0, 0}})}};
  for (const Blockers& fin : fins) {
    EXPECT_EQ(region_before_window(fin, 2.3, 0.3), ReceiverRegion::penumbra);
    EXPECT_EQ(region_before_window(fin, 2.3, -0.3), ReceiverRegion::penumbra);
  }
}

TEST(CoplanarPairs, OfEdgesThatMeetPartRegionsWhereAllElseIsSeenAlongTheFloor) {
  // A window on the floor. The left screen slopes towards it, the right one away from it; they share a corner, and from
  // there two walls go up that share their side. The light that comes through between the screens is seen from the
  // left only, and it ends at that corner and at the floor.
  const Light window = lamp(ConvexPolygon::from_points({{1, 0, 0}, {-1, 0, 0}, {-1, 0, 9}, {1, 0, 9}}));
  const Blockers screens{ConvexPolygon::from_points({{0, 2, 2}, {0, 1, 0}, {-9, 1, 0}, {-9, 2, 2}}),
                         ConvexPolygon::from_points({{0, 2, 2}, {0, 3, 0}, {9, 3, 0}, {9, 2, 2}}),
                         ConvexPolygon::from_points({{0, 2, 2}, {0, 2, 99}, {-9, 2, 99}, {-9, 2, 2}}),
                         ConvexPolygon::from_points({{0, 2, 2}, {9, 2, 2}, {9, 2, 99}, {0, 2, 99}})};
  const ConvexPolygon floor = rectangle(-0.25, 4, 0.25, 5, 0, Facing::up);
  const ReceiverMesh mesh = receiver_division(window, screens, std::vector{floor}).front();
  const auto region_at = [&](double x) {
    return mesh.faces()[face_at(mesh, exact(Point3{x, 4.625, 0})).value()].region;
  };
  EXPECT_EQ(region_at(-0.01), ReceiverRegion::penumbra);
  EXPECT_EQ(region_at(0.01), ReceiverRegion::umbra);
  EXPECT_EQ(compare_with_definition(mesh, floor, window, screens, 200, 3).different, 0U);
}

TEST(CoplanarPairs, ATubesMiddleIsAVertexWhereABlockerTouchesIt) {
  // A leaf hides the tube's right half, from the middle that it touches on; a board behind it hides x < 2 - p of the
  // rest from a floor point (p, 3).
  const Light tube = LinearLight{{-1, 0, 2}, {1, 0, 2}};
  const Blockers blockers{ConvexPolygon::from_points({{0, 0, 2}, {5, 1, 0}, {5, 1, 4}}),
                          ConvexPolygon::from_points({{-9, 1.5, 0}, {0.25, 1.5, 0}, {0.25, 1.5, 5}, {-9, 1.5, 5}})};
  const ConvexPolygon floor = rectangle(0, 2.5, 1, 3.5, 0, Facing::up);
  const ReceiverMesh mesh = receiver_division(tube, blockers, std::vector{floor}).front();
  const auto region_at = [&](double x) { return mesh.faces()[face_at(mesh, exact(Point3{x, 3, 0})).value()].region; };
  EXPECT_EQ(region_at(0.49), ReceiverRegion::umbra);
  EXPECT_EQ(region_at(0.51), ReceiverRegion::penumbra);
  EXPECT_EQ(compare_with_definition(mesh, floor, tube, blockers, 200, 3).different, 0U);
}

TEST(CoplanarPairs, AreNotTracedWhereNoLightComesThrough) {
  Blockers blockers = boards(1.5);
  blockers.push_back(rectangle(-9, -30, 9, 30, 0.5, Facing::up));
  const auto is_pair = [](const EventName& name) { return name.kind == EventKind::coplanar_edges; };
  EXPECT_EQ(length_on_axis(mesh_of(long_lamp, blockers), is_pair), 0);
}

/// The ends of a named edge of a flat blocker whose corners are all its points.
std::array<ExactVector, 2> ends_of(const Blockers& blockers, const EventElement& edge) {
  const auto points = std::get<ConvexPolygon>(blockers[number(edge.body)]).points();
  return {exact(points[number(edge.index)]), exact(points[(number(edge.index) + 1) % points.size()])};
}

/// True if a ray from p passes through the middles of both segments, all in one plane: such a ray runs between the ways
/// to two of the four ends.
bool sees_in_line(const ExactVector& p, const std::array<ExactVector, 2>& s, const std::array<ExactVector, 2>& t) {
  const std::array<ExactVector, 4> ways{s[0] - p, s[1] - p, t[0] - p, t[1] - p};
  const ExactVector normal = cross(ways[0], ways[1]);
  const auto is_between = [&](const ExactVector& way, std::size_t k) {
    const Rational turn = dot(cross(ways[k], ways[k + 1]), normal);
    return dot(cross(ways[k], way), normal) * turn > 0 && dot(cross(way, ways[k + 1]), normal) * turn > 0;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ExactVector way = ways[i] + ways[j];
      if (is_between(way, 0) && is_between(way, 2)) return true;
    }
  }
  return false;
}

TEST(CoplanarPairsProperty, AreSeenInLineWhereTheyAreTraced) {
  constexpr unsigned count = GNOMON_LONG ? 2000 : 200;
  std::size_t seen = 0;
  for (unsigned seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test_support::Dice dice(seed);
    const test_support::SideCase drawn = test_support::mesh_under_lamp(dice);
    const ReceiverMesh mesh = receiver_division(drawn.light, drawn.blockers, drawn.receivers).front();
    for (const MeshEdge& edge : mesh.edges()) {
      const auto& data = mesh.data();
      const ExactVector middle =
          Rational(1, 2) * (data.plane.spatial(data.point(edge.source)) + data.plane.spatial(data.point(edge.target)));
      for (const std::uint32_t n : edge.names) {
        const EventName& name = mesh.names()[n];
        if (name.kind != EventKind::coplanar_edges || name.vertex.of != EventOf::blocker) continue;
        const auto far = ends_of(drawn.blockers, name.vertex), near = ends_of(drawn.blockers, name.edge);
        EXPECT_TRUE(sees_in_line(middle, far, near)) << test_support::scene_text(drawn);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, count);
}

}  // namespace
}  // namespace gnomon
