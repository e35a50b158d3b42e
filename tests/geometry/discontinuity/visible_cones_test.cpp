#include <gtest/gtest.h>

#include <iostream>
#include <numeric>
#include <string>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_visibility.h"
#include "geometry/discontinuity/visible_cones.h"
#include "tests/geometry/discontinuity/mesh_cases.h"
#include "tests/geometry/discontinuity/mesh_probe.h"
#include "tests/geometry/discontinuity/side_oracle.h"

namespace gnomon {
namespace {

using test_support::Dice;
using test_support::SideCase;

event::EventScene scene_of(const SideCase& drawn) {
  const CGAL::Protect_FPU_rounding<true> upward;
  return {drawn.light, drawn.blockers, drawn.receivers};
}

event::ReceiverPlane plane_of(const ConvexPolygon& receiver) {
  const auto points = receiver.points();
  return {points[0], points[1], points[2]};
}

/// A point of a level receiver, often in line with points of the scene.
ExactVector drawn_point(Dice& dice, double height) {
  const int grain = dice.draw(1, 3);
  return {Rational(dice.draw(-4 * grain, 4 * grain), grain), Rational(dice.draw(-4 * grain, 4 * grain), grain),
          Rational(height)};
}

/// The blockers of which some point lies strictly before the plane.
std::vector<event::ShapeId> shapes_before(const event::EventScene& scene, const event::ReceiverPlane& plane) {
  std::vector<event::ShapeId> found;
  for (event::ShapeId s = 0; s < scene.shapes.size(); ++s) {
    const auto& corners = scene.shapes[s].corners;
    if (std::any_of(corners.begin(), corners.end(),
                    [&](event::PointId q) { return plane.plane().height(exact(scene.points[q].input)) > 0; })) {
      found.push_back(s);
    }
  }
  return found;
}

Rational doubled_area_of(const VisiblePart& part) {
  ExactVector sum;
  for (const VisibleFacet& facet : part.facets) {
    for (const ExactPolygon& piece : facet.visible) sum = sum + doubled_area(piece);
  }
  return dot(sum, sum);
}

struct ConeTally {
  unsigned looked = 0, left = 0, penumbra = 0, umbra = 0, shown = 0;
};

/// Compares regions and areas of what is seen from a point with rational clipping.
void compare_at(const ExactVector& p, const SideCase& drawn, std::uint32_t r, ConeTally& tally) {
  const event::EventScene scene = scene_of(drawn);
  const event::ReceiverPlane plane = plane_of(drawn.receivers[r]);
  event::VisibleCones cones(scene, plane);
  ++(cones.view(p, shapes_before(scene, plane)) ? tally.looked : tally.left);
  if (!cones.view(p, shapes_before(scene, plane))) return;
  event::ReceiverVisibility visibility(scene, drawn.light, drawn.blockers, r, plane);
  const VisiblePart exactly = visibility.visible_from(p);
  ASSERT_EQ(static_cast<int>(cones.region()), static_cast<int>(exactly.region)) << test_support::scene_text(drawn);
  tally.penumbra += exactly.region == Region::penumbra;
  tally.umbra += exactly.region == Region::umbra;
  EXPECT_EQ(doubled_area_of(cones.part(std::get<AreaLight>(drawn.light))), doubled_area_of(exactly));
  if (!cones.shows_vertex()) return;
  ++tally.shown;
  EXPECT_NE(static_cast<int>(exactly.region), static_cast<int>(Region::umbra));
}

TEST(VisibleConesAgreement, LeaveWhatRationalClippingLeaves) {
  constexpr unsigned count = GNOMON_LONG ? 5000 : 500;
  ConeTally tally;
  for (unsigned seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const SideCase drawn = test_support::mesh_under_lamp(dice);
    for (std::uint32_t r = 0; r < 2; ++r) compare_at(drawn_point(dice, r), drawn, r, tally);
  }
  std::cout << count << " cases from seed 1: " << tally.looked << " points looked from, " << tally.left
            << " left to rationals; penumbra " << tally.penumbra << ", umbra " << tally.umbra << ", with a vertex "
            << tally.shown << "\n";
  EXPECT_GT(tally.looked, 9 * tally.left);
  EXPECT_GT(10 * tally.penumbra, tally.looked);
  EXPECT_GT(40 * tally.umbra, tally.looked);
}

TEST(VisibleCones, LeaveBlockersThroughTheLightToOthers) {
  SideCase drawn{lamp(rectangle(-1, -1, 1, 1, 3, Facing::down)), {box({-2, 0, 2}, {0, 2, 4})}, {}};
  drawn.receivers.push_back(rectangle(-4, -4, 4, 4, 0, Facing::up));
  const event::EventScene scene = scene_of(drawn);
  const event::ReceiverPlane plane = plane_of(drawn.receivers[0]);
  event::VisibleCones cones(scene, plane);
  EXPECT_FALSE(cones.view(exact(Point3{0, 0, 0}), shapes_before(scene, plane)));
  EXPECT_TRUE(cones.view(exact(Point3{0, 0, 0}), {}));
  EXPECT_EQ(static_cast<int>(cones.region()), static_cast<int>(Region::lit));
}

}  // namespace
}  // namespace gnomon
