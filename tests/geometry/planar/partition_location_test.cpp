#include "gnomon/flatland_partition.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "apps/proof/laws/flatland_cases.h"
#include "geometry/planar/partition_data.h"
#include "geometry/planar/viewpoint.h"
#include "geometry/planar/visibility_query.h"

namespace gnomon::planar {
namespace {

using laws::Domain;
using laws::FlatlandCase;
using laws::Layout;

/// The point, and the nearest doubles around it.
void add_around(std::vector<Point2>& points, const Point2& p) {
  constexpr double far = std::numeric_limits<double>::max();
  for (const double x : {p.x, std::nextafter(p.x, far), std::nextafter(p.x, -far)}) {
    for (const double y : {p.y, std::nextafter(p.y, far), std::nextafter(p.y, -far)}) points.push_back({x, y});
  }
}

/// Points anywhere, on vertices, on edges, beside both, and far away.
std::vector<Point2> asked_points(const FlatlandCase& drawn, const Partition& parts) {
  std::vector<Point2> points{drawn.point, {1e9, 3e8}, {-1e9, 2e9}, {1e30, -1e29}, {0, -1e12}};
  for (int i = 0; i < 20; ++i) {
    points.push_back({*rc::gen::inRange(-30, 31) / 2.0, *rc::gen::inRange(-30, 31) / 2.0});
    points.push_back({*rc::gen::inRange(-300, 301) / 19.0, *rc::gen::inRange(-300, 301) / 19.0});
  }
  for (const Point2& vertex : parts.vertices()) add_around(points, vertex);
  for (const PartitionEdge& edge : parts.edges()) {
    if (edge.source == nowhere || edge.target == nowhere) continue;
    const Point2 &a = parts.vertices()[edge.source], &b = parts.vertices()[edge.target];
    add_around(points, {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
  }
  for (const BlockerSegment& blocker : drawn.blockers) add_around(points, blocker[0]);
  return points;
}

FlatlandCase located_case(Domain domain, int most) {
  const FlatlandCase drawn = *laws::flatland_cases(domain, Layout::any, most);
  RC_LOG() << laws::description(drawn);
  return drawn;
}

void expect_regions(const FlatlandCase& drawn, const PartitionOptions& options) {
  const LightVisibility visibility(drawn.flatland());
  const Partition parts = partition(visibility, options);
  const PartitionLocation location(parts);
  for (const Point2& p : asked_points(drawn, parts)) {
    RC_LOG() << p.x << ' ' << p.y << '\n';
    RC_ASSERT(location.region(p) == visibility.region(p));
  }
}

/// The places of all interval ends, exactly.
std::vector<Rational> places(const VisibilityQuery& query, const VisibleLight& seen) {
  std::vector<Rational> all;
  for (const VisibleInterval& interval : seen.intervals) {
    for (const IntervalEnd& end : {interval.from, interval.to}) all.push_back(query.place(end.name));
  }
  return all;
}

RC_GTEST_PROP(PartitionLocationAgreement, RegionsAreThoseThatThePointSees, ()) {
  expect_regions(located_case(Domain::random, 6), {});
}

RC_GTEST_PROP(PartitionLocationAgreement, RegionsOneUlpOffAreThoseThatThePointSees, ()) {
  expect_regions(located_case(Domain::near_degenerate, 5), {});
}

RC_GTEST_PROP(PartitionLocationAgreement, RegionsInAndOutsideABoxAreThoseThatThePointSees, ()) {
  expect_regions(located_case(Domain::random, 6), {Fineness::regions, Box2{{-9, -8}, {9.5, 7}}});
}

RC_GTEST_PROP(PartitionLocationAgreement, VisibleIntervalsAreThoseThatThePointSees, ()) {
  const FlatlandCase drawn = located_case(Domain::random, 4);
  const LightVisibility visibility(drawn.flatland());
  const Partition parts = partition(visibility, {Fineness::structure, {}});
  const PartitionLocation location(parts);
  for (const Point2& p : asked_points(drawn, parts)) {
    RC_LOG() << p.x << ' ' << p.y << '\n';
    const Viewpoint from(p);
    const VisibilityQuery query(visibility, from);
    const VisibleLight found = location.visible_light(p), seen = visibility.visible_light(p);
    RC_ASSERT(found.region == seen.region);
    const std::vector<Rational> exact = places(query, seen);
    RC_ASSERT(places(query, found) == exact);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const VisibleInterval& interval = found.intervals[i / 2];
      const IntervalEnd& end = i % 2 == 0 ? interval.from : interval.to;
      RC_ASSERT(abs(Rational(Rational(end.t) - exact[i])) <= Rational(end.error));
    }
  }
}

PartitionLocation location_of(const std::vector<Point2>& light, const std::vector<BlockerSegment>& blockers) {
  return PartitionLocation(partition(LightVisibility(Flatland::from_points(light, blockers))));
}

TEST(PartitionLocationDegenerate, WithoutBlockersEveryPointIsInTheOneFace) {
  const PartitionLocation location = location_of({{0, 0}, {1, 0}}, {});
  EXPECT_EQ(location.face({3, 4}), 0u);
  EXPECT_EQ(location.region({0, 0}), Region::lit);
}

TEST(PartitionLocation, FindsFacesOnTheLineUprightThroughAVertex) {
  const PartitionLocation location = location_of({{-1, 4}, {1, 4}}, {{{{-2, 2}, {2, 2}}}});
  EXPECT_NE(location.face({-2, 5}), nowhere);
  EXPECT_NE(location.face({-2, 1}), nowhere);
  EXPECT_EQ(location.face({-2, 2}), nowhere);
  EXPECT_EQ(location.face({0, 2}), nowhere);
  EXPECT_NE(location.face({-2, 1}), location.face({-2, 5}));
}

}  // namespace
}  // namespace gnomon::planar
