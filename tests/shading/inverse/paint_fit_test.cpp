#include "gnomon/paint_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;
using testing::ElementsAre;

double square_of_residuals(std::span<const FitRow> rows, const std::vector<double>& x) {
  double sum = 0;
  for (const FitRow& row : rows) {
    double r = -row.wanted;
    for (std::size_t k = 0; k < x.size(); ++k) r += row.columns[k] * x[k];
    sum += r * r;
  }
  return sum;
}

std::vector<FitRow> drawn_rows(Dice& dice, std::uint32_t unknowns) {
  std::vector<FitRow> rows(static_cast<std::size_t>(dice.draw(2, 9)));
  for (FitRow& row : rows) {
    for (std::uint32_t k = 0; k < unknowns; ++k) row.columns.push_back(dice.draw(-3, 5) / 4.0);
    row.wanted = dice.draw(-4, 6) / 4.0;
  }
  return rows;
}

/// Half the slope of the squares is 0 in free unknowns, not below 0 at 0, not above 0 at the other bound: so no other
/// place is better, as the squares are convex.
void expect_best(std::span<const FitRow> rows, const LinearFit& fit, double most) {
  for (std::size_t k = 0; k < fit.values.size(); ++k) {
    double slope = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) slope += rows[i].columns[k] * fit.residuals[i];
    EXPECT_GE(fit.values[k], 0);
    EXPECT_LE(fit.values[k], most);
    if (fit.values[k] < most) {
      EXPECT_GE(slope, -1e-12);
    }
    if (fit.values[k] > 0) {
      EXPECT_LE(slope, 1e-12);
    }
  }
}

TEST(LeastSquaresProperty, NoOtherUnknownsWithinTheirBoundsAreBetter) {
  for (std::uint32_t seed = 1; seed <= (GNOMON_LONG ? 5000 : 500); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const auto unknowns = static_cast<std::uint32_t>(dice.draw(1, 3));
    const std::vector<FitRow> rows = drawn_rows(dice, unknowns);
    expect_best(rows, least_squares(rows, unknowns, std::nullopt), 1e300);
    expect_best(rows, least_squares(rows, unknowns, 1.0), 1);
    const std::vector<FitRow> many = drawn_rows(dice, 6);
    expect_best(many, least_squares(many, 6, std::nullopt), 1e300);
  }
}

/// Data made with a part below 0: penalties leave it there, bounds do not ([P93] 5.3.5 takes them for the same).
TEST(LeastSquares, KeepsASignThatPenaltiesLose) {
  std::vector<FitRow> rows;
  for (const double l : {0.2, 0.6, 0.9}) rows.push_back({.columns = {1, l}, .wanted = -0.2 + 0.9 * l});
  const LinearFit fit = least_squares(rows, 2, std::nullopt);
  EXPECT_EQ(fit.values[0], 0);
  EXPECT_NEAR(fit.values[1], (-0.2 * 1.7 + 0.9 * 1.21) / 1.21, 1e-15);
}

TEST(LeastSquares, TellsColumnsThatSamplesDoNotTellApart) {
  const FitRow rows[] = {
      {.columns = {1, 2, 1}, .wanted = 1}, {.columns = {2, 4, 0}, .wanted = 3}, {.columns = {3, 6, 1}, .wanted = 4}};
  const LinearFit fit = least_squares(rows, 3, std::nullopt);
  EXPECT_EQ(fit.rank, 2U);
  EXPECT_TRUE(fit.ill_conditioned);
  EXPECT_EQ(fit.undetermined.size(), 1U);
  EXPECT_NEAR(square_of_residuals(rows, fit.values), 0.0, 0.5);
  const FitRow dark[] = {{.columns = {1, 0}, .wanted = 1}, {.columns = {2, 0}, .wanted = 2}};
  EXPECT_THAT(least_squares(dark, 2, std::nullopt).undetermined, ElementsAre(1));
}

TEST(WithinBounds, TakesTheLeastFirstAndTheMostSecond) {
  const FitRow rows[] = {{.columns = {1, 0.5}, .least = 0.4, .most = 0.6},
                         {.columns = {1, 1}, .least = 0.5, .most = 0.9}};
  const LinearFit fit = within_bounds(rows, 2);
  ASSERT_TRUE(fit.is_feasible);
  EXPECT_EQ(fit.values[0], 0);
  EXPECT_EQ(fit.values[1], 0.9);
}

TEST(WithinBounds, NamesSamplesThatExcludeEachOther) {
  const FitRow rows[] = {{.columns = {1, 0.1}, .least = 0, .most = 2},
                         {.columns = {0, 1}, .least = 0.5, .most = 0.6},
                         {.columns = {0.5, 0}, .least = 0, .most = 1},
                         {.columns = {0, 1}, .least = 0.1, .most = 0.2}};
  const LinearFit fit = within_bounds(rows, 2);
  EXPECT_FALSE(fit.is_feasible);
  EXPECT_THAT(fit.conflict, ElementsAre(1, 3));
}

