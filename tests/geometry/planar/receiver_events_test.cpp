#include "gnomon/flatland_receiver.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "apps/proof/laws/flatland_cases.h"
#include "apps/proof/laws/planar_definition.h"
#include "geometry/numbers/rounding.h"
#include "geometry/planar/light_line.h"

namespace gnomon::planar {
namespace {

using laws::FlatlandCase;
using laws::Layout;

std::vector<ReceiverEvent> events(const std::vector<BlockerSegment>& blockers,
                                  const std::array<Point2, 2>& receiver = {{{-8, 0}, {8, 0}}}) {
  return receiver_events(LightVisibility(Flatland::from_points(std::vector<Point2>{{-1, 4}, {1, 4}}, blockers)),
                         receiver);
}

TEST(ReceiverEvents, UnderOneBlockerAreTheFourExtremalLines) {
  const auto found = events({{{{-2, 2}, {2, 2}}}});
  ASSERT_EQ(found.size(), 4u);
  // The lines meet the floor at -5, -3, 3 and 5.
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].place, (std::vector{3 / 16.0, 5 / 16.0, 11 / 16.0, 13 / 16.0}[i]));
    EXPECT_EQ(found[i].order, Discontinuity::d1);
    EXPECT_EQ(found[i].name.contact, i == 0 || i == 3 ? Contact::separating : Contact::supporting);
  }
}

TEST(ReceiverEvents, JumpWhereABlockerStandsOnTheReceiver) {
  const auto found = events({{{{2, 0}, {2, 1}}}});
  const auto foot = std::ranges::find(found, 10 / 16.0, &ReceiverEvent::place);
  ASSERT_NE(foot, found.end());
  EXPECT_EQ(foot->order, Discontinuity::d0);
  EXPECT_EQ(foot->name.kind, BoundaryKind::blocker);
}

std::vector<ReceiverEvent> axis_events(const std::vector<Point2>& light, const std::vector<BlockerSegment>& blockers) {
  return receiver_events(LightVisibility(Flatland::from_points(light, blockers)), {{{-12, 0}, {12, 0}}});
}

TEST(ReceiverEventsRegression, AnEndOnTheReceiverThatHidesEqualSharesIsNoJump) {
  // Half of the light is hidden before the end at (0, 0), and the other half after it.
  const auto on_the_light = axis_events({{-1, 0}, {1, 0}}, {{{{0, 0}, {1, 1}}}});
  const auto middle = std::ranges::find(on_the_light, 0.5, &ReceiverEvent::place);
  ASSERT_NE(middle, on_the_light.end());
  EXPECT_EQ(middle->order, Discontinuity::d1);
  // A third is hidden on both sides of (-4, 0).
  const auto beside = axis_events({{-3, 1}, {-3, -2}}, {{{{-4, 0}, {-3, -1}}}});
  const auto foot = std::ranges::find(beside, 8 / 24.0, &ReceiverEvent::place);
  ASSERT_NE(foot, beside.end());
  EXPECT_EQ(foot->order, Discontinuity::d1);
}

TEST(ReceiverEvents, NeedALinearLightAndAReceiver) {
  EXPECT_ANY_THROW(events({}, {{{0, 0}, {0, 0}}}));
}

const std::array<Point2, 2> the_slanted{{{-9.25, -7.5}, {8.5, 6.125}}};
const std::array<Point2, 2> the_axis{{{-12, 0}, {12, 0}}};

laws::ExactVector named_point(const FlatlandCase& drawn, const EventPoint& name) {
  if (name.kind == EventPointKind::light_end) return laws::exact(drawn.light[name.end]);
  const BlockerSegment& blocker = drawn.blockers[name.element];
  if (name.kind == EventPointKind::blocker_end) return laws::exact(blocker[name.end]);
  const ExactPoint p = crossing_point(drawn.light, blocker);
  return {p.x, p.y, 0};
}

