#include "shading/image/tone.h"

#include <gtest/gtest.h>

#include "shading/image/light_source.h"

namespace gnomon::image {
namespace {

ShadedImage image_of(const std::vector<double>& greys) {
  ShadedImage image{static_cast<std::uint32_t>(greys.size()), 1, {"floor"}, 1, {}};
  for (const double grey : greys) {
    ImagePixel pixel;
    pixel.radiance = {Radiance{grey, 0}, Radiance{grey, 0}, Radiance{grey, 0}};
    pixel.element = 0;
    image.pixels.push_back(pixel);
  }
  return image;
}

TEST(Tone, IsTheSrgbCurveOfExposureTimesRadiance) {
  const std::vector<std::uint8_t> levels = grey_levels(image_of({0, 0.001, 0.1, 0.25, 0.5, 7, HUGE_VAL}), 2);
  const std::vector<int> expected = {0, 7, 124, 188, 255, 255, 255};
  ASSERT_EQ(levels.size(), 3 * expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_EQ(levels[3 * k], expected[k]) << k;
}

TEST(Tone, ExposesThe99thPercentileOfWhatIsShownTo80Percent) {
  std::vector<double> greys;
  for (int k = 1; k <= 201; ++k) greys.push_back(k);
  ShadedImage image = image_of(greys);
  EXPECT_NEAR(automatic_exposure(image), 0.8 / 199, 1e-12);
  for (std::size_t k = 150; k < 201; ++k) image.pixels[k].element = -1;
  EXPECT_NEAR(automatic_exposure(image), 0.8 / 148, 1e-12);
  EXPECT_EQ(automatic_exposure(image_of({0, 0})), 1);
}

TEST(LightSamples, AreTheMiddlesOfEqualParts) {
  const std::vector<LightSample> tube = light_samples(LinearLight{{0, 0, 1}, {4, 0, 1}}, 4);
  ASSERT_EQ(tube.size(), 4u);
  EXPECT_EQ(tube[0].place, (Point3{0.5, 0, 1}));
  EXPECT_EQ(tube[3].place, (Point3{3.5, 0, 1}));
  EXPECT_EQ(tube[0].weight, 1);
  const AreaLight lamp{ConvexPolygon::from_points({{0, 0, 1}, {8, 0, 1}, {8, 2, 1}, {0, 2, 1}})};
  const std::vector<LightSample> grid = light_samples(lamp, 16);
  ASSERT_EQ(grid.size(), 16u);
  EXPECT_EQ(grid[0].place, (Point3{0.5, 0.5, 1}));
  EXPECT_EQ(grid[9].place, (Point3{1.5, 1.5, 1}));
  EXPECT_EQ(grid[9].weight, 1);
  const AreaLight triangle{ConvexPolygon::from_points({{0, 0, 1}, {2, 0, 1}, {0, 2, 1}})};
  double area = 0;
  for (const LightSample& sample : light_samples(triangle, 100)) area += sample.weight;
  EXPECT_NEAR(area, 2, 1e-12);
  EXPECT_TRUE(light_samples(PointLight{{0, 0, 0}}, 5).empty());
}

}  // namespace
}  // namespace gnomon::image
