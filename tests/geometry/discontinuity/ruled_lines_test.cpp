#include "geometry/discontinuity/ruled_lines.h"

#include <gtest/gtest.h>

#include <random>

namespace gnomon::event {
namespace {

Interval point_interval(double x) {
  return {x, x};
}

TEST(RuledLines, SignsAreCertainOnlyOfPolynomialsThatHaveThemThroughout) {
  const CGAL::Protect_FPU_rounding<true> upward;
  const auto sign = [](double c0, double c1, double c2, double c3, double from, double to) {
    return certain_sign({Interval(c0), Interval(c1), Interval(c2), Interval(c3)}, point_interval(from),
                        point_interval(to));
  };
  EXPECT_EQ(sign(1, 0, 0, 0, 0, 1), 1);
  EXPECT_EQ(sign(-1, 0, 0, 0, 0, 1), -1);
  EXPECT_EQ(sign(1, -4.5, 4.5, 0, 0, 1), 0);  // a dip below zero between two positive ends
  EXPECT_EQ(sign(1, -4.5, 4.5, 0, 0, 0.125), 1);
  EXPECT_EQ(sign(0, 1, 0, 0, 0, 1), 0);       // zero at one end
  EXPECT_EQ(sign(0.75, 3, -12, 8, 0, 1), 0);  // a cubic that has both signs
}

TEST(RuledLinesAgreement, CertainSignsAreThoseOfEveryPointOfTheRange) {
  const CGAL::Protect_FPU_rounding<true> upward;
  std::mt19937 random(1);
  const auto whole = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  int certain = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    int c[4];
    for (int& x : c) x = whole(-9, 9);
    const int from = whole(-8, 7), to = whole(from + 1, 8);
    const int found = certain_sign({Interval(c[0]), Interval(c[1]), Interval(c[2]), Interval(c[3])},
                                   point_interval(from / 8.0), point_interval(to / 8.0));
    if (found == 0) continue;
    ++certain;
    for (int k = 0; k <= 64; ++k) {
      const Rational t = Rational(from, 8) + Rational(k, 64) * Rational(to - from, 8);
      ASSERT_EQ(Rational(c[0] + t * (c[1] + t * (c[2] + t * c[3]))).sign(), found) << trial;
    }
  }
  EXPECT_GT(certain, 5000);
}

/// Three edges above the plane z = 0, and what is asked of the lines that meet them.
class RuledLinesOfEdges : public testing::Test {
 protected:
  void draw() {
    for (SilhouetteEdge& edge : edges_) {
      edge.a = Place(vector(1));
      edge.b = Place(vector(1));
      edge.line = near_line(edge.a.near, edge.b.near);
    }
  }

  ExactVector vector(int low) {
    std::uniform_int_distribution<int> wide(-9, 9), high(low, 9);
    const int x = wide(random_), y = wide(random_);
    return {Rational(x), Rational(y), Rational(high(random_))};
  }

  static Rational volume(const ExactVector& p, const ExactVector& a, const ExactVector& b, const ExactVector& c) {
    return dot(cross(a - p, b - p), c - p);
  }

  static ExactVector on(const SilhouetteEdge& edge, const Rational& t) {
    return edge.a.exact + t * (edge.b.exact - edge.a.exact);
  }

  static bool holds(const NearPolynomial& f, double t, const Rational& value) {
    const Interval x(t), all = f[0] + x * (f[1] + x * (f[2] + x * f[3]));
    return Rational(all.inf()) <= value && value <= Rational(all.sup());
  }

  std::mt19937 random_{2};
  std::array<SilhouetteEdge, 3> edges_;
};

TEST_F(RuledLinesOfEdges, HoldTheExactSidesAndHeights) {
  const CGAL::Protect_FPU_rounding<true> upward;
  const ReceiverPlane plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const NearFrame frame(plane);
  int asked = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    draw();
    const RuledLines lines({&edges_[0], &edges_[1], &edges_[2]}, frame);
    const double t = (trial % 15 + 1) / 16.0;
    const ExactVector q = on(edges_[0], Rational(t));
    // The traces of both planes through q: n (x, y, 0) = n q.
    const ExactVector n = cross(edges_[1].a.exact - q, edges_[1].b.exact - q),
                      m = cross(edges_[2].a.exact - q, edges_[2].b.exact - q);
    const Rational w = n.x * m.y - n.y * m.x;
    if (w == 0) continue;
    const Rational nq = dot(n, q), mq = dot(m, q);
    const ExactVector p{Rational((nq * m.y - mq * n.y) / w), Rational((n.x * mq - m.x * nq) / w), Rational(0)};
    ASSERT_TRUE(holds(lines.point_weight(), t, w)) << trial;
    const ExactVector a = vector(1), b = vector(1), c = vector(1);
    const Place near_a(a), near_b(b), near_c(c);
    EXPECT_TRUE(holds(lines.side(near_line(near_a.near, near_b.near)), t, Rational(w * volume(p, a, b, q)))) << trial;
    const NearPlane facet = near_plane(near_a.near, near_b.near, near_c.near);
    const ExactVector normal = cross(b - a, c - a);
    EXPECT_TRUE(holds(lines.height_of_point(facet), t, Rational(w * dot(normal, p - a)))) << trial;
    EXPECT_TRUE(holds(lines.height_of_base(facet), t, Rational(dot(normal, q - a)))) << trial;
    const ExactVector of_edge = cross(edges_[1].a.exact - p, edges_[1].b.exact - p);
    EXPECT_TRUE(holds(lines.crossing(edges_[1].line, edges_[2].line), t,
                      Rational(w * dot(of_edge, edges_[2].b.exact - edges_[2].a.exact))))
        << trial;
    ++asked;
  }
  EXPECT_GT(asked, 1500);
}

}  // namespace
}  // namespace gnomon::event
