#include "gnomon/flatland_partition.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "apps/proof/laws/flatland_cases.h"
#include "apps/proof/laws/planar_definition.h"
#include "geometry/numbers/rounding.h"
#include "geometry/planar/light_line.h"
#include "geometry/planar/partition_data.h"
#include "gnomon/errors.h"
#include "gnomon/flatland_regions.h"

namespace gnomon::planar {
namespace {

using laws::Domain;
using laws::ExactVector;
using laws::FlatlandCase;
using laws::Layout;

const Box2 the_box{{-16, -16}, {16, 16}};

Region region_with(const Rational& f) {
  return f == 1 ? Region::lit : f == 0 ? Region::umbra : Region::penumbra;
}

Region region_by_definition(const FlatlandCase& drawn, const ExactVector& p) {
  return region_with(laws::visible_fraction(drawn.light, drawn.blockers, p));
}

ExactVector vector(const ExactPoint& p) {
  return {p.x, p.y, 0};
}

/// The named point of an event.
ExactVector named_point(const FlatlandCase& drawn, const EventPoint& name) {
  if (name.kind == EventPointKind::light_end) return laws::exact(drawn.light[name.end]);
  const BlockerSegment& blocker = drawn.blockers[name.element];
  if (name.kind == EventPointKind::blocker_end) return laws::exact(blocker[name.end]);
  return vector(crossing_point(drawn.light, blocker));
}

/// Two points of the line that a boundary lies on.
std::array<ExactVector, 2> named_line(const FlatlandCase& drawn, const Partition& partition, const BoundaryName& name) {
  switch (name.kind) {
    case BoundaryKind::blocker:
      return {laws::exact(drawn.blockers[name.element][0]), laws::exact(drawn.blockers[name.element][1])};
    case BoundaryKind::light_line:
      return {laws::exact(drawn.light[0]), laws::exact(drawn.light[1])};
    case BoundaryKind::event:
      return {named_point(drawn, name.near), named_point(drawn, name.far)};
    case BoundaryKind::clip_box: {
      const Box2& box = *partition.box();
      const bool upright = name.element < 2;
      const double at = name.element == 0   ? box.min.x
                        : name.element == 1 ? box.max.x
                        : name.element == 2 ? box.min.y
                                            : box.max.y;
      if (upright) return {laws::exact(Point2{at, 0}), laws::exact(Point2{at, 1})};
      return {laws::exact(Point2{0, at}), laws::exact(Point2{1, at})};
    }
  }
  return {};
}

/// A point inside an edge and the edge's direction.
struct EdgeSample {
  ExactVector point;
  ExactVector way;
};

EdgeSample sample_of(const FlatlandCase& drawn, const Partition& partition, const PartitionEdge& edge) {
  const auto& vertices = partition.data().exact_vertices;
  if (edge.source != nowhere && edge.target != nowhere) {
    const ExactVector a = vector(vertices[edge.source]), b = vector(vertices[edge.target]);
    return {a + Rational(3, 7) * (b - a), b - a};
  }
  const auto [from, to] = named_line(drawn, partition, partition.names()[edge.name]);
  ExactVector way = to - from;
  if (partition.names()[edge.name].kind == BoundaryKind::event) {
    // Rays run from the farther point away from the light.
    if (edge.source == nowhere) way = Rational(-1) * way;
  } else if (edge.source == nowhere && edge.target == nowhere) {
    return {from + Rational(3, 7) * way, way};
  }
  const bool starts = edge.source != nowhere;
  const ExactVector end = vector(vertices[starts ? edge.source : edge.target]);
  return {starts ? end + way : end - way, way};
}

/// Every edge lies on the line that its name says, and separates what its two faces say.
void expect_edges(const FlatlandCase& drawn, const Partition& partition) {
  Rational tiny = 1;
  for (int i = 0; i < 300; ++i) tiny /= 2;
  for (const PartitionEdge& edge : partition.edges()) {
    const BoundaryName& name = partition.names()[edge.name];
    const auto [from, to] = named_line(drawn, partition, name);
    for (const std::uint32_t end : {edge.source, edge.target}) {
      if (end != nowhere) RC_ASSERT(laws::side_of(from, to, vector(partition.data().exact_vertices[end])) == 0);
    }
    if (name.kind == BoundaryKind::light_line && (edge.source == nowhere || edge.target == nowhere)) continue;
    const EdgeSample sample = sample_of(drawn, partition, edge);
    const ExactVector aside{Rational(-tiny * sample.way.y), Rational(tiny * sample.way.x), 0};
    const auto at = [&](const ExactVector& p) { return region_by_definition(drawn, p); };
    if (edge.left != nowhere) RC_ASSERT(partition.faces()[edge.left].region == at(sample.point + aside));
    if (edge.right != nowhere) RC_ASSERT(partition.faces()[edge.right].region == at(sample.point - aside));
    if (edge.left == nowhere || edge.right == nowhere) continue;
    const Region left = partition.faces()[edge.left].region, right = partition.faces()[edge.right].region;
    RC_ASSERT(left != right || at(sample.point) != left);
  }
}

/// How often the cycles of a face run around a point, counted along a ray to the right; nothing if the point is on one.
std::optional<int> winding(const Partition& partition, const PartitionFace& face, const ExactVector& p) {
  int count = 0;
  for (const auto& cycle : face.boundary) {
    for (const EdgeUse& use : cycle) {
      const PartitionEdge& edge = partition.edges()[use.edge];
      const bool forward = use.way == EdgeUse::Way::forward;
      const ExactVector a = vector(partition.data().exact_vertices[forward ? edge.source : edge.target]);
      const ExactVector b = vector(partition.data().exact_vertices[forward ? edge.target : edge.source]);
      const int side = laws::side_of(a, b, p);
      if (side == 0 && dot(a - p, b - p) <= 0) return std::nullopt;
      if (a.y <= p.y && b.y > p.y && side > 0) ++count;
      if (b.y <= p.y && a.y > p.y && side < 0) --count;
    }
  }
  return count;
}

/// Every point of the box lies in one face, of its region, or on an edge.
void expect_face(const FlatlandCase& drawn, const Partition& partition, const ExactVector& p) {
  int faces = 0;
  for (const PartitionFace& face : partition.faces()) {
    const std::optional<int> around = winding(partition, face, p);
    if (!around) return;
    RC_ASSERT(*around == 0 || *around == 1);
    faces += *around;
    const bool is_point = std::ranges::any_of(
        face.points, [&](std::uint32_t vertex) { return vector(partition.data().exact_vertices[vertex]) == p; });
    if (*around == 1 && !is_point) RC_ASSERT(face.region == region_by_definition(drawn, p));
    if (*around == 1 && is_point) RC_ASSERT(face.region != region_by_definition(drawn, p));
  }
  RC_ASSERT(faces == 1);
}

FlatlandCase drawn_case(Domain domain, int most = 6) {
  const FlatlandCase drawn = *laws::flatland_cases(domain, Layout::any, most);
  RC_LOG() << laws::description(drawn);
  return drawn;
}

void expect_points(const FlatlandCase& drawn, const Partition& partition) {
  for (int i = 0; i < 10; ++i) {
    const int x = *rc::gen::inRange(-30, 31), y = *rc::gen::inRange(-30, 31);
    expect_face(drawn, partition, {Rational(x, 2), Rational(y, 2), 0});
  }
  const ExactVector p = laws::exact(drawn.point);
  if (CGAL::abs(p.x) < 16 && CGAL::abs(p.y) < 16) expect_face(drawn, partition, p);
}

RC_GTEST_PROP(PartitionProperty, EveryEdgeSeparatesWhatTheDefinitionSays, ()) {
  const FlatlandCase drawn = drawn_case(Domain::random);
  expect_edges(drawn, partition(LightVisibility(drawn.flatland())));
}

RC_GTEST_PROP(PartitionProperty, EveryEdgeDoesSoOneUlpOff, ()) {
  const FlatlandCase drawn = drawn_case(Domain::near_degenerate);
  expect_edges(drawn, partition(LightVisibility(drawn.flatland())));
}

RC_GTEST_PROP(PartitionProperty, EveryPointOfABoxLiesInOneFaceOfItsRegion, ()) {
  const FlatlandCase drawn = drawn_case(Domain::random);
  const Partition parts = partition(LightVisibility(drawn.flatland()), {Fineness::regions, the_box});
  expect_edges(drawn, parts);
  expect_points(drawn, parts);
}

RC_GTEST_PROP(PartitionProperty, FinerFacesHaveOneListOfVisibleIntervals, ()) {
  const FlatlandCase drawn = drawn_case(Domain::random, 4);
  const LightVisibility visibility(drawn.flatland());
  const Partition fine = partition(visibility, {Fineness::structure, the_box});
  expect_points(drawn, [&] { return fine; }());
  for (int i = 0; i < 5; ++i) {
    const int x = *rc::gen::inRange(-300, 301), y = *rc::gen::inRange(-300, 301);
    const Point2 p{x / 19.0, y / 19.0};
    for (const PartitionFace& face : fine.faces()) {
      if (winding(fine, face, laws::exact(p)) != 1) continue;
      const VisibleLight seen = visibility.visible_light(p);
      RC_ASSERT(seen.intervals.size() == face.visible.size());
      for (std::size_t k = 0; k < seen.intervals.size(); ++k) {
        RC_ASSERT(seen.intervals[k].from.name == face.visible[k].from.name);
        RC_ASSERT(seen.intervals[k].to.name == face.visible[k].to.name);
      }
    }
  }
}

Partition partition_of(const std::vector<Point2>& light, const std::vector<BlockerSegment>& blockers,
                       const PartitionOptions& options = {}) {
  return partition(LightVisibility(Flatland::from_points(light, blockers)), options);
}

std::array<std::size_t, 3> counts(const Partition& parts) {
  return {parts.count(Region::lit), parts.count(Region::penumbra), parts.count(Region::umbra)};
}

using Counts = std::array<std::size_t, 3>;

TEST(Partition, WithoutBlockersIsOneLitFace) {
  const Partition parts = partition_of({{0, 0}, {1, 0}}, {});
  EXPECT_EQ(counts(parts), (Counts{1, 0, 0}));
  EXPECT_FALSE(parts.faces()[0].bounded);
  EXPECT_TRUE(parts.edges().empty());
}

TEST(Partition, HasAJointUmbraBehindTwoBlockersThatOverlapAsSeen) {
  const std::vector<BlockerSegment> blockers{{{{-4, 4}, {-0.25, 4}}}, {{{-0.5, 3}, {3.5, 3}}}};
  const Partition parts = partition_of({{-3, 8}, {3, 8}}, blockers);
  // The left blocker's own umbra, which is bounded, and the joint one, which holds that of the right blocker.
  EXPECT_EQ(parts.count(Region::umbra), 2u);
  EXPECT_EQ(std::ranges::count_if(
                parts.faces(), [](const PartitionFace& face) { return face.region == Region::umbra && face.bounded; }),
            1);
  EXPECT_EQ(parts.visibility().region({-0.375, 1}), Region::umbra);
  for (const BlockerSegment& blocker : blockers) {
    EXPECT_EQ(LightVisibility(Flatland::from_points(parts.visibility().flatland().light(), {&blocker, 1}))
                  .region({-0.375, 1}),
              Region::penumbra);
  }
}

TEST(PartitionDegenerate, APolylineShadesLikeTheSegmentItFollows) {
  const std::vector<Point2> light{{-3, 4}, {3, 4}};
  const Partition one = partition_of(light, {{{{-1, 2}, {1, 2}}}}, {Fineness::regions, the_box});
  const Partition three = partition_of(light, {{{{-1, 2}, {0, 2}}}, {{{0, 2}, {0.5, 2}}}, {{{0.25, 2}, {1, 2}}}},
                                       {Fineness::regions, the_box});
  EXPECT_EQ(counts(one), counts(three));
  for (const Region region : {Region::lit, Region::penumbra, Region::umbra}) {
    EXPECT_EQ(partition_in_box(one).area(region).exact, partition_in_box(three).area(region).exact);
  }
}

TEST(Partition, OfOneBlockerHasTheAreasOfThePair) {
  const std::vector<Point2> light{{-3, 4}, {3, 5}};
  const BlockerSegment blocker{{{-1, 2}, {1, 1}}};
  const auto pair = regions_in_box(shadow_regions(Pair::from_points(light, blocker)), the_box);
  const PartitionInBox parts = partition_in_box(partition_of(light, {blocker}, {Fineness::regions, the_box}));
  EXPECT_EQ(parts.area(Region::lit).exact, pair.lit.area.exact);
  EXPECT_EQ(parts.area(Region::penumbra).exact, pair.penumbra.area.exact);
  EXPECT_EQ(parts.area(Region::umbra).exact, pair.umbra.area.exact);
}

TEST(Partition, ChecksTheBox) {
  const Box2 flat{{0, 0}, {1, 0}};
  EXPECT_THROW(partition_of({{0, 0}}, {}, {Fineness::regions, flat}), PreconditionError);
  EXPECT_THROW(partition_in_box(partition_of({{0, 0}}, {})), PreconditionError);
}

RC_GTEST_PROP(PartitionInBoxProperty, TrianglesTileTheFaces, ()) {
  const FlatlandCase drawn = drawn_case(Domain::random);
  const Partition parts = partition(LightVisibility(drawn.flatland()), {Fineness::regions, the_box});
  const PartitionInBox in_box = partition_in_box(parts);
  const auto& vertices = parts.data().exact_vertices;
  std::vector<Rational> twice(parts.faces().size());
  for (const FaceTriangle& triangle : in_box.triangles) {
    const ExactVector a = vector(vertices[triangle.corners[0]]), b = vector(vertices[triangle.corners[1]]),
                      c = vector(vertices[triangle.corners[2]]);
    const Rational area = cross(b - a, c - a).z;
    RC_ASSERT(area > 0);
    twice[triangle.face] += area;
    const ExactVector middle = Rational(1, 3) * (a + b + c);
    RC_ASSERT(winding(parts, parts.faces()[triangle.face], middle) == 1);
  }
  Rational all = 0;
  for (std::size_t i = 0; i < twice.size(); ++i) {
    RC_ASSERT(exact_number(twice[i] / 2).exact == in_box.faces[i].area.exact);
    all += twice[i];
  }
  RC_ASSERT(all == 2 * 32 * 32);
}

}  // namespace
}  // namespace gnomon::planar
