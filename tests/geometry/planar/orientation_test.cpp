#include "geometry/planar/orientation.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/numbers/kernel.h"

namespace gnomon::planar {
namespace {

int turn_by_rationals(const Point2& p, const Point2& q, const Point2& r, const Point2& s) {
  const Rational left = (Rational(q.x) - Rational(p.x)) * (Rational(s.y) - Rational(r.y));
  const Rational right = (Rational(q.y) - Rational(p.y)) * (Rational(s.x) - Rational(r.x));
  return CGAL::sign(Rational(left - right));
}

/// A small integer, scaled and moved so that differences round or vanish, and pushed to a neighbouring double.
double draw_coordinate(double scale, double offset) {
  const double value = *rc::gen::inRange(-4, 5) * scale + offset;
  const int push = *rc::gen::inRange(-2, 3);
  return push == 0 ? value : std::nextafter(value, push > 0 ? HUGE_VAL : -HUGE_VAL);
}

Point2 draw_point(double scale, double offset) {
  const double x = draw_coordinate(scale, offset);
  return {x, draw_coordinate(scale, offset)};
}

RC_GTEST_PROP(PlanarTurnAgreement, IsTheSignThatRationalsGive, ()) {
  const double scale = std::ldexp(1.0, *rc::gen::element(0, 0, 0, -30, 30, -500, 500, -1040, 1020));
  const double offset = *rc::gen::element(0.0, 0.0, 0.1, 1.0, 1e16, 1e-300);
  const Point2 p = draw_point(scale, offset), q = draw_point(scale, offset);
  const Point2 r = draw_point(scale, offset), s = draw_point(scale, offset);
  RC_ASSERT(turn(p, q, r, s) == turn_by_rationals(p, q, r, s));
  RC_ASSERT(orientation(p, q, r) == turn_by_rationals(p, q, p, r));
}

TEST(PlanarTurn, IsPositiveToTheLeft) {
  EXPECT_EQ(turn({0, 0}, {1, 0}, {5, 5}, {5, 6}), 1);
  EXPECT_EQ(turn({0, 0}, {1, 0}, {5, 5}, {5, 4}), -1);
  EXPECT_EQ(turn({0, 0}, {1, 0}, {5, 5}, {-3, 5}), 0);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0.5, 1}), 1);
}

TEST(PlanarTurnDegenerate, OneBitOffALineThroughDecimals) {
  const Point2 p{0.1, 0.1}, q{12.3, 12.3};
  EXPECT_EQ(orientation(p, q, {0.7, 0.7}), 0);
  EXPECT_EQ(orientation(p, q, {0.7, std::nextafter(0.7, 1)}), 1);
  EXPECT_EQ(orientation(p, q, {0.7, std::nextafter(0.7, 0)}), -1);
}

TEST(PlanarTurnDegenerate, OverflowAndUnderflow) {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(orientation({-huge, -huge}, {huge, huge}, {0, 0}), 0);
  EXPECT_EQ(orientation({-huge, -huge}, {huge, huge}, {0, tiny}), 1);
  EXPECT_EQ(orientation({0, 0}, {tiny, 0}, {0, tiny}), 1);
  EXPECT_EQ(orientation({0, 0}, {tiny, 2 * tiny}, {3 * tiny, 6 * tiny}), 0);
}

}  // namespace
}  // namespace gnomon::planar
