#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class RenderCommand : public Program {
 protected:
  RenderCommand() {
    write("table.scene.json", table_scene);
    write("bent_shelf.scene.json", bent_shelf_scene);
  }
};

TEST_F(RenderCommand, SaysWhatToInstallWhereThereIsNoDisplayAndNoneCanBeStarted) {
  const Outcome run = shell("PATH=/nowhere \"$GNOMON\" render table.scene.json --out table.png");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, AllOf(HasSubstr("display"), HasSubstr("apt-get install xvfb libgl1-mesa-dri")));
  EXPECT_FALSE(exists("table.png"));
}

TEST_F(RenderCommand, NeedsNoDisplayForDrawingsModelsAndPages) {
  for (const std::string file : {"wall.svg", "wall.gltf", "wall.html"}) {
    const Outcome run = gnomon("render examples/figure_4_17.scene.json --out " + file);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(exists(file));
  }
  EXPECT_EQ(gnomon("render table.scene.json --out table.gltf").code, 0);
  const auto model = read_json("table.gltf");
  EXPECT_EQ(model.at("asset").at("version"), "2.0");
  EXPECT_GT(model.at("meshes").size(), 4);
}

TEST_F(RenderCommand, MakesModelsInMetresWithYUp) {
  const auto root = [&](const std::string& words) {
    write("box.scene.json", R"({"gnomon": 1, "dimension": 3, )" + words + R"( "lights": [{"name": "bulb",
      "shape": "point", "position": [0,0,4]}], "blockers": [{"name": "table", "shape": "polygon",
      "vertices": [[-1,-1,2], [1,-1,2], [1,1,2], [-1,1,2]]}]})");
    EXPECT_EQ(gnomon("render box.scene.json --out box.gltf --box -4,-4,-6,4,4,10").code, 0);
    return read_json("box.gltf").at("nodes")[0];
  };
  const auto metres = root("");
  EXPECT_EQ(metres.at("translation"), nlohmann::json({0, 2, 0}));
  EXPECT_TRUE(metres.contains("rotation"));
  EXPECT_FALSE(metres.contains("scale"));
  const auto millimetres = root(R"("length_unit": "mm", "up": "y",)");
  EXPECT_EQ(millimetres.at("translation"), nlohmann::json({0, 0, 0.002}));
  EXPECT_EQ(millimetres.at("scale"), nlohmann::json({0.001, 0.001, 0.001}));
  EXPECT_FALSE(millimetres.contains("rotation"));
}

TEST_F(RenderCommand, DrawsAFolderAsItDrawsItsScene) {
  for (const std::string scene : {"figure_4_17", "figure_4_22"}) {
    ASSERT_EQ(gnomon("shadow examples/" + scene + ".scene.json --out shadow --quiet").code, 0);
    ASSERT_EQ(gnomon("render shadow --out folder.gltf").code, 0);
    ASSERT_EQ(gnomon("render examples/" + scene + ".scene.json --out scene.gltf").code, 0);
    EXPECT_EQ(read("folder.gltf"), read("scene.gltf")) << scene;
  }
}

TEST_F(RenderCommand, RefusesAnEndingThatIsNoFormat) {
  for (const std::string file : {"picture", "picture.jpg", "picture.png.txt", "png"}) {
    const Outcome run = gnomon("render table.scene.json --out " + file);
    EXPECT_EQ(run.code, 2) << file;
    EXPECT_THAT(run.err, AllOf(HasSubstr("--out " + file), HasSubstr(".png, .svg"))) << file;
  }
}

TEST_F(RenderCommand, TakesEndingsInCapitals) {
  EXPECT_EQ(gnomon("render table.scene.json --out picture.GLTF").code, 0);
  EXPECT_TRUE(nlohmann::json::accept(read("picture.GLTF")));
}

TEST_F(RenderCommand, EndsWith4ForALineDrawingOfSpace) {
  const Outcome run = gnomon("render table.scene.json --out table.svg");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, AllOf(HasSubstr("table.scene.json"), HasSubstr(".svg")));
  ASSERT_EQ(gnomon("shadow table.scene.json --out shadows --quiet").code, 0);
  EXPECT_EQ(gnomon("render shadows --out table.svg").code, 4);
}

