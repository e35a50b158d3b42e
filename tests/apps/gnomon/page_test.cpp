#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <array>
#include <set>
#include <string>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Pages in Chromium without a window. GNOMON_CHROMIUM is its name; empty where it is not installed.
class Page : public Program {
 protected:
  void SetUp() override {
    if (std::string(GNOMON_CHROMIUM).empty()) GTEST_SKIP() << "Chromium (Debian package chromium) is not installed";
  }

  /// Runs Chromium, which draws with the processor and finds no network.
  Outcome browse(const std::string& arguments) const {
    return shell("timeout 120 '" GNOMON_CHROMIUM
                 "' --headless --no-sandbox --disable-dev-shm-usage --use-gl=angle --use-angle=swiftshader "
                 "--enable-unsafe-swiftshader --host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir=\"$PWD/profile\" "
                 "--hide-scrollbars --window-size=800,600 --virtual-time-budget=5000 " +
                 arguments);
  }

  /// The page with a script of our own behind its own ones.
  void append_script(const std::string& page, const std::string& script, const std::string& with_script) const {
    std::string text = read(page);
    text.insert(text.rfind("</body>"), "<script>" + script + "</script>\n");
    write(with_script, text);
  }

  vtkSmartPointer<vtkImageData> screenshot(const std::string& page) const {
    const Outcome run = browse("--screenshot=\"$PWD/page.png\" \"file://$PWD/" + page + "\"");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(exists("page.png")) << run.err;
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path_of("page.png").c_str());
    reader->Update();
    return reader->GetOutput();
  }
};

using Rgb = std::array<int, 3>;

Rgb pixel(vtkImageData& image, int x, int y) {
  Rgb color{};
  for (int k = 0; k < 3; ++k) {
    color[static_cast<std::size_t>(k)] = static_cast<int>(image.GetScalarComponentAsDouble(x, y, 0, k));
  }
  return color;
}

/// Colours and inked pixels right of the legend and of the title.
struct Variety {
  std::set<Rgb> colors;
  int inked = 0;
};

Variety variety(vtkImageData& image) {
  Variety result;
  for (int y = 0; y < image.GetDimensions()[1]; ++y) {
    for (int x = 250; x < image.GetDimensions()[0]; ++x) {
      const Rgb color = pixel(image, x, y);
      result.colors.insert(color);
      if (color != Rgb{255, 255, 255}) ++result.inked;
    }
  }
  return result;
}

TEST_F(Page, ShowsTheSceneInABrowserWithoutANetwork) {
  ASSERT_EQ(gnomon("render examples/figure_4_22.scene.json --out page.html").code, 0);
  const Variety shown = variety(*screenshot("page.html"));
  EXPECT_GT(shown.colors.size(), 100);
  EXPECT_GT(shown.inked, 50000);
}

TEST_F(Page, OfTheCornellBoxIsSmallerThanFiveMegabytesAndIsShown) {
  ASSERT_EQ(gnomon("render examples/cornell_box.scene.json --out page.html").code, 0);
  EXPECT_LT(read("page.html").size(), 5'000'000);
  EXPECT_GT(variety(*screenshot("page.html")).colors.size(), 100);
}

TEST_F(Page, TurnsWithTheMouse) {
  ASSERT_EQ(gnomon("render examples/figure_4_22.scene.json --out page.html --no-labels").code, 0);
  append_script("page.html", R"(
    const canvas = document.getElementById("picture");
    const fire = (target, type, x) => target.dispatchEvent(new MouseEvent(type,
        {bubbles: true, button: 0, buttons: 1, clientX: x, clientY: 300}));
    fire(canvas, "mousedown", 300); fire(document, "mousemove", 450); fire(document, "mouseup", 450);)",
                "turned.html");
  const auto before = screenshot("page.html");
  const auto after = screenshot("turned.html");
  int changed = 0;
  for (int y = 0; y < 600; ++y) {
    for (int x = 250; x < 800; ++x) changed += pixel(*before, x, y) != pixel(*after, x, y) ? 1 : 0;
  }
  EXPECT_GT(changed, 20000);
  EXPECT_GT(variety(*after).colors.size(), 100);
}

TEST_F(Page, NamesThePlanesUnderTheMouse) {
  ASSERT_EQ(gnomon("render examples/figure_4_22.scene.json --out page.html").code, 0);
  append_script("page.html", R"(
    const place = document.getElementById("picture");
    const found = new Set();
    for (let x = 200; x < 700; x += 10) for (let y = 150; y < 500; y += 10) {
      place.dispatchEvent(new MouseEvent("mousemove", {bubbles: true, clientX: x, clientY: y}));
      document.getElementById("tip").textContent.split("\n").forEach(line => found.add(line));
    }
    document.body.dataset.found = Array.from(found).sort().join("; ");)",
                "hovered.html");
  const Outcome run = browse("--dump-dom \"file://$PWD/hovered.html\"");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::size_t start = run.out.find("data-found=\"");
  ASSERT_NE(start, std::string::npos);
  EXPECT_THAT(run.out.substr(start, 4000),
              AllOf(HasSubstr("umbra of board, lamp: supporting plane: edge"),
                    HasSubstr("penumbra of board, lamp: separating plane: edge"), HasSubstr("floor")));
}

TEST_F(Page, OfThePlaneIsShown) {
  ASSERT_EQ(gnomon("render examples/figure_4_17.scene.json --out page.html").code, 0);
  EXPECT_GT(variety(*screenshot("page.html")).inked, 50000);
}

}  // namespace
}  // namespace gnomon
