#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// What `gnomon render` does where there is a display.
class RenderedPicture : public Program {
 protected:
  RenderedPicture() : Program(Display::shown) { write("table.scene.json", table_scene); }

  /// Width and height as the file's header states them, e.g. "800x600"; nothing if the file is no PNG.
  std::string size_of(const std::string& png) const {
    const std::string bytes = read(png);
    if (bytes.size() < 24 || bytes.substr(0, 8) != "\x89PNG\r\n\x1a\n") return {};
    const auto number = [&bytes](std::size_t start) {
      unsigned value = 0;
      for (std::size_t i = start; i < start + 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
      return std::to_string(value);
    };
    return number(16) + "x" + number(20);
  }
};

TEST_F(RenderedPicture, IsMadeOfAScene) {
  const Outcome run = gnomon("render table.scene.json --out table.png");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("table.png"));
  EXPECT_EQ(size_of("table.png"), "1280x960");
}

TEST_F(RenderedPicture, HasTheSizeAskedFor) {
  EXPECT_EQ(gnomon("render table.scene.json --out table.png --size 320x200").code, 0);
  EXPECT_EQ(size_of("table.png"), "320x200");
}

TEST_F(RenderedPicture, IsTheSameOfAScaledScene) {
  const auto scene = [](int exponent) {
    const auto corner = [&](double x, double y, double z) {
      std::string text;
      for (const double c : {x, y, z})
        text += (text.empty() ? "[" : ",") + nlohmann::json(std::ldexp(c, exponent)).dump();
      return text + "]";
    };
    const auto square = [&](double half, double z) {
      return "[" + corner(-half, -half, z) + "," + corner(half, -half, z) + "," + corner(half, half, z) + "," +
             corner(-half, half, z) + "]";
    };
    const std::string shape = R"(", "shape": "polygon", "vertices": )";
    return R"({"gnomon": 1, "dimension": 3, "lights": [{"two_sided": true, "name": "lamp)" + shape + square(1, 4) +
           R"(}], "blockers": [{"name": "table)" + shape + square(1, 2) + R"(}], "receivers": [{"name": "floor)" +
           shape + square(9, 0) + "}]}";
  };
  write("one.scene.json", scene(0));
  ASSERT_EQ(gnomon("render one.scene.json --out one.png --no-legend").code, 0);
  for (const int exponent : {-150, -40, 100}) {
    write("one.scene.json", scene(exponent));
    ASSERT_EQ(gnomon("render one.scene.json --out other.png --no-legend").code, 0);
    EXPECT_TRUE(read("one.png") == read("other.png")) << exponent;
  }
}

TEST_F(RenderedPicture, IsMadeOfCounterexamples) {
  EXPECT_EQ(gnomon("theorems --cases 10 --only F2,F3 --out found").code, 0);
  EXPECT_EQ(size_of("found/F2.png"), "1280x960");
  EXPECT_EQ(size_of("found/F3.png"), "1280x960");
}

TEST_F(RenderedPicture, IsMadeOfAFolderOfResults) {
  ASSERT_EQ(gnomon("shadow table.scene.json --out shadows --quiet").code, 0);
  const Outcome run = gnomon("render shadows --out shadows.png --quiet");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_EQ(size_of("shadows.png"), "1280x960");
}

TEST_F(RenderedPicture, OfThePlaneIsTheSameFromSceneAndFolder) {
  EXPECT_EQ(gnomon("render examples/figure_4_17.scene.json --out scene.png --size 320x240").code, 0);
  EXPECT_EQ(gnomon("shadow examples/figure_4_17.scene.json --out shadow").code, 0);
  EXPECT_EQ(gnomon("render shadow --out folder.png --size 320x240").code, 0);
  EXPECT_EQ(size_of("scene.png"), "320x240");
  EXPECT_EQ(read("scene.png"), read("folder.png"));
}

TEST_F(RenderedPicture, WarnsOfPairsThatAreNotInIt) {
  write("bent_lamp.scene.json", bent_lamp_scene);
  const Outcome run = gnomon("render bent_lamp.scene.json --out lamp.png");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("1 of 2 pairs"));
}

// Here, because some of them draw.
TEST_F(RenderedPicture, AndEveryOtherExampleInTheHelpIsTrue) {
  std::vector<std::string> commands = commands_of(gnomon("--help").out);
  commands.emplace_back();
  for (const std::string& command : commands) {
    for (const std::string& example : examples_of(gnomon(command + " --help").out)) {
      const Outcome run = gnomon(example);
      EXPECT_EQ(run.code, 0) << example << '\n' << run.err;
      EXPECT_THAT(run.out, testing::Not(IsEmpty())) << example;
    }
  }
}

TEST_F(RenderedPicture, IsMadeOnADisplayOfItsOwnWhereThereIsNone) {
  ASSERT_EQ(gnomon("render table.scene.json --out shown.png --size 320x200").code, 0);
  for (const std::string display : {"unset DISPLAY;", "DISPLAY=", "DISPLAY=:98765"}) {
    const Outcome run = shell(display + " \"$GNOMON\" render table.scene.json --out own.png --size 320x200");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(read("own.png"), read("shown.png"));
  }
}

TEST_F(RenderedPicture, ShowsTheSceneFromTheSideAskedFor) {
  std::set<std::string> pictures;
  for (const std::string camera : {"three-quarter", "front", "back", "left", "right", "top", "bottom", "9,9,9",
                                   "9,9,9,0,0,2", "9,9,9,0,0,2,1,0,0"}) {
    const Outcome run =
        gnomon("render examples/figure_4_22.scene.json --size 160x120 --out side.png --camera " + camera);
    EXPECT_EQ(run.code, 0) << camera << run.err;
    pictures.insert(read("side.png"));
  }
  EXPECT_THAT(pictures, SizeIs(10));
}

TEST_F(RenderedPicture, LeavesOutWhatIsNotWanted) {
  std::set<std::string> pictures;
  for (const std::string option : {"", "--no-legend", "--no-labels", "--no-legend --no-labels"}) {
    EXPECT_EQ(gnomon("render table.scene.json --size 320x240 --out table.png " + option).code, 0);
    pictures.insert(read("table.png"));
  }
  EXPECT_THAT(pictures, SizeIs(4));
}

TEST_F(RenderedPicture, OldOneSurvivesWhereTheNewOneCannotBeMade) {
  ASSERT_EQ(gnomon("render table.scene.json --out table.png").code, 0);
  const std::string before = read("table.png");
  write("table.scene.json", "{}");
  EXPECT_EQ(gnomon("render table.scene.json --out table.png").code, 3);
  EXPECT_EQ(read("table.png"), before);
}

}  // namespace
}  // namespace gnomon
