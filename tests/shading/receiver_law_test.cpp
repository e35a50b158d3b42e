#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "apps/proof/laws/draw.h"
#include "gnomon/irradiance.h"
#include "tests/geometry/visibility/receiver_oracle.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::LightKind;
using laws::VisibilityCase;

constexpr int points_of_a_case = GNOMON_LONG ? 100 : 10;

bool gets_light(const Visibility& seen) {
  return seen.region == Region::lit || seen.region == Region::penumbra;
}

/// The normal of a facet in doubles; of others their own.
Point3 double_normal_of(const ReceiverPoint& receiver) {
  const auto* facet = std::get_if<FacetFront>(&receiver.front);
  if (!facet) return std::get<FacingNormal>(receiver.front).normal;
  const auto& [a, b, c] = facet->corners;
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Point3 v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  return n == Point3{} ? Point3{0, 0, 1} : n;
}

std::vector<Point3> vertices_of(const VisibilityCase& drawn) {
  std::vector<Point3> points = {drawn.point};
  for (const ConvexBlocker& blocker : drawn.blockers) {
    const auto more = std::visit([](const auto& shape) { return shape.points(); }, blocker);
    points.insert(points.end(), more.begin(), more.end());
  }
  if (const auto* area = std::get_if<AreaLight>(&drawn.light)) {
    points.insert(points.end(), area->polygon.points().begin(), area->polygon.points().end());
  }
  return points;
}

/// The case's own point, a vertex, or half way between two of these.
Point3 draw_law_point(const std::vector<Point3>& points) {
  const auto any = [&] { return points[std::size_t(laws::draw(0, int(points.size()) - 1))]; };
  const Point3 a = any(), b = any();
  switch (laws::draw(0, 2)) {
    case 0:
      return a;
    case 1:
      return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    default:
      return laws::draw_vector(6);
  }
}

void check_receiver_law(Domain domain) {
  VisibilityCase drawn = *laws::visibility_cases(domain, {{LightKind::point, LightKind::direction, LightKind::segment,
                                                           LightKind::polygon, LightKind::rounded_polygon},
                                                          {BlockerKind::polygon, BlockerKind::solid},
                                                          3});
  const std::vector<Point3> points = vertices_of(drawn);
  const PreparedObstacles obstacles({drawn.blockers, {}});
  LightIrradiance irradiance(drawn.light, 2, obstacles);
  LightVisibility visibility(drawn.light, obstacles);
  for (int k = 0; k < points_of_a_case; ++k) {
    if (k > 0) drawn.point = draw_law_point(points);
    const ReceiverPoint receiver = test_support::draw_receiver(drawn);
    const Visibility exact = exact_received(drawn.light, obstacles.obstacles(), receiver);
    const Irradiance e = irradiance.received(receiver, double_normal_of(receiver));
    RC_LOG() << laws::description(drawn) << name(exact.region) << ' ' << e.value << ' ' << e.error_bound;
    RC_ASSERT((e.value > 0) == gets_light(exact));
    RC_ASSERT(name(visibility.received(receiver).region) == name(exact.region));
    if (!gets_light(exact)) RC_ASSERT(e.error_bound == 0);
  }
}

RC_GTEST_PROP(ReceiverLaw, IrradianceIsPositiveExactlyWhereLitOrInPenumbra, ()) {
  check_receiver_law(Domain::random);
}

RC_GTEST_PROP(ReceiverLaw, IrradianceIsPositiveExactlyWhereLitOrInPenumbraNearDegeneracy, ()) {
  check_receiver_law(Domain::near_degenerate);
}

TEST(ReceiverLaw, WhatUnderflowsIsStillPositive) {
  LightIrradiance lamp_of_a_point(PointLight{{0, 0, 1e200}}, 1e-300, PreparedObstacles({}));
  const Irradiance e = lamp_of_a_point.at({0, 0, 0}, {0, 0, 1});
  EXPECT_GT(e.value, 0);
  EXPECT_LE(e.value, e.error_bound);
}

}  // namespace
}  // namespace gnomon
