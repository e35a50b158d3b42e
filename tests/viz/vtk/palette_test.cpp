#include "viz/vtk/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace gnomon::viz {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// How a viewer sees: linear red, green and blue are mixed by the matrix.
struct Viewer {
  std::string name;
  Matrix mixed;
};

/// Complete absence of one kind of cone, in linear sRGB: Machado, Oliveira and Fernandes (2009), severity 1.
const std::vector<Viewer> viewers = {
    {"three cones", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}},
    {"no cones", {{{0.2126, 0.7152, 0.0722}, {0.2126, 0.7152, 0.0722}, {0.2126, 0.7152, 0.0722}}}},
};

double linear(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::array<double, 3> product(const Matrix& matrix, const std::array<double, 3>& v) {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i] += matrix[i][k] * v[k];
  }
  return result;
}

/// CIE L*a*b* under D65.
std::array<double, 3> lab(const Color& color, const Viewer& viewer) {
  const Matrix to_xyz = {
      {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
  const auto seen = product(viewer.mixed, {linear(color[0]), linear(color[1]), linear(color[2])});
  const auto xyz = product(to_xyz, seen);
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = f(xyz[0] / 0.95047);
  const double y = f(xyz[1]);
  const double z = f(xyz[2] / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double difference(const Color& a, const Color& b, const Viewer& viewer) {
  const auto p = lab(a, viewer);
  const auto q = lab(b, viewer);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// A difference of 2.3 is just noticed; side by side, 10 is plain.
void expect_told_apart(const std::vector<std::pair<std::string, Color>>& colors) {
  for (const Viewer& viewer : viewers) {
    for (std::size_t i = 0; i < colors.size(); ++i) {
      for (std::size_t k = i + 1; k < colors.size(); ++k) {
        EXPECT_GE(difference(colors[i].second, colors[k].second, viewer), 10)
            << colors[i].first << " and " << colors[k].first << " with " << viewer.name;
      }
    }
  }
}

TEST(Palette, RegionsAreToldApartWithoutAnyKindOfCone) {
  expect_told_apart({{"lit", palette.lit}, {"penumbra", palette.penumbra}, {"umbra", palette.umbra}});
}

TEST(Palette, OrdersAreToldApartWithoutAnyKindOfCone) {
  expect_told_apart(
      {{"D0", palette.discontinuities[0]}, {"D1", palette.discontinuities[1]}, {"D2", palette.discontinuities[2]}});
}

TEST(Palette, OrdersAreToldApartFromTheRegionsTheyLieOn) {
  for (const Color& order : palette.discontinuities) {
    expect_told_apart({{"order", order}, {"lit", palette.lit}});
    expect_told_apart({{"order", order}, {"penumbra", palette.penumbra}});
    expect_told_apart({{"order", order}, {"umbra", palette.umbra}});
  }
}

TEST(Palette, SeparatingAndSupportingAreToldApartByCones) {
  const std::vector<Viewer> with_cones(viewers.begin(), viewers.end() - 1);
  for (const Viewer& viewer : with_cones) {
    EXPECT_GE(difference(palette.separating, palette.supporting, viewer), 10) << viewer.name;
  }
}

}  // namespace
}  // namespace gnomon::viz
