#include "gnomon/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "gnomon/errors.h"
#include "gnomon/writer.h"
#include "tests/viz/planar_sample.h"
#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"
#include "viz/vtk/palette.h"

namespace gnomon {
namespace {

/// A picture as its reader gives it: 8 bits per channel.
class Pixels {
 public:
  explicit Pixels(const std::filesystem::path& file) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    image_ = reader->GetOutput();
  }

  int width() const { return image_->GetDimensions()[0]; }
  int height() const { return image_->GetDimensions()[1]; }

  std::array<double, 3> at(int x, int y) const {
    std::array<double, 3> color;
    for (int k = 0; k < 3; ++k)
      color[static_cast<std::size_t>(k)] = image_->GetScalarComponentAsDouble(x, y, 0, k) / 255;
    return color;
  }

  /// Number of pixels that differ from the colour by at most `slack` in every channel, left of the legend.
  int close_to(const viz::Color& color, double slack) const {
    int count = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < 0.78 * width(); ++x) count += is_close(at(x, y), color, slack) ? 1 : 0;
    }
    return count;
  }

  bool border_is_white() const {
    const viz::Color white = {1, 1, 1};
    for (int x = 0; x < width(); ++x) {
      if (at(x, 0) != white || at(x, height() - 1) != white) return false;
    }
    for (int y = 0; y < height(); ++y) {
      if (at(0, y) != white || at(width() - 1, y) != white) return false;
    }
    return true;
  }

  friend bool operator==(const Pixels& a, const Pixels& b) {
    if (a.width() != b.width() || a.height() != b.height()) return false;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) {
        if (a.at(x, y) != b.at(x, y)) return false;
      }
    }
    return true;
  }

 private:
  static bool is_close(const viz::Color& a, const viz::Color& b, double slack) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(a[k] - b[k]) > slack) return false;
    }
    return true;
  }

  vtkSmartPointer<vtkImageData> image_;
};

const PictureOptions small{640, 480};

TEST(Picture, ShowsLightBlockerReceiverUmbraAndPenumbra) {
  const TemporaryFolder folder;
  render_scene(SampleResult().result(), folder / "picture.png", small);
  const Pixels pixels(folder / "picture.png");
  ASSERT_EQ(pixels.width(), 640);
  ASSERT_EQ(pixels.height(), 480);
  EXPECT_GT(pixels.close_to(viz::palette.light, 0.08), 200);  // its name stands on it
  EXPECT_GT(pixels.close_to(viz::palette.blocker, 0.08), 1000);
  EXPECT_GT(pixels.close_to(viz::palette.lit, 0.01), 10000);
  EXPECT_GT(pixels.close_to(viz::palette.penumbra, 0.08), 3000);
  EXPECT_GT(pixels.close_to(viz::palette.umbra, 0.15), 1000);
}

TEST(Picture, ClipsNothing) {
  const TemporaryFolder folder;
  SampleResult sample;
  render_scene(sample.result(), folder / "wide.png", {800, 300});
  EXPECT_TRUE(Pixels(folder / "wide.png").border_is_white());
  render_scene(sample.result(), folder / "high.png", {300, 800});
  EXPECT_TRUE(Pixels(folder / "high.png").border_is_white());
}

TEST(Picture, LosesTheUmbraWithTheUmbra) {
  const TemporaryFolder folder;
  SampleResult sample;
  remove_umbra(sample.result());
  render_scene(sample.result(), folder / "picture.png", small);
  EXPECT_LT(Pixels(folder / "picture.png").close_to(viz::palette.umbra, 0.15), 200);
}

TEST(Picture, IsTheSameFromAFolder) {
  const TemporaryFolder folder;
  const SampleResult sample;
  write_shadow(sample.result(), folder / "result");
  render_scene(sample.result(), folder / "one.png", small);
  render_result(folder / "result", folder / "two.png", small);
  EXPECT_EQ(Pixels(folder / "one.png"), Pixels(folder / "two.png"));
}

TEST(Picture, ReplacesAnOlderOneAndLeavesNothingElse) {
  const TemporaryFolder folder;
  write_file(folder / "picture.png", "old");
  render_scene(SampleResult().result(), folder / "picture.png", small);
  EXPECT_EQ(Pixels(folder / "picture.png").width(), 640);
  int entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++entries;
  EXPECT_EQ(entries, 1);
}

TEST(Picture, OfPointLinearAndDirectionalLightsIsDrawn) {
  const TemporaryFolder folder;
  SampleResult sample;
  Scene scene = *sample.result().scene;
  auto& lights = std::get<SpaceScene>(scene).lights;
  lights = {{"bulb", PointLight{{0, 0, 4}}},
            {"tube", LinearLight{{-1, 1, 4}, {1, 1, 4}}},
            {"sun", DirectionalLight{{0, 0.5, -1}}}};
  sample.result().scene = &scene;
  PictureOptions options = small;
  for (const SceneLight& light : lights) {
    options.selection.light = light.name;
    render_scene(sample.result(), folder / "picture.png", options);
    EXPECT_GT(Pixels(folder / "picture.png").close_to(viz::palette.light, 0.1), 100) << light.name;
  }
}

TEST(Picture, OfThePlaneShowsRegionsLinesLightAndBlocker) {
  const TemporaryFolder folder;
  render_scene(PlanarSample().result(), folder / "picture.png", small);
  const Pixels pixels(folder / "picture.png");
  EXPECT_TRUE(pixels.border_is_white());
  EXPECT_GT(pixels.close_to(viz::palette.lit, 0.01), 10000);
  EXPECT_GT(pixels.close_to(viz::palette.umbra, 0.01), 3000);
  EXPECT_GT(pixels.close_to(viz::palette.penumbra, 0.01), 3000);
  EXPECT_GT(pixels.close_to(viz::palette.light, 0.01), 200);
  EXPECT_GT(pixels.close_to(viz::palette.blocker, 0.01), 200);
  EXPECT_GT(pixels.close_to(viz::palette.separating, 0.1), 50);
  EXPECT_GT(pixels.close_to(viz::palette.supporting, 0.1), 50);
}

TEST(Picture, OfThePlaneIsTheSameFromAFolder) {
  const TemporaryFolder folder;
  const PlanarSample sample;
  render_scene(sample.result(), folder / "scene.png", small);
  write_shadow(sample.result(), folder / "result");
  render_result(folder / "result", folder / "folder.png", small);
  EXPECT_TRUE(Pixels(folder / "scene.png") == Pixels(folder / "folder.png"));
}

TEST(Picture, SaysWhatCannotBeReadOrWritten) {
  const TemporaryFolder folder;
  const SampleResult sample;
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  EXPECT_THAT([&] { render_result(folder.path(), folder / "picture.png"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("manifest.json")));
  write_file(folder / "file", "not a folder");
  EXPECT_THAT([&] { render_scene(sample.result(), folder / "file/picture.png", small); },
              ThrowsMessage<std::runtime_error>(HasSubstr((folder / "file").string())));
  write_shadow(sample.result(), folder / "result");
  write_file(folder / "result/shadow/volumes/lamp/table/umbra.vtp", "broken");
  EXPECT_THAT([&] { render_result(folder / "result", folder / "picture.png"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("umbra.vtp")));
  EXPECT_THROW(render_scene(sample.result(), folder / "picture.png", {10, 10}), PreconditionError);
}

}  // namespace
}  // namespace gnomon
