#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shading/lambert.h"

// View factors of two parallel unit squares at distance 1, with and without a square between them, against figures that
// were computed elsewhere. The receiver is split along the traces of every plane through a light vertex and a blocker
// edge or a light edge and a blocker vertex; between them the irradiance is analytic.
namespace gnomon {
namespace {

struct Node {
  double x;
  double weight;
};

/// Gauss-Legendre nodes on [0, 1], by Newton's method.
std::vector<Node> gauss_nodes(int n) {
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 0;
    for (int step = 0; step < 20; ++step) {
      double before = 1;
      double value = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    nodes.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

ConvexPolygon square(double low, double high, double z) {
  return ConvexPolygon::from_points({{low, low, z}, {low, high, z}, {high, high, z}, {high, low, z}});
}

/// All edges are parallel to the axes, so are the traces: where lines through light and blocker meet z = 0.
std::vector<double> traces(double low, double high, double z) {
  std::vector<double> result = {0, 1};
  for (const double light : {0.0, 1.0}) {
    for (const double blocker : {low, high}) {
      const double trace = light + (blocker - light) / (1 - z);
      if (trace > 0 && trace < 1) result.push_back(trace);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The mean over the receiver of irradiance / pi, and of its bounds.
Irradiance view_factor(FastVisibility& visibility, const std::vector<double>& cuts) {
  const std::vector<Node> nodes = gauss_nodes(24);
  Irradiance mean;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    for (std::size_t j = 0; j + 1 < cuts.size(); ++j) {
      const double width = cuts[i + 1] - cuts[i];
      const double height = cuts[j + 1] - cuts[j];
      for (const Node& a : nodes) {
        for (const Node& b : nodes) {
          const Point3 p{cuts[i] + a.x * width, cuts[j] + b.x * height, 0};
          const Irradiance e = lambert_irradiance(visibility.visible_from(p).value(), {0, 0, 1}, 1);
          const double weight = a.weight * b.weight * width * height / std::numbers::pi;
          mean.value += weight * e.value;
          mean.error_bound += weight * e.error_bound;
        }
      }
    }
  }
  return mean;
}

Irradiance view_factor_behind(double z) {
  const std::vector<ConvexBlocker> blockers = {square(.25, .75, z)};
  FastVisibility visibility({square(0, 1, 1)}, BlockerSet(blockers));
  return view_factor(visibility, traces(.25, .75, z));
}

TEST(ViewFactor, OfTwoUnitSquaresIsTheKnownOne) {
  FastVisibility visibility({square(0, 1, 1)}, BlockerSet({}));
  const Irradiance f = view_factor(visibility, {0, 1});
  EXPECT_NEAR(f.value, 0.19982489569839, 1e-12);
  EXPECT_LT(f.error_bound, 1e-13);
}

TEST(ViewFactor, BehindASquareNearTheReceiverIsTheKnownOne) {
  const Irradiance f = view_factor_behind(.25);
  EXPECT_NEAR(f.value, 0.11562060213242, 1e-12);
  EXPECT_LT(f.error_bound, 1e-12);
}

TEST(ViewFactor, BehindASquareHalfwayIsTheKnownOne) {
  const Irradiance f = view_factor_behind(.5);
  EXPECT_NEAR(f.value, 0.09950629459898, 1e-12);
  EXPECT_LT(f.error_bound, 1e-12);
}

}  // namespace
}  // namespace gnomon