TEST_F(RenderCommand, RefusesACameraThatIsNone) {
  for (const std::string camera : {"above", "1,2", "1,2,3,4", "1,2,nan", "1,2,x", "''", "1,2,3,"}) {
    const Outcome run = gnomon("render table.scene.json --out table.gltf --camera " + camera);
    EXPECT_EQ(run.code, 2) << camera;
    EXPECT_THAT(run.err, HasSubstr("--camera")) << camera;
  }
}

TEST_F(RenderCommand, RefusesACameraThatSeesNothing) {
  for (const std::string camera : {"0,0,9,0,0,9", "0,0,9,0,0,0,0,0,1"}) {
    const Outcome run = gnomon("render table.scene.json --out table.html --camera " + camera);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("--camera " + camera)) << run.err;
  }
}

TEST_F(RenderCommand, RefusesACameraForAScenesOfThePlane) {
  EXPECT_EQ(gnomon("render examples/figure_4_17.scene.json --out wall.svg --camera top").code, 2);
}

TEST_F(RenderCommand, NeedsASceneAndAFileForThePicture) {
  EXPECT_EQ(gnomon("render").code, 2);
  EXPECT_EQ(gnomon("render table.scene.json").code, 2);
  EXPECT_EQ(gnomon("render --out table.png").code, 2);
}

TEST_F(RenderCommand, RefusesASizeThatIsNone) {
  for (const std::string size :
       {"800", "800x", "x600", "800x600x3", "0x0", "-800x600", "800x1e3", "99999x99999", "''"}) {
    const Outcome run = gnomon("render table.scene.json --out table.png --size " + size);
    EXPECT_EQ(run.code, 2) << size;
    EXPECT_THAT(run.err, HasSubstr("--size")) << size;
  }
}

TEST_F(RenderCommand, EndsWith3ForAMissingSceneOrAFolderWithoutAResult) {
  EXPECT_EQ(gnomon("render missing.scene.json --out picture.png").code, 3);
  const Outcome run = gnomon("render examples --out picture.png");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("manifest.json"));
}

TEST_F(RenderCommand, EndsWith4WhereNoPairIsSupported) {
  EXPECT_EQ(gnomon("render bent_shelf.scene.json --out shelf.png").code, 4);
}

TEST_F(RenderCommand, RefusesToChooseWhatIsComputedOfAFinishedResult) {
  ASSERT_EQ(gnomon("shadow table.scene.json --out shadows --quiet").code, 0);
  for (const std::string option : {"--box 0,0,0,1,1,1", "--blocker table"}) {
    const Outcome run = gnomon("render shadows --out shadows.gltf " + option);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("--blocker"));
  }
}

TEST_F(RenderCommand, NamesTheLightsAndReceiversThereAreWhereAnotherIsAskedFor) {
  ASSERT_EQ(gnomon("shadow examples/figure_4_22.scene.json --out shadows --quiet").code, 0);
  for (const std::string drawn : {"shadows", "examples/figure_4_22.scene.json"}) {
    const Outcome light = gnomon("render " + drawn + " --light sun --out a.gltf");
    EXPECT_EQ(light.code, 2);
    EXPECT_THAT(light.err, AllOf(HasSubstr("--light"), HasSubstr("'sun'"), HasSubstr("'lamp'")));
    const Outcome receiver = gnomon("render " + drawn + " --receiver wall --out a.gltf");
    EXPECT_EQ(receiver.code, 2);
    EXPECT_THAT(receiver.err, AllOf(HasSubstr("--receiver"), HasSubstr("'wall'"), HasSubstr("'floor'")));
    EXPECT_EQ(gnomon("render " + drawn + " --light lamp --receiver floor --out a.gltf").code, 0);
  }
}

TEST_F(RenderCommand, ColoursReceiversByIrradianceOnRequest) {
  ASSERT_EQ(gnomon("render examples/figure_4_22.scene.json --out a.html --colour irradiance").code, 0);
  const std::string page = read("a.html");
  EXPECT_THAT(page, AllOf(HasSubstr("irradiance on floor"), HasSubstr("irradiance 0.03 W/m²")));
  EXPECT_THAT(page, testing::Not(HasSubstr("umbra volume"))) << "which would change the colours";
  ASSERT_EQ(gnomon("render examples/figure_4_22.scene.json --out a.html --colour irradiance --volumes").code, 0);
  EXPECT_THAT(read("a.html"), HasSubstr("umbra volume"));
  ASSERT_EQ(gnomon("render examples/figure_4_22.scene.json --out a.html --colour region").code, 0);
  EXPECT_THAT(read("a.html"), testing::Not(HasSubstr("irradiance on floor")));
  const Outcome none = gnomon("render table.scene.json --out a.html --colour irradiance");
  EXPECT_EQ(none.code, 0);
  EXPECT_THAT(none.err, HasSubstr("shows no irradiance"));
}

