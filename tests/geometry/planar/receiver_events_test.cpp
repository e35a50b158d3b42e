#include "geometry/planar/receiver_events.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "apps/laws/flatland_cases.h"
#include "apps/laws/planar_definition.h"

namespace gnomon::planar {
namespace {

using laws::FlatlandCase;

std::vector<ReceiverEvent> events(const std::vector<BlockerSegment>& blockers,
                                  const std::array<Point2, 2>& receiver = {{{-8, 0}, {8, 0}}}) {
  return receiver_events(Sight(Flatland::from_points(std::vector<Point2>{{-1, 4}, {1, 4}}, blockers)), receiver);
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

TEST(ReceiverEvents, NeedALinearLightAndAReceiver) {
  EXPECT_ANY_THROW(events({}, {{{0, 0}, {0, 0}}}));
}

RC_GTEST_PROP(ReceiverEventsProperty, BetweenEventsTheVisiblePartsKeepTheirNumber, ()) {
  const FlatlandCase drawn = *laws::flatland_cases(laws::Domain::random, laws::Layout::any);
  RC_LOG() << laws::description(drawn);
  if (drawn.light.size() == 1) return;
  const std::array<Point2, 2> receiver{{{-9.25, -7.5}, {8.5, 6.125}}};
  const auto found = receiver_events(Sight(drawn.flatland()), receiver);
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