/// Each conflict is one: its rows alone have no solution; and more boxes only narrow what fits.
TEST(WithinBoundsProperty, ConflictsHoldByThemselvesAndAreSmall) {
  int conflicts = 0;
  for (std::uint32_t seed = 1; seed <= (GNOMON_LONG ? 5000 : 500); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    std::vector<FitRow> rows = drawn_rows(dice, 3);
    for (FitRow& row : rows) {
      row.least = row.wanted;
      row.most = row.wanted + dice.draw(0, 4) / 4.0;
    }
    const LinearFit fit = within_bounds(rows, 3);
    if (fit.is_feasible) {
      for (const double r : fit.residuals) EXPECT_EQ(r, 0);
      rows.pop_back();
      EXPECT_TRUE(within_bounds(rows, 3).is_feasible);
      continue;
    }
    ++conflicts;
    EXPECT_LE(fit.conflict.size(), 4U);
    std::vector<FitRow> some;
    for (const std::uint32_t k : fit.conflict) some.push_back(rows[k]);
    EXPECT_FALSE(within_bounds(some, 3).is_feasible);
  }
  EXPECT_GT(conflicts, 50);
}

SpaceScene studio() {
  SpaceScene scene;
  scene.source = "studio";
  scene.ambient_radiance = {0.25, 0.25, 0.25};
  scene.lights = {{.name = "key", .shape = PointLight{{2, 1, 3}}, .strength = 4},
                  {.name = "fill", .shape = PointLight{{-3, 0, 2}}, .strength = 2}};
  scene.blockers = {
      {.name = "board", .shape = ConvexPolygon::from_points({{-1, -1, 1}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 1}})}};
  return scene;
}

std::vector<PaintSample> painted_points() {
  std::vector<PaintSample> samples;
  for (int i = 0; i < 12; ++i) {
    const double a = 0.5 * i;
    samples.push_back(
        {{1.5 * std::cos(a) - 1, std::sin(a), 0}, {0.1 * std::sin(3 * a), 0, 1}, {-2, -1, 3}, {}, {}, {}});
  }
  return samples;
}

TEST(PaintFit, FindsTheIntensitiesThatPaintWasMadeWith) {
  const SpaceScene scene = studio();
  const Obstacles obstacles = scene_bodies(scene).obstacles;
  Paint paint{.lights = {"key", "fill"}, .samples = painted_points()};
  for (PaintSample& sample : paint.samples) {
    double sum = 0;
    for (const SceneLight& light : scene.lights)
      sum += light_irradiance(light.shape, light.strength, obstacles, sample.point, sample.normal).value;
    sample.wanted = {sum};
  }
  const PaintFit fit = fitted(paint, scene);
  EXPECT_NEAR(fit.channels[0].values[0], 4, 1e-12);
  EXPECT_NEAR(fit.channels[0].values[1], 2, 1e-12);
  EXPECT_EQ(fit.channels[0].rank, 2U);
}

TEST(PaintFit, FindsTheMaterialThatPaintWasMadeWith) {
  const SpaceScene scene = studio();
  const Obstacles obstacles = scene_bodies(scene).obstacles;
  for (const std::uint32_t exponent : {0U, 3U, 17U, 250U}) {
    const Material material{.diffuse = {.5, .25, .75},
                            .specular = {.25, .25, .125},
                            .ambient = {.1, .2, .3},
                            .exponent = static_cast<int>(exponent)};
    Paint paint{.fit = Paint::Fit::material, .samples = painted_points(), .channels = 3};
    for (PaintSample& sample : paint.samples) {
      const Point3 to_eye = {sample.eye.x - sample.point.x, sample.eye.y - sample.point.y,
                             sample.eye.z - sample.point.z};
      for (std::size_t c = 0; c < 3; ++c) sample.wanted.push_back(material.ambient[c] * scene.ambient_radiance[c]);
      for (const SceneLight& light : scene.lights) {
        const Rgb strength = {light.strength, light.strength, light.strength};
        const RadianceRgb r =
            light_radiance(light.shape, strength, obstacles, {sample.point, sample.normal, to_eye}, material);
        for (std::size_t c = 0; c < 3; ++c) sample.wanted[c] += r[c].value;
      }
    }
    const PaintFit fit = fitted(paint, scene);
    EXPECT_EQ(fit.exponent, exponent);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(fit.channels[c].values[0], material.ambient[c], 1e-9);
      EXPECT_NEAR(fit.channels[c].values[1], material.diffuse[c], 1e-9);
      EXPECT_NEAR(fit.channels[c].values[2], material.specular[c], 1e-9);
    }
  }
}

/// Three samples do not tell an exponent, against [P93]: others fit as well.
TEST(PaintFit, TellsThatFewSamplesLeaveTheExponentOpen) {
  const SpaceScene scene = studio();
  Paint paint{.fit = Paint::Fit::material, .samples = painted_points()};
  paint.samples.resize(2);
  for (PaintSample& sample : paint.samples) sample.wanted = {0.0625};
  const PaintFit fit = fitted(paint, scene);
  EXPECT_LT(fit.least_exponent, fit.most_exponent);
}

}  // namespace
}  // namespace gnomon