/// The exact place of an event, from its name alone; of a blocker along the receiver, the end that was rounded to it.
Rational exact_place(const FlatlandCase& drawn, const std::array<Point2, 2>& receiver, const ReceiverEvent& event) {
  const laws::ExactVector start = laws::exact(receiver[0]), way = laws::exact(receiver[1]) - start;
  std::array<laws::ExactVector, 2> line;
  if (event.name.kind == BoundaryKind::event) {
    line = {named_point(drawn, event.name.near), named_point(drawn, event.name.far)};
  } else if (event.name.kind == BoundaryKind::light_line) {
    line = {laws::exact(drawn.light[0]), laws::exact(drawn.light[1])};
  } else {
    const BlockerSegment& blocker = drawn.blockers[event.name.element];
    line = {laws::exact(blocker[0]), laws::exact(blocker[1])};
  }
  const Rational across = cross(way, line[1] - line[0]).z;
  if (across != 0) return cross(line[0] - start, line[1] - line[0]).z / across;
  const auto along = [&](const laws::ExactVector& p) { return Rational(dot(p - start, way) / dot(way, way)); };
  return nearest_double(along(line[0])) == event.place ? along(line[0]) : along(line[1]);
}

/// By how much the visible fraction changes from just before a place to just after it, by definition.
Rational change_around(const FlatlandCase& drawn, const std::array<Point2, 2>& receiver, const Rational& place,
                       const Rational& distance) {
  const laws::ExactVector start = laws::exact(receiver[0]), way = laws::exact(receiver[1]) - start;
  const auto fraction_at = [&](const Rational& at) {
    return laws::visible_fraction(drawn.light, drawn.blockers, start + at * way);
  };
  return abs(Rational(fraction_at(place + distance) - fraction_at(place - distance)));
}

/// The change shrinks with the distance, unless the value jumps: then it comes to the jump.
void expect_orders(const std::array<Point2, 2>& receiver, Layout layout) {
  const FlatlandCase drawn = *laws::flatland_cases(laws::Domain::random, layout);
  RC_LOG() << laws::description(drawn);
  if (drawn.light.size() == 1) return;
  Rational tiny = 1;
  for (int i = 0; i < 400; ++i) tiny /= 2;
  for (const ReceiverEvent& event : receiver_events(LightVisibility(drawn.flatland()), receiver)) {
    const Rational place = exact_place(drawn, receiver, event);
    RC_LOG() << "event at " << event.place << '\n';
    RC_ASSERT(nearest_double(place) == event.place);
    const Rational wide = change_around(drawn, receiver, place, tiny);
    const Rational narrow = change_around(drawn, receiver, place, tiny * tiny);
    const bool jumps = narrow != 0 && 2 * narrow > wide;
    RC_ASSERT((event.order == Discontinuity::d0) == jumps);
  }
}

RC_GTEST_PROP(ReceiverEventsProperty, TheValueJumpsWhereTheOrderSaysSo, ()) {
  expect_orders(the_slanted, Layout::any);
}

RC_GTEST_PROP(ReceiverEventsProperty, TheValueJumpsWhereTheOrderSaysSoOnABlockersGrid, ()) {
  expect_orders(the_axis, Layout::any);
}

RC_GTEST_PROP(ReceiverEventsProperty, TheValueJumpsWhereTheOrderSaysSoAcrossTheLight, ()) {
  expect_orders(the_axis, Layout::on_light);
}

RC_GTEST_PROP(ReceiverEventsProperty, BetweenEventsTheVisiblePartsKeepTheirNumber, ()) {
  const FlatlandCase drawn = *laws::flatland_cases(laws::Domain::random, laws::Layout::any);
  RC_LOG() << laws::description(drawn);
  if (drawn.light.size() == 1) return;
  const auto& receiver = the_slanted;
  const auto found = receiver_events(LightVisibility(drawn.flatland()), receiver);
  const laws::ExactVector start = laws::exact(receiver[0]), way = laws::exact(receiver[1]) - start;
  std::vector<double> places{0};
  for (const ReceiverEvent& event : found) places.push_back(event.place);
  places.push_back(1);
  RC_ASSERT(std::ranges::is_sorted(places));
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    if (places[i + 1] - places[i] < 1e-9) continue;
    const auto parts_at = [&](const Rational& share) {
      const Rational from(places[i]), to(places[i + 1]);
      const laws::ExactVector p = start + Rational(from + share * (to - from)) * way;
      return laws::visible_parts(drawn.light, drawn.blockers, p).size();
    };
    RC_ASSERT(parts_at(Rational(1, 1000)) == parts_at(Rational(1, 2)));
    RC_ASSERT(parts_at(Rational(1, 2)) == parts_at(Rational(999, 1000)));
  }
}

}  // namespace
}  // namespace gnomon::planar