TEST_F(RenderCommand, SaysWhatItCannotColourByIrradiance) {
  EXPECT_EQ(gnomon("render table.scene.json --out a.html --colour heat").code, 2);
  const auto refusal = [&](const std::string& words) {
    const Outcome run = gnomon("render " + words + " --colour irradiance");
    EXPECT_EQ(run.code, 4) << words;
    return run.err;
  };
  ASSERT_EQ(gnomon("shadow examples/figure_4_22.scene.json --out shadows --quiet").code, 0);
  EXPECT_THAT(refusal("shadows --out a.html"), HasSubstr("give the scene file"));
  EXPECT_THAT(refusal("examples/figure_4_22.scene.json --out a.gltf"), HasSubstr(".gltf"));
  EXPECT_THAT(refusal("examples/figure_4_17.scene.json --out a.svg"), HasSubstr("dimension 2"));
}

TEST_F(RenderCommand, RefusesAnUpThatIsNoneOrHasNoMeaning) {
  EXPECT_EQ(gnomon("render table.scene.json --up y --out table.gltf").code, 0);
  for (const std::string wrong :
       {"table.scene.json --up x", "table.scene.json --up Z", "examples/figure_4_17.scene.json --up z"}) {
    const Outcome run = gnomon("render " + wrong + " --out a.gltf");
    EXPECT_EQ(run.code, 2) << wrong;
    EXPECT_THAT(run.err, HasSubstr("--up")) << wrong;
  }
  EXPECT_EQ(gnomon("render examples/figure_4_17.scene.json --volumes --out a.gltf").code, 2);
}

TEST_F(RenderCommand, ShowsOneLightAndOnAPageAll) {
  const auto nodes = [&](const std::string& options) {
    EXPECT_EQ(gnomon("render examples/two_lamps.scene.json --out lamps.gltf " + options).code, 0);
    const nlohmann::json document = read_json("lamps.gltf");
    std::vector<std::string> names;
    for (const auto& node : document.at("nodes")) names.push_back(node.at("name"));
    return names;
  };
  using testing::Contains;
  using testing::Not;
  EXPECT_THAT(nodes(""), AllOf(Contains("scene/lights/left"), Not(Contains(HasSubstr("right")))));
  EXPECT_THAT(nodes("--light right"), AllOf(Contains("scene/lights/right"), Not(Contains(HasSubstr("left")))));
  EXPECT_EQ(gnomon("render examples/two_lamps.scene.json --out lamps.html").code, 0);
  EXPECT_THAT(read("lamps.html"), HasSubstr("\"lights\":[\"left\",\"right\"]"));
}

TEST_F(RenderCommand, DrawsVolumesOfPartsOnlyWhereTheyAreAskedFor) {
  const std::string scene = "examples/letter_block.scene.json";
  EXPECT_EQ(gnomon("render " + scene + " --out block.gltf").code, 0);
  EXPECT_THAT(read("block.gltf"), AllOf(HasSubstr("\"receivers/"), testing::Not(HasSubstr("\"volumes/"))));
  EXPECT_EQ(gnomon("render " + scene + " --volumes --out block.gltf").code, 0);
  EXPECT_THAT(read("block.gltf"), HasSubstr("\"volumes/"));
}

TEST_F(RenderCommand, WarnsOfReceiversThatAreNotDividedAndDrawsThemAsNone) {
  write("bent.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4.000000000001]]}],
    "blockers": [{"name": "table", "shape": "polygon", "vertices": [[-2,-2,2], [2,-2,2], [2,2,2], [-2,2,2]]}],
    "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-9,-9,0], [9,-9,0], [9,9,0], [-9,9,0]]}]})");
  const Outcome run = gnomon("render bent.scene.json --out bent.gltf");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, AllOf(HasSubstr("receivers are not divided"), HasSubstr("not exactly coplanar")));
  EXPECT_THAT(read("bent.gltf"), testing::Not(HasSubstr("\"receivers/")));
}

}  // namespace
}  // namespace gnomon
